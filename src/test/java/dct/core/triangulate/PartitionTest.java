package dct.core.triangulate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.testing.FewestConvexPieces;
import dct.testing.PartitionAssert;
import dct.testing.RandomPolygons;
import dct.testing.RandomPolygons.Family;
import java.util.List;
import java.util.Random;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Monotone and convex partitions; and that the assertion on partitions can fail. */
class PartitionTest {

  static List<Family> families() {
    return RandomPolygons.families();
  }

  @ParameterizedTest
  @MethodSource("families")
  void convexPiecesAreAtMostFourTimesTheFewest(Family family) {
    for (int seed = 0; seed < 60; seed++) {
      Points p = family.make(4 + seed % 8, seed);
      if (p.size() <= FewestConvexPieces.MOST_VERTICES) {
        SimplePolygon polygon = SimplePolygon.of(p, Progress.NONE);
        int fewest = FewestConvexPieces.of(polygon);
        for (Triangulation t : triangulations(polygon)) {
          int pieces = HertelMehlhorn.partition(polygon, t, Progress.NONE).pieces();
          assertThat(pieces)
              .as("%s, seed %d, fewest %d", family, seed, fewest)
              .isBetween(fewest, 4 * fewest);
        }
      }
    }
  }

  /** Every diagonal that is left is needed: without it an angle would be 180° or more. */
  @ParameterizedTest
  @MethodSource("families")
  void noDiagonalBetweenConvexPiecesIsSpare(Family family) {
    for (int seed = 0; seed < 40; seed++) {
      SimplePolygon polygon = SimplePolygon.of(family.make(4 + seed % 20, seed), Progress.NONE);
      for (Triangulation t : triangulations(polygon)) {
        Partition partition = HertelMehlhorn.partition(polygon, t, Progress.NONE);
        for (int edge = 0; edge < partition.dcel().edgeBound(); edge++) {
          if (!partition.dcel().isBoundary(edge)) {
            refusesConvexity(without(partition, edge), family + ", seed " + seed);
          }
        }
      }
    }
  }

  private static Partition without(Partition partition, int edge) {
    Dcel joined = partition.dcel().copy();
    joined.joinFaces(2 * edge);
    return new Partition(partition.polygon(), joined);
  }

  private static void refusesConvexity(Partition partition, String what) {
    assertThatThrownBy(() -> PartitionAssert.assertThat(partition).hasStrictlyConvexPieces())
        .as(what)
        .isInstanceOf(AssertionError.class);
  }

  private static List<Triangulation> triangulations(SimplePolygon polygon) {
    return List.of(
        EarClipping.triangulate(polygon, Progress.NONE),
        MonotoneTriangulation.triangulate(polygon, Progress.NONE));
  }

  @Test
  void aConvexPolygonIsOnePiece() {
    SimplePolygon polygon =
        SimplePolygon.of(RandomPolygons.convex(20, new Random(1)), Progress.NONE);
    assertThat(MonotonePartition.partition(polygon, Progress.NONE).pieces()).isEqualTo(1);
    for (Triangulation t : triangulations(polygon)) {
      assertThat(HertelMehlhorn.partition(polygon, t, Progress.NONE).pieces()).isEqualTo(1);
    }
  }

  @Test
  void fewestPiecesOfKnownPolygons() {
    assertThat(FewestConvexPieces.of(polygon(0, 0, 4, 0, 4, 4, 0, 4))).isEqualTo(1);
    assertThat(FewestConvexPieces.of(polygon(0, 0, 4, 0, 1, 1, 0, 4))).isEqualTo(2);
    assertThat(FewestConvexPieces.of(polygon(0, 0, 2, 0, 4, 0, 2, 3))).isEqualTo(2);
    // A cross: with two arms cut off, what is left would have straight corners.
    assertThat(
            FewestConvexPieces.of(
                polygon(1, 0, 2, 0, 2, 1, 3, 1, 3, 2, 2, 2, 2, 3, 1, 3, 1, 2, 0, 2, 0, 1, 1, 1)))
        .isEqualTo(5);
  }

  private static SimplePolygon polygon(double... pairs) {
    return SimplePolygon.of(Points.ofPairs(pairs), Progress.NONE);
  }

  @Test
  void theAssertionRefusesWhatIsNoPartition() {
    SimplePolygon dart = polygon(0, 0, 4, 0, 1, 1, 0, 4);
    Dcel outside = Dcel.cycle(0, 1, 2, 3);
    outside.splitFace(2, 6); // v1–v3 lies outside
    refuses(() -> PartitionAssert.assertThat(new Partition(dart, outside)).isPartitionOf(dart));
    Dcel inside = Dcel.cycle(0, 1, 2, 3);
    inside.splitFace(0, 4);
    PartitionAssert.assertThat(new Partition(dart, inside))
        .isPartitionOf(dart)
        .hasStrictlyConvexPieces();
    Dcel clockwise = Dcel.cycle(0, 3, 2, 1);
    refuses(() -> PartitionAssert.assertThat(new Partition(dart, clockwise)).isPartitionOf(dart));
    Partition whole = new Partition(dart, Dcel.cycle(0, 1, 2, 3));
    refuses(() -> PartitionAssert.assertThat(whole).hasStrictlyConvexPieces());
  }

  @Test
  void theAssertionRefusesAPieceThatIsNotMonotone() {
    SimplePolygon w = polygon(0, 4, 1, 0, 2, 2, 3, 0, 4, 4);
    Partition whole = new Partition(w, Dcel.cycle(0, 1, 2, 3, 4));
    PartitionAssert.assertThat(whole).isPartitionOf(w);
    SimplePolygon m = polygon(0, 0, 4, 0, 3, 4, 2, 2, 1, 4);
    Partition wholeM = new Partition(m, Dcel.cycle(0, 1, 2, 3, 4));
    refuses(() -> PartitionAssert.assertThat(wholeM).hasMonotonePieces());
    PartitionAssert.assertThat(MonotonePartition.partition(m, Progress.NONE))
        .isPartitionOf(m)
        .hasMonotonePieces();
  }

  private static void refuses(ThrowingCallable check) {
    assertThatThrownBy(check).isInstanceOf(AssertionError.class);
  }
}
