package dct.core.degree;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import dct.testing.RandomPolygons;
import dct.testing.RandomSets;
import dct.testing.ScanFlipReference;
import dct.testing.ScanFlipReference.Edge;
import dct.testing.Transforms;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Scan-Flip against its rules written out a second time, and what each flip gains.
 *
 * <pre>
 * Sites sites = RandomSets.families().get(0).make(200, 1);
 * Triangulation delaunay = Delaunay.triangulate(sites, Progress.NONE);
 * FlipResult result = ScanFlip.run(delaunay, Progress.NONE);
 * DegreeCount.of(result.before()).odd(); // some half of them
 * DegreeCount.of(result.after()).odd(); // two or four fewer with each of result.flips()
 * </pre>
 */
class ScanFlipTest {

  static List<RandomPolygons.Family> polygons() {
    return RandomPolygons.families();
  }

  static List<RandomSets.Family> sets() {
    return RandomSets.families();
  }

  @ParameterizedTest
  @MethodSource("polygons")
  void followsTheRulesOnPolygons(RandomPolygons.Family family) {
    for (int seed = 0; seed < 60; seed++) {
      Points p = family.make(4 + seed % 40, seed);
      String what = family + ", seed " + seed;
      SimplePolygon polygon = SimplePolygon.of(p, Progress.NONE);
      compare(EarClipping.triangulate(polygon, Progress.NONE), what);
      compare(MonotoneTriangulation.triangulate(polygon, Progress.NONE), what);
      compare(PartitioningAqt.triangulate(polygon, Progress.NONE), what);
      compare(OddFan.triangulate(polygon, Progress.NONE), what);
      SimplePolygon reversed = SimplePolygon.of(Transforms.reversed(p), Progress.NONE);
      compare(MonotoneTriangulation.triangulate(reversed, Progress.NONE), what + ", reversed");
    }
  }

  @ParameterizedTest
  @MethodSource("sets")
  void followsTheRulesOnSites(RandomSets.Family family) {
    for (int seed = 0; seed < 40; seed++) {
      String what = family + ", seed " + seed;
      compare(Delaunay.triangulate(family.make(3 + seed % 60, seed), Progress.NONE), what);
    }
  }

  @Test
  void someRunsFlipALot() {
    var sites = RandomSets.families().get(0).make(200, 1);
    assertThat(compare(Delaunay.triangulate(sites, Progress.NONE), "200 sites")).isGreaterThan(9);
    SimplePolygon polygon =
        SimplePolygon.of(RandomPolygons.families().get(0).make(60, 1), Progress.NONE);
    Triangulation monotone = MonotoneTriangulation.triangulate(polygon, Progress.NONE);
    assertThat(compare(monotone, "60 vertices")).isGreaterThan(2);
  }

  @Test
  void aSecondRunStartsWithoutMarks() {
    for (int seed = 0; seed < 50; seed++) {
      var sites = RandomSets.families().get(0).make(40, seed);
      Triangulation once =
          ScanFlip.run(Delaunay.triangulate(sites, Progress.NONE), Progress.NONE).after();
      compare(once, "second run, seed " + seed);
    }
  }

  @Test
  void theFlipsInTheirOrderLeadFromBeforeToAfter() {
    var sites = RandomSets.families().get(0).make(200, 1);
    FlipResult result = ScanFlip.run(Delaunay.triangulate(sites, Progress.NONE), Progress.NONE);
    Dcel dcel = result.before().dcel().copy();
    result.edges().forEach(edge -> dcel.flip(2 * edge));
    assertThat(result.edges()).doesNotHaveDuplicates();
    for (int e = 0; e < 2 * dcel.edgeCount(); e++) {
      assertThat(dcel.origin(e)).isEqualTo(result.after().dcel().origin(e));
    }
  }

  /** The number of flips, after comparing edges, kinds and gains. */
  private static int compare(Triangulation before, String what) {
    Map<Edge, EdgeKind> given = ScanFlipReference.edges(before);
    ScanFlipReference expected = ScanFlipReference.run(before);
    FlipResult result = ScanFlip.run(before, Progress.NONE);
    assertThat(ScanFlipReference.edges(result.after())).as(what).isEqualTo(expected.edges());
    assertThat(result.flips()).as(what).isEqualTo(expected.gains().size());
    assertThat(expected.gains()).as(what).allMatch(gain -> gain == 2 || gain == 4);
    int gained = expected.gains().stream().mapToInt(Integer::intValue).sum();
    assertThat(DegreeCount.of(result.after()).even() - DegreeCount.of(before).even())
        .as(what)
        .isEqualTo(gained);
    assertThat(ScanFlipReference.edges(before)).as("unchanged, %s", what).isEqualTo(given);
    return result.flips();
  }

  @Test
  void keepsTheNumbersAndKindsOfTheOtherEdges() {
    var sites = RandomSets.families().get(0).make(80, 3);
    Triangulation before = Delaunay.triangulate(sites, Progress.NONE);
    Triangulation after = ScanFlip.run(before, Progress.NONE).after();
    Map<EdgeKind, Integer> seen = new HashMap<>();
    for (int edge = 0; edge < before.edgeCount(); edge++) {
      seen.merge(after.kind(edge), 1, Integer::sum);
      if (after.kind(edge) != EdgeKind.FLIPPED) {
        assertThat(Edge.of(after.from(edge), after.to(edge)))
            .isEqualTo(Edge.of(before.from(edge), before.to(edge)));
        assertThat(after.kind(edge)).isEqualTo(before.kind(edge));
      }
    }
    assertThat(seen.get(EdgeKind.FLIPPED)).isPositive();
  }

  /** Four odd corners: a square alone has degrees 2 3 2 3, so that two odd ones are not enough. */
  @Test
  void needsMoreThanTwoOddVertices() {
    SimplePolygon square = SimplePolygon.of(Points.ofPairs(0, 0, 4, 0, 4, 4, 0, 4), Progress.NONE);
    assertThat(ScanFlip.run(EarClipping.triangulate(square, Progress.NONE), Progress.NONE).flips())
        .isZero();
  }

  /** A fan of a pentagon: degrees 4 2 3 3 2 have two odd vertices, and Q has at most two. */
  @Test
  void leavesWhatCannotGain() {
    SimplePolygon pentagon =
        SimplePolygon.of(Points.ofPairs(0, 0, 3, 0, 5, 3, 2, 5, -1, 3), Progress.NONE);
    FlipResult result = ScanFlip.run(OddFan.triangulate(pentagon, Progress.NONE), Progress.NONE);
    assertThat(result.flips()).isZero();
    assertThat(DegreeCount.of(result.after())).isEqualTo(DegreeCount.of(result.before()));
  }
}
