package dct.core.triangulate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.Predicates;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.MonotonePartition.Chord;
import dct.testing.RandomPolygons;
import dct.testing.RandomPolygons.Family;
import dct.testing.Transforms;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The trapezoid chords against a look along the level line through each vertex; the pieces on
 * polygons of many kinds in {@code PolygonAlgorithmsTest}.
 *
 * <pre>
 * Points corners = Points.ofPairs(0, 0, 4, 0, 3, 4, 2, 2, 1, 4);
 * SimplePolygon em = SimplePolygon.of(corners, Progress.NONE);
 * MonotonePartition.partition(em, Progress.NONE).pieces(); // 2
 * MonotonePartition.chords(em, Progress.NONE); // from v3 to both sides:
 * // (3, 3.5, 2.0) and (3, 0.5, 2.0)
 * </pre>
 */
class MonotonePartitionTest {

  @Test
  void theExample() {
    Points corners = Points.ofPairs(0, 0, 4, 0, 3, 4, 2, 2, 1, 4);
    SimplePolygon em = SimplePolygon.of(corners, Progress.NONE);
    assertThat(MonotonePartition.partition(em, Progress.NONE).pieces()).isEqualTo(2);
    assertThat(MonotonePartition.chords(em, Progress.NONE))
        .containsExactlyInAnyOrder(new Chord(3, 3.5, 2), new Chord(3, 0.5, 2));
  }

  static List<Family> families() {
    // Between vertices an ulp apart, or of every size at once, a rounded end says nothing.
    return RandomPolygons.families().stream()
        .filter(f -> !f.name().equals("ulps") && !f.name().startsWith("wide"))
        .toList();
  }

  @ParameterizedTest
  @MethodSource("families")
  void chordsReachToTheFirstPointOfTheBoundary(Family family) {
    for (int seed = 0; seed < 120; seed++) {
      Points p = family.make(3 + seed % 30, seed);
      check(p, family + ", seed " + seed);
      check(Transforms.reversed(p), family + ", reversed, seed " + seed);
      check(Transforms.rotated(p, 2), family + ", turned, seed " + seed);
      check(sheared(p), family + ", sheared, seed " + seed);
    }
  }

  /** y + x/1024, exact for the small whole numbers of the families, leaves few vertices level. */
  private static Points sheared(Points p) {
    double[] y = p.ys();
    for (int i = 0; i < y.length; i++) {
      y[i] += p.x(i) / 1024;
    }
    return Points.of(p.xs(), y);
  }

  private static void check(Points p, String what) {
    List<Chord> chords =
        MonotonePartition.chords(SimplePolygon.of(p, Progress.NONE), Progress.NONE);
    int expected = 0;
    for (int v = 0; v < p.size(); v++) {
      expected += checkSide(p, v, -1, chords, what) + checkSide(p, v, 1, chords, what);
    }
    assertThat(chords).as(what).hasSize(expected);
  }

  /** Where differences of coordinates overflow, and between vertices an ulp apart. */
  @Test
  void everyChordEndsInsideOrOnTheBoundaryAtTheLimitsOfDoubles() {
    double most = Double.MAX_VALUE;
    checkEnds(
        Points.ofPairs(most, 6.2e-61, most, most, -most, -1), "a triangle from limit to limit");
    for (Family family : RandomPolygons.families()) {
      for (int seed = 0; seed < 40; seed++) {
        Points p = family.make(3 + seed % 30, seed);
        double largest = 0;
        for (int v = 0; v < p.size(); v++) {
          largest = Math.max(largest, Math.max(Math.abs(p.x(v)), Math.abs(p.y(v))));
        }
        int up = Double.MAX_EXPONENT - Math.getExponent(largest);
        String what = family + ", seed " + seed;
        checkEnds(p, what);
        checkEnds(scaled(p, up), what + ", as large as can be");
        if (family.name().equals("ulps")) {
          checkEnds(Transforms.rotated(p, 2), what + ", turned");
        }
      }
    }
  }

  private static Points scaled(Points p, int exponent) {
    double[] x = Arrays.stream(p.xs()).map(value -> Math.scalb(value, exponent)).toArray();
    double[] y = Arrays.stream(p.ys()).map(value -> Math.scalb(value, exponent)).toArray();
    return Points.of(x, y);
  }

  private static void checkEnds(Points p, String what) {
    for (Chord c : MonotonePartition.chords(SimplePolygon.of(p, Progress.NONE), Progress.NONE)) {
      assertThat(c.x()).as(what).isFinite().isNotEqualTo(p.x(c.vertex()));
      double beyond = c.x() > p.x(c.vertex()) ? Math.nextUp(c.x()) : Math.nextDown(c.x());
      assertThat(isInside(p, c.x(), c.y()) || isOnBoundary(p, c.x(), c.y())).as(what).isTrue();
      assertThat(isBoundaryBetween(p, c.x(), beyond, c.y())).as("longest, %s", what).isTrue();
    }
  }

