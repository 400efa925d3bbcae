package dct.core.degree.bound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.colour.HullRing;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.Triangulation;
import dct.testing.CancelledAfter;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SiteBoundsTest {

  private static Triangulation delaunay(double... pairs) {
    return Delaunay.triangulate(Sites.of(Points.ofPairs(pairs), Progress.NONE), Progress.NONE);
  }

  private static LowerBound allEven(Triangulation triangulation) {
    return SiteBounds.of(
        triangulation, ParityGoal.allEven(triangulation.vertexCount()), Progress.NONE);
  }

  /** The lattice points (i·ux + j·vx, i·uy + j·vy), 0 ≤ i &lt; a, 0 ≤ j &lt; b. */
  private static Triangulation lattice(int a, int b, double ux, double uy, double vx, double vy) {
    double[] pairs = new double[2 * a * b];
    for (int k = 0; k < a * b; k++) {
      int i = k % a;
      int j = Math.floorDiv(k, a);
      pairs[2 * k] = 100 + i * ux + j * vx;
      pairs[2 * k + 1] = -7 + i * uy + j * vy;
    }
    return delaunay(pairs);
  }

  @Test
  void theBoundaryCountIsTheReasonWhereNothingIsBetter() {
    Triangulation hexagon = delaunay(0, 0, 5, -2, 9, 1, 10, 6, 4, 9, -1, 5);
    assertThat(allEven(hexagon)).isEqualTo(new LowerBound(0, "6 hull sites, 6 ≡ 0 mod 3"));
    Triangulation square = delaunay(0, 0, 5, 0, 5, 5, 0, 5);
    assertThat(allEven(square)).isEqualTo(new LowerBound(2, "4 hull sites, 3 does not divide 4"));
  }

  @ParameterizedTest
  @CsvSource({
    "1, 0, 0, 1",
    "0.25, 0, 0, 0.25",
    "3, 1, -1, 2",
    "1048576, 0, 0, 0.5",
    "7, -3, 100001, 4096",
  })
  void aRectangleOfALatticeIsRecognisedInAnyBasis(double ux, double uy, double vx, double vy) {
    Triangulation lattice = lattice(5, 6, ux, uy, vx, vy); // 18 on the hull
    ParityGoal even = ParityGoal.allEven(30);
    assertThat(SiteBounds.quick(lattice, even, Progress.NONE))
        .isEqualTo(new LowerBound(2, "full lattice polygon"));
  }

  @Test
  void aCancelledQuickBoundIsThatOfTheBoundaryAlone() {
    Triangulation lattice = lattice(5, 6, 1, 0, 0, 1); // 18 on the hull
    ParityGoal even = ParityGoal.allEven(30);
    Progress amongTheCoordinates = new CancelledAfter(2);
    assertThat(SiteBounds.quick(lattice, even, amongTheCoordinates).value()).isZero();
    assertThat(SiteBounds.quick(lattice, even, Progress.NONE).value()).isEqualTo(2);
  }

  @Test
  void aLatticeTriangleMayBeAllEven() {
    double[] pairs = new double[30];
    int k = 0;
    for (int i = 0; i < 5; i++) {
      for (int j = 0; i + j < 5; j++) {
        pairs[k++] = i;
        pairs[k++] = j;
      }
    }
    assertThat(allEven(delaunay(pairs)).value()).isZero();
  }

  @Test
  void aLatticeOfSpacingsThatWereRoundedIsNone() {
    Triangulation lattice = lattice(5, 6, 0.1, 0, 0, 0.1);
    assertThat(LatticeBound.of(HullRing.of(lattice), ParityGoal.allEven(30), Progress.NONE).value())
        .isZero();
  }

  @Test
  void aLatticeWithASiteMissingIsNoFullLattice() {
    Points full = lattice(5, 6, 1, 0, 0, 1).points();
    Triangulation holed =
        Delaunay.triangulate(Sites.of(full.removed(12), Progress.NONE), Progress.NONE);
    assertThat(LatticeBound.of(HullRing.of(holed), ParityGoal.allEven(29), Progress.NONE).value())
        .isZero();
  }

  @Test
  void aLongRunOnOneSideForcesOddSites() {
    double[] pairs = new double[2 * 21];
    for (int i = 0; i < 20; i++) {
      pairs[2 * i] = i;
    }
    pairs[40] = 7;
    pairs[41] = 3;
    LowerBound bound = allEven(delaunay(pairs)); // one triangulation, a fan: all 18 flats odd
    assertThat(bound.value()).isEqualTo(18);
  }

  @Test
  void stripsAreTriedWhereTheWholeHullIsTooLong() {
    int n = 2400;
    double[] pairs = new double[2 * n];
    for (int i = 0; i < n; i++) {
      double x = i - n / 2.0;
      pairs[2 * i] = i < 8 ? 250_000 * (i - 4) : 800 * x;
      pairs[2 * i + 1] = i < 8 ? 0 : 1e9 - x * x;
    }
    HullRing ring = HullRing.of(delaunay(pairs));
    assertThat(ring.size()).isEqualTo(n);
    ParityGoal goal = ParityGoal.allEven(n);
    assertThat(HullWalkBound.ofWalk(ring, goal, 0, Progress.NONE)).isEmpty();
    assertThat(HullWalkBound.ofStrips(ring, goal, Progress.NONE)).isPresent();
  }

  @Test
  void manyRandomSitesAreLeftWithoutAWalkAndTheReasonSaysSo() {
    Random random = new Random(3);
    double[] pairs = random.doubles(2 * 60_000).toArray();
    Triangulation start = delaunay(pairs);
    ParityGoal goal = ParityGoal.allEven(60_000);
    assertThat(SiteBounds.of(start, goal, Progress.NONE).reason())
        .endsWith("; too many sites for a hull walk");
    assertThat(SiteBounds.quick(start, goal, Progress.NONE).reason())
        .matches("\\d+ hull sites, .*\\d");
  }

  @Test
  void oneWishForOddAmongEvenOnesIsMissed() {
    Triangulation hexagon = delaunay(0, 0, 5, -2, 9, 1, 10, 6, 4, 9, -1, 5);
    Wish[] wishes = new Wish[6];
    Arrays.fill(wishes, Wish.EVEN);
    wishes[3] = Wish.ODD;
    assertThat(SiteBounds.of(hexagon, ParityGoal.of(wishes), Progress.NONE).value()).isEqualTo(1);
  }

  @Test
  void sitesOnOneLineHaveOneTriangulation() {
    Triangulation path = delaunay(0, 0, 2, 1, 4, 2, 6, 3);
    assertThat(allEven(path)).isEqualTo(new LowerBound(2, "all sites on one line"));
  }

  @Test
  void triangulationsOfPolygonsAreRefused() throws Exception {
    SimplePolygon polygon = SimplePolygon.of(Points.ofPairs(0, 0, 4, 0, 4, 4, 0, 4), Progress.NONE);
    Triangulation triangulation = EarClipping.triangulate(polygon, Progress.NONE);
    assertThatThrownBy(() -> allEven(triangulation)).isInstanceOf(IllegalArgumentException.class);
  }
}
