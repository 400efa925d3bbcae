package dct.core.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Predicates.Stage;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.DoubleSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The predicates against decimal arithmetic, or against long integers where the coordinates are
 * small whole numbers; and which stage decided.
 *
 * <pre>
 * double ulp = Math.ulp(1.0);
 * Predicates.orient(0, 0, 1, 1, 2, 2); // 0: on one line
 * Predicates.orient(0, 0, 1, 1, 2, 2 + 2 * ulp); // 1: to the left, by one ulp
 * Predicates.inCircle(1, 0, 0, 1, -1, 0, 0, -1); // 0: on one circle
 * Predicates.inCircle(1, 0, 0, 1, -1, 0, 0, 0); // 1: inside
 * </pre>
 */
class PredicatesTest {
  private static final double ULP = 0x1p-52;

  /** Coordinates that are hard in different ways. */
  enum Hard {
    ULPS_AT_ONE(100_000) {
      @Override
      double next(Random r) {
        return 1 + r.nextInt(8) * ULP;
      }
    },
    ULPS_ABOUT_ONE_AND_TWELVE(100_000) {
      @Override
      double next(Random r) {
        return r.nextInt(3) * 11.5 + 0.5 + r.nextInt(4) * ULP;
      }
    },
    TENTHS(100_000) {
      @Override
      double next(Random r) {
        return r.nextInt(12) * 0.1;
      }
    },
    UNIFORM(50_000) {
      @Override
      double next(Random r) {
        return r.nextDouble();
      }
    },
    HUGE(10_000) {
      @Override
      double next(Random r) {
        return (r.nextInt(5) - 2) * 0x1p1021 + r.nextInt(3) * 0x1p969;
      }
    },
    LARGEST(10_000) {
      @Override
      double next(Random r) {
        return r.nextInt(3) == 0 ? r.nextInt(4) : (r.nextInt(3) - 1) * Double.MAX_VALUE;
      }
    },
    DENORMAL(8_000) {
      @Override
      double next(Random r) {
        return (r.nextInt(9) - 4) * Double.MIN_VALUE;
      }
    },
    BARELY_NORMAL(8_000) {
      @Override
      double next(Random r) {
        return Double.MIN_NORMAL * (1 + r.nextInt(4) * ULP) * (r.nextInt(3) - 1);
      }
    },
    SQUARES_THAT_UNDERFLOW(4_000) {
      @Override
      double next(Random r) {
        return r.nextInt(200) * 0x1p-540;
      }
    },
    SQUARES_THAT_OVERFLOW(4_000) {
      @Override
      double next(Random r) {
        return r.nextInt(200) * 0x1p508;
      }
    },
    FOURTH_POWERS_THAT_UNDERFLOW(4_000) {
      @Override
      double next(Random r) {
        return r.nextInt(12) * 0x1p-271;
      }
    },
    FOURTH_POWERS_THAT_OVERFLOW(4_000) {
      @Override
      double next(Random r) {
        return r.nextInt(200) * 0x1p250;
      }
    },
    AT_THE_EXPANSION_LIMITS(20_000) {
      @Override
      double next(Random r) {
        double limit = r.nextBoolean() ? 0x1p-200 : 0x1p200;
        return limit * (r.nextInt(3) - 1) * (1 + (r.nextInt(5) - 2) * ULP);
      }
    },
    ABOUT_TWELVE_BITS(100_000) {
      @Override
      double next(Random r) {
        int[] near = {0, 1, 2047, 2048, 4095, 4096, 4097, 8191};
        return near[r.nextInt(near.length)] * 0x1p-30;
      }
    },
    WIDE(10_000) {
      @Override
      double next(Random r) {
        return r.nextGaussian() * Math.scalb(1.0, r.nextInt(2000) - 1000);
      }
    },
    TWO_SCALES(50_000) {
      @Override
      double next(Random r) {
        return r.nextInt(4) + r.nextInt(3) * 0x1p-50 + r.nextInt(3) * 0x1p-300;
      }
    };

    final int cases;

    Hard(int cases) {
      this.cases = cases;
    }

    abstract double next(Random r);
  }