  /** Whether an edge meets the level line at x1, at x2 or between them. */
  private static boolean isBoundaryBetween(Points p, double x1, double x2, double y) {
    for (int a = 0; a < p.size(); a++) {
      int b = (a + 1) % p.size();
      int side1 = Predicates.orient(p.x(a), p.y(a), p.x(b), p.y(b), x1, y);
      int side2 = Predicates.orient(p.x(a), p.y(a), p.x(b), p.y(b), x2, y);
      if (side1 * side2 <= 0 && Math.min(p.y(a), p.y(b)) <= y && y <= Math.max(p.y(a), p.y(b))) {
        return true;
      }
    }
    return false;
  }

  private static boolean isOnBoundary(Points p, double x, double y) {
    for (int a = 0; a < p.size(); a++) {
      int b = (a + 1) % p.size();
      if (Predicates.orient(p.x(a), p.y(a), p.x(b), p.y(b), x, y) == 0
          && Math.min(p.x(a), p.x(b)) <= x
          && x <= Math.max(p.x(a), p.x(b))
          && Math.min(p.y(a), p.y(b)) <= y
          && y <= Math.max(p.y(a), p.y(b))) {
        return true;
      }
    }
    return false;
  }

  /** 1 if there must be a chord on this side of v, after finding it; else 0. */
  private static int checkSide(Points p, int v, int side, List<Chord> chords, String what) {
    double nearest = nearest(p, v, side);
    if (Double.isNaN(nearest) || !isInside(p, (p.x(v) + nearest) / 2, p.y(v))) {
      return 0;
    }
    Chord chord =
        chords.stream()
            .filter(c -> c.vertex() == v && Math.signum(c.x() - p.x(v)) == side)
            .findFirst()
            .orElseThrow(() -> new AssertionError("no chord at v" + v + ", " + what));
    assertThat(chord.y()).as(what).isEqualTo(p.y(v));
    assertThat(chord.x())
        .as("v%d, %s", v, what)
        .isCloseTo(nearest, within(1e-9 * (1 + Math.abs(nearest))));
    return 1;
  }

  /** The first point of the boundary on the open level ray from v, or NaN. */
  private static double nearest(Points p, int v, int side) {
    double nearest = Double.NaN;
    for (int a = 0; a < p.size(); a++) {
      int b = (a + 1) % p.size();
      double hit = Double.NaN;
      if (p.y(a) == p.y(v) && Math.signum(p.x(a) - p.x(v)) == side) {
        hit = p.x(a);
      } else if ((p.y(a) - p.y(v)) * (p.y(b) - p.y(v)) < 0) {
        boolean upwards = p.y(a) < p.y(b);
        int turn = upwards ? p.orient(a, b, v) : p.orient(b, a, v);
        double t = (p.y(v) - p.y(a)) / (p.y(b) - p.y(a));
        hit = turn == side ? p.x(a) + t * (p.x(b) - p.x(a)) : Double.NaN;
      }
      if (!(Math.abs(nearest - p.x(v)) <= Math.abs(hit - p.x(v))) && !Double.isNaN(hit)) {
        nearest = hit;
      }
    }
    return nearest;
  }

  /** Whether (x, y) lies inside and not on the boundary: counts the edges above it. */
  private static boolean isInside(Points p, double x, double y) {
    if (isOnBoundary(p, x, y)) {
      return false;
    }
    boolean inside = false;
    for (int a = 0; a < p.size(); a++) {
      int b = (a + 1) % p.size();
      boolean rightwards = p.x(a) < p.x(b);
      int turn = Predicates.orient(p.x(a), p.y(a), p.x(b), p.y(b), x, y);
      boolean between = (p.x(a) <= x) != (p.x(b) <= x);
      inside ^= between && turn == (rightwards ? -1 : 1);
    }
    return inside;
  }

  /** Twelve corners on four levels: no chord runs along a level edge or through a corner. */
  @Test
  void chordsEndAtLevelVertices() {
    Points cross =
        Points.ofPairs(1, 0, 2, 0, 2, 1, 3, 1, 3, 2, 2, 2, 2, 3, 1, 3, 1, 2, 0, 2, 0, 1, 1, 1);
    for (Transforms.Named image : Transforms.all(cross)) {
      List<Chord> chords =
          MonotonePartition.chords(SimplePolygon.of(image.points(), Progress.NONE), Progress.NONE);
      assertThat(chords).as("%s", image).hasSize(4);
      check(image.points(), image.name());
    }
  }

  @Test
  void aTriangleHasOneChord() {
    List<Chord> chords =
        MonotonePartition.chords(
            SimplePolygon.of(Points.ofPairs(0, 0, 8, 2, 0, 4), Progress.NONE), Progress.NONE);
    assertThat(chords).containsExactly(new Chord(1, 0, 2));
  }
}
