package dct.core.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.SegmentPoints.Place;
import java.math.BigDecimal;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class SegmentPointsTest {

  @Test
  void wholeCoordinatesAlwaysHaveAPointNearEveryPlace() {
    check(11, random -> () -> random.nextInt(2001) - 1000.0, 1);
  }

  @Test
  void tenthsHaveOneOrNone() {
    check(12, random -> () -> random.nextInt(20_001) / 10.0, 0);
  }

  @Test
  void arbitraryDoublesHaveOneOrNone() {
    check(13, random -> () -> random.nextDouble() * 1000 - 500, 0);
  }

  @ParameterizedTest
  @CsvSource({"-1074", "-1022", "-500", "500", "1000"})
  void scaleIsNoTrouble(int exponent) {
    Random random = new Random(exponent);
    for (int i = 0; i < 200; i++) {
      double[] p = new double[4];
      for (int j = 0; j < 4; j++) {
        p[j] = Math.scalb(2.0 * random.nextInt(5000), exponent);
      }
      if (p[0] != p[2] || p[1] != p[3]) {
        Optional<Place> place = SegmentPoints.near(p[0], p[1], p[2], p[3], 0.3, 0);
        assertThat(place).as("%d", i).isPresent(); // the middle if no other
        requireInside(place.get(), p);
      }
    }
  }

  private interface Coordinates {
    DoubleSupplier of(Random random);
  }

  private static void check(long seed, Coordinates coordinates, double share) {
    Random random = new Random(seed);
    DoubleSupplier next = coordinates.of(random);
    int found = 0;
    int tried = 3000;
    for (int i = 0; i < tried; i++) {
      double[] p = {
        next.getAsDouble(), next.getAsDouble(), next.getAsDouble() + 1, next.getAsDouble()
      };
      double t = random.nextDouble();
      double within = i % 3 == 0 ? 0 : Math.scalb(1.0, random.nextInt(4) - 1);
      if (p[0] == p[2] && p[1] == p[3]) {
        continue;
      }
      Optional<Place> place = SegmentPoints.near(p[0], p[1], p[2], p[3], t, within);
      place.ifPresent(at -> requireInside(at, p));
      found += place.isPresent() ? 1 : 0;
    }
    assertThat(found).as("seed %d", seed).isGreaterThanOrEqualTo((int) (share * tried * 0.99));
    assertThat(found).as("seed %d", seed).isPositive();
  }

  private static void requireInside(Place at, double... p) {
    BigDecimal cross =
        minus(p[2], p[0])
            .multiply(minus(at.y(), p[1]))
            .subtract(minus(p[3], p[1]).multiply(minus(at.x(), p[0])));
    assertThat(cross.signum()).isZero();
    assertThat(Predicates.orient(p[0], p[1], p[2], p[3], at.x(), at.y())).isZero();
    BigDecimal along =
        minus(at.x(), p[0])
            .multiply(minus(at.x(), p[2]))
            .add(minus(at.y(), p[1]).multiply(minus(at.y(), p[3])));
    assertThat(along.signum()).as("strictly between the ends").isNegative();
  }

  private static BigDecimal minus(double a, double b) {
    return new BigDecimal(a).subtract(new BigDecimal(b));
  }

  /** Every a + (b − a) k / 2ᵐ that doubles hold is matched by a place that is as near or nearer. */
  @ParameterizedTest
  @ValueSource(longs = {21, 22, 23})
  void nothingNearerIsExact(long seed) {
    Random random = new Random(seed);
    int compared = 0;
    for (int i = 0; i < 2000; i++) {
      double ax = 512 + bits(random);
      double ay = 512 + bits(random);
      double bx = 512 + bits(random);
      double by = 512 + bits(random);
      if (ax == bx || ay == by) {
        continue;
      }
      double t = random.nextDouble();
      double least = leastDistance(ax, ay, bx, by, t);
      Optional<Place> place = SegmentPoints.near(ax, ay, bx, by, t, 0);
      if (least < Double.POSITIVE_INFINITY) {
        compared++;
        double x = ax + t * (bx - ax);
        assertThat(place).as("seed %d, %d", seed, i).isPresent();
        assertThat(Math.abs(place.get().x() - x)).isLessThanOrEqualTo(least + 1e-9);
      }
    }
    assertThat(compared).isGreaterThan(500);
  }

  /** All in one binade, with few or many digits. */
  private static double bits(Random random) {
    return Math.scalb((double) random.nextInt(1 << 20), random.nextInt(20) - 31) % 512;
  }

  private static double leastDistance(double ax, double ay, double bx, double by, double t) {
    double least = Double.POSITIVE_INFINITY;
    for (int k = 1; k < 64; k++) {
      BigDecimal part = BigDecimal.valueOf(k).divide(BigDecimal.valueOf(64));
      BigDecimal x = new BigDecimal(ax).add(minus(bx, ax).multiply(part));
      BigDecimal y = new BigDecimal(ay).add(minus(by, ay).multiply(part));
      if (new BigDecimal(x.doubleValue()).compareTo(x) == 0
          && new BigDecimal(y.doubleValue()).compareTo(y) == 0) {
        least = Math.min(least, Math.abs(x.doubleValue() - (ax + t * (bx - ax))));
      }
    }
    return least;
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0, 300, 300, 0.41, 1, 123, 123",
    "300, 400, 100, 100, 0.5, 2, 200, 250",
    "0, 0, 4, 6, 0.3, 2, 2, 3",
    "0, 0, 3, 1, 0.5, 0.25, 1.5, 0.5",
    "0, 0, 5, 0, 0.5, 1, 2, 0"
  })
  void coordinatesHaveFewDigits(
      double ax, double ay, double bx, double by, double t, double within, double x, double y) {
    assertThat(SegmentPoints.near(ax, ay, bx, by, t, within)).contains(new Place(x, y));
  }

  @Test
  void neighbouringDoublesHaveNoneBetweenThem() {
    double up = Math.nextUp(1.0);
    assertThat(SegmentPoints.near(1, 1, up, up, 0.5, 0)).isEmpty();
  }
}