  @ParameterizedTest
  @EnumSource
  void orientAgreesWithDecimals(Hard hard) {
    Random random = new Random(1);
    for (int k = 0; k < hard.cases; k++) {
      double[] v = draw(6, () -> hard.next(random));
      int sign = Predicates.orient(v[0], v[1], v[2], v[3], v[4], v[5]);
      if (sign != decimalOrient(v)) {
        assertThat(sign).as("orient %s", Arrays.toString(v)).isEqualTo(decimalOrient(v));
      }
    }
  }

  @ParameterizedTest
  @EnumSource
  void inCircleAgreesWithDecimals(Hard hard) {
    Random random = new Random(2);
    for (int k = 0; k < hard.cases / 4; k++) {
      double[] v = draw(8, () -> hard.next(random));
      int sign = Predicates.inCircle(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]);
      if (sign != decimalInCircle(v)) {
        assertThat(sign).as("inCircle %s", Arrays.toString(v)).isEqualTo(decimalInCircle(v));
      }
    }
  }

  /** c is the double nearest to a random place on the line ab, or an ulp beside it. */
  @Test
  void orientIsRightOneUlpFromALine() {
    Random random = new Random(3);
    for (int k = 0; k < 300_000; k++) {
      double[] v = draw(6, random::nextDouble);
      double t = 2 * random.nextDouble() - 0.5;
      v[4] = nudged(v[0] + t * (v[2] - v[0]), random);
      v[5] = nudged(v[1] + t * (v[3] - v[1]), random);
      int sign = Predicates.orient(v[0], v[1], v[2], v[3], v[4], v[5]);
      if (sign != decimalOrient(v)) {
        assertThat(sign).as("orient %s", Arrays.toString(v)).isEqualTo(decimalOrient(v));
      }
    }
  }

  /** Four points of one circle, rounded, and an ulp beside it. */
  @Test
  void inCircleIsRightOneUlpFromACircle() {
    Random random = new Random(4);
    for (int k = 0; k < 60_000; k++) {
      double[] v = new double[8];
      double x = k % 3;
      for (int i = 0; i < 4; i++) {
        double angle = 2 * Math.PI * random.nextDouble();
        v[2 * i] = nudged(x + Math.cos(angle), random);
        v[2 * i + 1] = nudged(Math.sin(angle), random);
      }
      int sign = Predicates.inCircle(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]);
      if (sign != decimalInCircle(v)) {
        assertThat(sign).as("inCircle %s", Arrays.toString(v)).isEqualTo(decimalInCircle(v));
      }
    }
  }

  private static double nudged(double value, Random random) {
    return switch (random.nextInt(3)) {
      case 0 -> Math.nextUp(value);
      case 1 -> Math.nextDown(value);
      default -> value;
    };
  }

  @Test
  void orientIsRightOnGridsOfWholeNumbers() {
    Random random = new Random(5);
    for (int k = 0; k < 2_000_000; k++) {
      double[] v = whole(6, random, k % 2 == 0 ? 4 : 1 << 20);
      int sign = Predicates.orient(v[0], v[1], v[2], v[3], v[4], v[5]);
      if (sign != longOrient(v)) {
        assertThat(sign).as("orient %s", Arrays.toString(v)).isEqualTo(longOrient(v));
      }
    }
  }

  @Test
  void inCircleIsRightOnGridsOfWholeNumbers() {
    Random random = new Random(6);
    for (int k = 0; k < 2_000_000; k++) {
      double[] v = whole(8, random, k % 2 == 0 ? 4 : 2000);
      int sign = Predicates.inCircle(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]);
      if (sign != longInCircle(v)) {
        assertThat(sign).as("inCircle %s", Arrays.toString(v)).isEqualTo(longInCircle(v));
      }
    }
  }

  /** Circles with many whole points, from small ones to those whose fourth powers are rounded. */
  @ParameterizedTest
  @ValueSource(ints = {5, 65, 325, 1105, 5525, 32_045, 1_185_665})
  void inCircleIsZeroOnAWholeCircle(int radius) {
    List<double[]> circle = wholePoints(radius);
    Random random = new Random(10);
    for (int k = 0; k < 20_000; k++) {
      double[] a = circle.get(random.nextInt(circle.size()));
      double[] b = circle.get(random.nextInt(circle.size()));
      double[] c = circle.get(random.nextInt(circle.size()));
      double[] d = circle.get(random.nextInt(circle.size()));
      assertThat(Predicates.inCircle(a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1])).isZero();
    }
  }

  private static List<double[]> wholePoints(int radius) {
    List<double[]> points = new ArrayList<>();
    for (long x = -radius; x <= radius; x++) {
      long y = Math.round(Math.sqrt((double) radius * radius - x * x));
      if (x * x + y * y == (long) radius * radius) {
        points.add(new double[] {x, y});
        points.add(new double[] {x, -y});
      }
    }
    return points;
  }

  @Test
  void theMeaningOfTheSigns() {
    assertThat(Predicates.orient(0, 0, 1, 0, 0, 1)).isEqualTo(1);
    assertThat(Predicates.orient(0, 0, 0, 1, 1, 0)).isEqualTo(-1);
    assertThat(Predicates.inCircle(0, 0, 2, 0, 0, 2, 1, 1)).isEqualTo(1);
    assertThat(Predicates.inCircle(0, 0, 2, 0, 0, 2, 2, 2)).isZero();
    assertThat(Predicates.inCircle(0, 0, 2, 0, 0, 2, 3, 3)).isEqualTo(-1);
  }

  @Test
  void theFilterDecidesNearlyAllOfTheEasyCases() {
    Map<Stage, Integer> orient = orientStages(Hard.UNIFORM);
    Map<Stage, Integer> inCircle = inCircleStages(Hard.UNIFORM);
    assertThat(orient.get(Stage.FILTER)).isGreaterThan(9_990);
    assertThat(inCircle.get(Stage.FILTER)).isGreaterThan(9_990);
    assertThat(orient).doesNotContainKey(Stage.BIG_DECIMAL);
    assertThat(inCircle).doesNotContainKey(Stage.BIG_DECIMAL);
  }

  @Test
  void nothingIsRoundedOnALattice() {
    assertThat(orientStages(Hard.ULPS_AT_ONE)).containsOnlyKeys(Stage.FILTER, Stage.UNROUNDED);
    assertThat(inCircleStages(Hard.ULPS_AT_ONE)).containsOnlyKeys(Stage.FILTER, Stage.UNROUNDED);
  }

  @Test
  void twiceTheDigitsDecideOnACircle() {
    Random random = new Random(9);
    Map<Stage, Integer> stages = new EnumMap<>(Stage.class);
    for (int k = 0; k < 10_000; k++) {
      double[] v = new double[8];
      for (int i = 0; i < 4; i++) {
        double angle = 2 * Math.PI * random.nextDouble();
        v[2 * i] = Math.cos(angle);
        v[2 * i + 1] = Math.sin(angle);
      }
      stages.merge(inCircleStage(v), 1, Integer::sum);
    }
    assertThat(stages.get(Stage.TWOFOLD)).isGreaterThan(5_000);
    assertThat(stages).containsOnlyKeys(Stage.FILTER, Stage.TWOFOLD);
  }

  @Test
  void theExpansionDecidesCloseCases() {
    assertThat(orientStages(Hard.TENTHS)).containsKeys(Stage.EXPANSION);
    assertThat(inCircleStages(Hard.TENTHS)).containsKeys(Stage.EXPANSION);
    assertThat(orientStages(Hard.TENTHS)).doesNotContainKey(Stage.BIG_DECIMAL);
    assertThat(inCircleStages(Hard.TENTHS)).doesNotContainKey(Stage.BIG_DECIMAL);
  }

  @Test
  void decimalsDecideExtremeExponents() {
    for (Hard hard : new Hard[] {Hard.HUGE, Hard.LARGEST, Hard.DENORMAL, Hard.BARELY_NORMAL}) {
      assertThat(orientStages(hard)).as("%s", hard).containsKey(Stage.BIG_DECIMAL);
      assertThat(inCircleStages(hard)).as("%s", hard).containsKey(Stage.BIG_DECIMAL);
    }
  }

  @Test
  void everyStageDecidesSome(TestReporter reporter) {
    Map<Stage, Integer> orient = new EnumMap<>(Stage.class);
    Map<Stage, Integer> inCircle = new EnumMap<>(Stage.class);
    for (Hard hard : Hard.values()) {
      Map<Stage, Integer> o = orientStages(hard);
      Map<Stage, Integer> c = inCircleStages(hard);
      reporter.publishEntry(hard.name(), "orient " + o + ", inCircle " + c);
      o.forEach((stage, count) -> orient.merge(stage, count, Integer::sum));
      c.forEach((stage, count) -> inCircle.merge(stage, count, Integer::sum));
    }
    assertThat(orient)
        .containsOnlyKeys(Stage.FILTER, Stage.UNROUNDED, Stage.EXPANSION, Stage.BIG_DECIMAL);
    assertThat(inCircle).containsOnlyKeys(Stage.values());
  }

  private static Map<Stage, Integer> orientStages(Hard hard) {
    Random random = new Random(7);
    Map<Stage, Integer> stages = new EnumMap<>(Stage.class);
    for (int k = 0; k < 10_000; k++) {
      double[] v = draw(6, () -> hard.next(random));
      stages.merge(Predicates.orientStage(v[0], v[1], v[2], v[3], v[4], v[5]), 1, Integer::sum);
    }
    return stages;
  }

  private static Map<Stage, Integer> inCircleStages(Hard hard) {
    Random random = new Random(8);
    Map<Stage, Integer> stages = new EnumMap<>(Stage.class);
    for (int k = 0; k < 10_000; k++) {
      double[] v = draw(8, () -> hard.next(random));
      stages.merge(inCircleStage(v), 1, Integer::sum);
    }
    return stages;
  }

  private static Stage inCircleStage(double[] v) {
    return Predicates.inCircleStage(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]);
  }

  private static double[] draw(int count, DoubleSupplier next) {
    double[] v = new double[count];
    for (int i = 0; i < count; i++) {
      v[i] = next.getAsDouble();
    }
    return v;
  }

  private static double[] whole(int count, Random random, int range) {
    double[] v = new double[count];
    for (int i = 0; i < count; i++) {
      v[i] = random.nextInt(range);
    }
    return v;
  }

  private static int decimalOrient(double[] v) {
    BigDecimal[] d = decimals(v);
    BigDecimal left = d[2].subtract(d[0]).multiply(d[5].subtract(d[1]));
    BigDecimal right = d[3].subtract(d[1]).multiply(d[4].subtract(d[0]));
    return left.compareTo(right);
  }

  /** The 4 × 4 determinant with rows (x, y, x² + y², 1), by its last column. */
  private static int decimalInCircle(double[] v) {
    BigDecimal[] d = decimals(v);
    BigDecimal sum = BigDecimal.ZERO;
    for (int i = 0; i < 3; i++) {
      int j = 2 * ((i + 1) % 3);
      int k = 2 * ((i + 2) % 3);
      BigDecimal x = d[2 * i].subtract(d[6]);
      BigDecimal y = d[2 * i + 1].subtract(d[7]);
      BigDecimal minor =
          d[j].subtract(d[6])
              .multiply(d[k + 1].subtract(d[7]))
              .subtract(d[j + 1].subtract(d[7]).multiply(d[k].subtract(d[6])));
      sum = sum.add(x.multiply(x).add(y.multiply(y)).multiply(minor));
    }
    return sum.signum();
  }

  private static BigDecimal[] decimals(double[] v) {
    BigDecimal[] d = new BigDecimal[v.length];
    for (int i = 0; i < v.length; i++) {
      d[i] = new BigDecimal(v[i]);
    }
    return d;
  }

  private static int longOrient(double[] doubles) {
    long[] v = longs(doubles);
    long det = (v[2] - v[0]) * (v[5] - v[1]) - (v[3] - v[1]) * (v[4] - v[0]);
    return Long.signum(det);
  }

  private static int longInCircle(double[] doubles) {
    long[] v = longs(doubles);
    long sum = 0;
    for (int i = 0; i < 3; i++) {
      int j = 2 * ((i + 1) % 3);
      int k = 2 * ((i + 2) % 3);
      long x = v[2 * i] - v[6];
      long y = v[2 * i + 1] - v[7];
      long minor = (v[j] - v[6]) * (v[k + 1] - v[7]) - (v[j + 1] - v[7]) * (v[k] - v[6]);
      sum += (x * x + y * y) * minor;
    }
    return Long.signum(sum);
  }

  private static long[] longs(double[] wholeNumbers) {
    long[] v = new long[wholeNumbers.length];
    for (int i = 0; i < v.length; i++) {
      v[i] = (long) wholeNumbers[i];
    }
    return v;
  }
}
