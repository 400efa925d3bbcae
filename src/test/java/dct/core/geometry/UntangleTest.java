package dct.core.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.geometry.Defect.Kind;
import dct.testing.CancelledAfter;
import dct.testing.RandomPolygons;
import java.util.Arrays;
import java.util.Locale;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Boundaries of every kind become simple, and keep their vertices.
 *
 * <pre>
 * Points bowTie = Points.ofPairs(0, 0, 4, 4, 4, 0, 0, 4);
 * Untangle.order(bowTie, Progress.NONE); // 0, 2, 1, 3
 * </pre>
 */
class UntangleTest {

  @Test
  void aBowTieBecomesASquare() {
    Points bowTie = Points.ofPairs(0, 0, 4, 4, 4, 0, 0, 4);
    assertThat(Untangle.order(bowTie, Progress.NONE)).containsExactly(0, 2, 1, 3);
  }

  @Test
  void aSimplePolygonStaysAsItIs() {
    for (RandomPolygons.Family family : RandomPolygons.families()) {
      Points polygon = family.make(40, 7);
      assertThat(Untangle.order(polygon, Progress.NONE))
          .isEqualTo(IntStream.range(0, polygon.size()).toArray());
    }
  }

  /** On small grids edges touch, overlap and turn back along themselves in every way. */
  @ParameterizedTest
  @CsvSource({"2, 4", "3, 5", "3, 7", "3, 9", "4, 6", "4, 12", "5, 20", "6, 8", "1000, 6"})
  void pointsOfAGridInAnyOrderBecomeSimple(int range, int n) {
    for (int seed = 0; seed < 700; seed++) {
      Points points = distinct(range, n, seed);
      String name = String.format(Locale.ROOT, "range %d, n %d, seed %d", range, n, seed);
      boolean flat = isKind(points, Kind.COLLINEAR);
      if (!flat) {
        requireSimple(points, name);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 1e-300, 1e300, 1e160})
  void randomPointsOfEveryScaleBecomeSimple(double scale) {
    Random random = new Random(5);
    double[] pairs = random.doubles(600, -scale, scale).toArray();
    requireSimple(Points.ofPairs(pairs), "scale " + scale);
  }

  /** A long thin comb whose every edge passes through many others. */
  @Test
  void aZigzagDrawnInTheWrongOrderBecomesSimple() {
    double[] pairs = new double[1_200];
    for (int i = 0; i < 600; i++) {
      pairs[2 * i] = (i * 251) % 600;
      pairs[2 * i + 1] = i % 3;
    }
    requireSimple(Points.ofPairs(pairs), "zigzag");
  }

  @Test
  void withoutAnOrderThatIsSimpleItSaysWhy() {
    requireRefused(Kind.TOO_FEW, 0, 0, 1, 1);
    requireRefused(Kind.COLLINEAR, 0, 0, 1, 1, 3, 3, 2, 2);
    requireRefused(Kind.DUPLICATE, 0, 0, 4, 4, 4, 0, 0, 4, 4, 4);
  }

  @Test
  void aCancelEndsIt() {
    Points points = Points.ofPairs(new Random(1).doubles(2_000).toArray());
    assertThatThrownBy(() -> Untangle.order(points, new CancelledAfter(20)))
        .isInstanceOf(CancellationException.class);
  }

  private static void requireRefused(Kind kind, double... pairs) {
    assertThatThrownBy(() -> Untangle.order(Points.ofPairs(pairs), Progress.NONE))
        .isInstanceOfSatisfying(
            InvalidGeometryException.class, e -> assertThat(e.defect().kind()).isEqualTo(kind));
  }

  private static boolean isKind(Points points, Kind kind) {
    return SimplicityCheck.firstDefect(points, Progress.NONE)
        .filter(defect -> defect.kind() == kind)
        .isPresent();
  }

  private static Points distinct(int range, int n, int seed) {
    Random random = new Random(seed);
    int[] cells =
        random.ints(0, range * range).distinct().limit(Math.min(n, range * range)).toArray();
    return Points.of(
        Arrays.stream(cells).map(cell -> cell % range).asDoubleStream().toArray(),
        Arrays.stream(cells).map(cell -> cell / range).asDoubleStream().toArray());
  }

  private static void requireSimple(Points points, String name) {
    int[] order = Untangle.order(points, Progress.NONE);
    assertThat(Arrays.stream(order).sorted().toArray())
        .as(name)
        .isEqualTo(IntStream.range(0, points.size()).toArray());
    Points untangled =
        Points.of(
            Arrays.stream(order).mapToDouble(points::x).toArray(),
            Arrays.stream(order).mapToDouble(points::y).toArray());
    assertThat(SimplicityCheck.firstDefect(untangled, Progress.NONE)).as(name).isEmpty();
  }
}
