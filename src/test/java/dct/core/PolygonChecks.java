package dct.core;

import static dct.testing.TriangulationAssert.edgesOfKind;
import static org.assertj.core.api.Assertions.assertThat;

import dct.core.degree.DegreeCount;
import dct.core.degree.FlipResult;
import dct.core.degree.OddFan;
import dct.core.degree.PartitioningAqt;
import dct.core.degree.ScanFlip;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.HertelMehlhorn;
import dct.core.triangulate.MonotonePartition;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Partition;
import dct.core.triangulate.Triangulation;
import dct.testing.PartitionAssert;
import dct.testing.TriangulationAssert;
import java.util.Arrays;
import java.util.stream.LongStream;

/** Everything that must hold of every algorithm on one simple polygon. */
final class PolygonChecks {
  private final SimplePolygon polygon;
  private final String what;

  private PolygonChecks(Points points, String what) {
    this.polygon = SimplePolygon.of(points, Progress.NONE);
    this.what = what;
  }

  /** Runs every algorithm and checks what each one promises. */
  static void checkAll(Points points, String what) {
    PolygonChecks checks = new PolygonChecks(points, what);
    checks.checkEarClipping();
    Triangulation monotone = checks.checkMonotone();
    Partition convex = checks.checkConvexPieces(monotone);
    checks.checkCutPieces(
        "convex-even",
        PartitioningAqt.triangulate(checks.polygon, Progress.NONE),
        convex,
        PolygonChecks::aqt);
    checks.checkCutPieces(
        "convex-odd",
        OddFan.triangulate(checks.polygon, Progress.NONE),
        convex,
        PolygonChecks::fan);
  }

  private void checkEarClipping() {
    Triangulation ears = EarClipping.triangulate(polygon, Progress.NONE);
    TriangulationAssert.assertThat(ears)
        .as("ear clipping, %s", what)
        .isTriangulationOf(polygon)
        .hasInnerEdgesOnlyOf(EdgeKind.DIAGONAL);
    checkFlips("ear clipping", ears);
    checkPieces("Hertel–Mehlhorn from ears", HertelMehlhorn.partition(polygon, ears, Progress.NONE))
        .hasStrictlyConvexPieces();
  }

  private Triangulation checkMonotone() {
    Partition pieces = MonotonePartition.partition(polygon, Progress.NONE);
    checkPieces("monotone pieces", pieces).hasMonotonePieces();
    assertThat(pieces.pieces()).as("pieces, %s", what).isLessThanOrEqualTo(cusps() + 1);
    Triangulation monotone = MonotoneTriangulation.triangulate(polygon, Progress.NONE);
    TriangulationAssert.assertThat(monotone)
        .as("monotone, %s", what)
        .isTriangulationOf(polygon)
        .hasInnerEdgesOnlyOf(EdgeKind.DIAGONAL, EdgeKind.PARTITION);
    assertThat(edgesOfKind(monotone, EdgeKind.PARTITION))
        .as("partition edges, %s", what)
        .isEqualTo(diagonals(pieces));
    checkFlips("monotone", monotone);
    return monotone;
  }

  /** Vertices with both neighbours above, or both below, but for the highest and the lowest. */
  private int cusps() {
    Points p = polygon.points();
    int n = p.size();
    int extremes = 0;
    for (int v = 0; v < n; v++) {
      extremes += p.yxLess(v, (v + 1) % n) == p.yxLess(v, (v + n - 1) % n) ? 1 : 0;
    }
    return extremes - 2;
  }

  private Partition checkConvexPieces(Triangulation monotone) {
    Partition convex = HertelMehlhorn.partition(polygon, monotone, Progress.NONE);
    checkPieces("Hertel–Mehlhorn", convex).hasStrictlyConvexPieces();
    return convex;
  }

  private PartitionAssert checkPieces(String algorithm, Partition partition) {
    return PartitionAssert.assertThat(partition)
        .as("%s, %s", algorithm, what)
        .isPartitionOf(polygon);
  }

  private interface Cutter {
    LongStream diagonals(int[] piece);
  }

  private void checkCutPieces(String name, Triangulation t, Partition convex, Cutter cutter) {
    TriangulationAssert.assertThat(t)
        .as("%s, %s", name, what)
        .isTriangulationOf(polygon)
        .hasInnerEdgesOnlyOf(EdgeKind.DIAGONAL, EdgeKind.PARTITION);
    assertThat(edgesOfKind(t, EdgeKind.PARTITION))
        .as("%s, partition edges, %s", name, what)
        .isEqualTo(diagonals(convex));
    long[] expected =
        PartitionAssert.rings(convex).stream()
            .map(PolygonChecks::fromLowestNumber)
            .flatMapToLong(cutter::diagonals)
            .sorted()
            .toArray();
    assertThat(edgesOfKind(t, EdgeKind.DIAGONAL))
        .as("%s, diagonals of the pieces, %s", name, what)
        .isEqualTo(expected);
    checkFlips(name, t);
  }

  private static int[] fromLowestNumber(int[] ring) {
    int first = 0;
    for (int k = 0; k < ring.length; k++) {
      first = ring[k] < ring[first] ? k : first;
    }
    int[] turned = new int[ring.length];
    for (int k = 0; k < ring.length; k++) {
      turned[k] = ring[(first + k) % ring.length];
    }
    return turned;
  }

  /** Algorithm 3.1 as printed, its second loop going one step further. */
  static LongStream aqt(int[] v) {
    int n = v.length;
    LongStream.Builder diagonals = LongStream.builder();
    for (int i = 2; i <= n - 2; i++) {
      if (i % 3 != 0) {
        diagonals.add(key(v[0], v[i]));
      }
    }
    for (int i = 2; i <= n - 3; i += 3) {
      diagonals.add(key(v[i], v[i + 2]));
    }
    return diagonals.build();
  }

  private static LongStream fan(int[] v) {
    return LongStream.rangeClosed(2, v.length - 2).map(i -> key(v[0], v[(int) i]));
  }

  private static long key(int u, int v) {
    return ((long) Math.min(u, v) << 32) | Math.max(u, v);
  }

  private static long[] diagonals(Partition partition) {
    var dcel = partition.dcel();
    long[] keys = new long[dcel.edgeCount()];
    int count = 0;
    for (int edge = 0; edge < dcel.edgeBound(); edge++) {
      if (dcel.hasEdge(edge) && !dcel.isBoundary(edge)) {
        keys[count++] = key(dcel.origin(2 * edge), dcel.target(2 * edge));
      }
    }
    long[] sorted = Arrays.copyOf(keys, count);
    Arrays.sort(sorted);
    return sorted;
  }

  private void checkFlips(String name, Triangulation before) {
    FlipResult result = ScanFlip.run(before, Progress.NONE);
    TriangulationAssert.assertThat(result.after())
        .as("%s with flips, %s", name, what)
        .isTriangulationOf(polygon);
    int gain = DegreeCount.of(result.after()).even() - DegreeCount.of(before).even();
    assertThat(result.before()).isSameAs(before);
    assertThat(gain)
        .as("%s, %s: each flip gains 2 or 4", name, what)
        .isBetween(2 * result.flips(), 4 * result.flips());
    assertThat(result.after().count(EdgeKind.FLIPPED))
        .as("%s, flipped edges, %s", name, what)
        .isEqualTo(result.flips());
  }
}
