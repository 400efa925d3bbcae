package dct.core;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.degree.DegreeCount;
import dct.core.degree.FlipResult;
import dct.core.degree.OddFan;
import dct.core.degree.PartitioningAqt;
import dct.core.degree.ScanFlip;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.HertelMehlhorn;
import dct.core.triangulate.MonotonePartition;
import dct.core.triangulate.MonotonePartition.Chord;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Partition;
import dct.core.triangulate.Triangulation;
import dct.testing.PartitionAssert;
import dct.testing.RandomRegions;
import dct.testing.RandomSets;
import dct.testing.TriangulationAssert;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;

/**
 * Every algorithm on regions with holes, sites and fixed edges.
 *
 * <pre>
 * Region region = Region.of(rings, Progress.NONE);
 * Triangulation made = MonotoneTriangulation.triangulate(region, Progress.NONE);
 * made.triangleCount(); // region.triangles()
 * </pre>
 */
class RegionAlgorithmsTest {
  private static final Points FRAME =
      Points.ofPairs(0, 0, 9, 0, 9, 9, 0, 9, 3, 3, 6, 3, 6, 6, 3, 6);

  @Test
  void aFrameHasEightTriangles() {
    Region frame = frame();
    assertThat(MonotonePartition.partition(frame, Progress.NONE).pieces()).isEqualTo(2);
    for (Triangulation made :
        List.of(
            MonotoneTriangulation.triangulate(frame, Progress.NONE),
            EarClipping.triangulate(frame, Progress.NONE))) {
      assertThat(made.triangleCount()).isEqualTo(8);
      assertThat(made.boundaryCount()).isEqualTo(8);
    }
  }

  private static Region frame() {
    List<int[]> rings = List.of(new int[] {0, 1, 2, 3}, new int[] {4, 5, 6, 7});
    return Region.of(Rings.of(FRAME, rings), Progress.NONE);
  }

  @Test
  void levelChordsOfAFrameStopAtTheHole() {
    assertThat(MonotonePartition.chords(frame(), Progress.NONE))
        .contains(new Chord(4, 0, 3), new Chord(5, 9, 3), new Chord(6, 9, 6), new Chord(7, 0, 6));
  }

  @Test
  void everyAlgorithmTilesEveryRegion() {
    int holes = 0;
    int fixed = 0;
    for (RandomSets.Family family : RandomSets.families()) {
      for (int seed = 0; seed < 45; seed++) {
        int n = 4 + seed * seed / 20;
        Region region = RandomRegions.region(family, n, seed % 5, 5 * (seed % 7), seed);
        holes += region.holes();
        fixed += region.rings().fixedCount();
        check(region, family, seed);
      }
    }
    assertThat(holes).isGreaterThan(200);
    assertThat(fixed).isGreaterThan(2_000);
  }

  private static void check(Region region, RandomSets.Family family, int seed) {
    String what = String.format(Locale.ROOT, "%s, seed %d", family, seed);
    Partition monotone = MonotonePartition.partition(region, Progress.NONE);
    PartitionAssert.assertThat(monotone).as("monotone pieces, %s", what).hasMonotonePieces();
    Triangulation made = MonotoneTriangulation.triangulate(region, Progress.NONE);
    check("monotone", made, region, what);
    Triangulation ears = EarClipping.triangulate(region, Progress.NONE);
    check("ear clipping", ears, region, what);
    for (Triangulation any : List.of(made, ears)) {
      Partition convex = HertelMehlhorn.partition(region, any, Progress.NONE);
      PartitionAssert.assertThat(convex).as("convex, %s", what).hasStrictlyConvexPieces();
    }
    check("even", PartitioningAqt.triangulate(region, Progress.NONE), region, what);
    check("odd", OddFan.triangulate(region, Progress.NONE), region, what);
  }

  private static void check(String name, Triangulation made, Region region, String what) {
    TriangulationAssert.assertThat(made).as("%s, %s", name, what).isTriangulationOf(region);
    assertThat(made.triangleCount()).isEqualTo(region.triangles());
    FlipResult flipped = ScanFlip.run(made, Progress.NONE);
    TriangulationAssert.assertThat(flipped.after())
        .as("%s, flipped, %s", name, what)
        .isTriangulationOf(region);
    int gain = DegreeCount.of(flipped.after()).even() - DegreeCount.of(made).even();
    assertThat(gain).isBetween(2 * flipped.flips(), 4 * flipped.flips());
    assertThat(flipped.after().count(EdgeKind.FIXED)).isEqualTo(region.rings().fixedCount());
  }

  /** A simple polygon as a region of one ring is triangulated as the polygon is. */
  @Test
  void aRingAloneIsTriangulatedAsAPolygon() {
    for (int seed = 0; seed < 50; seed++) {
      Rings rings = RandomRegions.make(RandomSets.families().get(0), 20, 0, 0, seed);
      if (rings.ringVertices() == rings.points().size()) {
        Region region = Region.of(rings, Progress.NONE);
        check(region, RandomSets.families().get(0), seed);
      }
    }
  }
}
