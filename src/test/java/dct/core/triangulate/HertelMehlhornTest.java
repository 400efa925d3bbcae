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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Convex pieces are few, and no diagonal between them can be spared.
 *
 * <pre>
 * Points corners = Points.ofPairs(0, 0, 4, 0, 4, 4, 2, 1, 0, 4);
 * SimplePolygon vee = SimplePolygon.of(corners, Progress.NONE);
 * Triangulation ears = EarClipping.triangulate(vee, Progress.NONE);
 * Partition pieces = HertelMehlhorn.partition(vee, ears, Progress.NONE);
 * pieces.pieces(); // 3: v3 needs both its diagonals
 * </pre>
 */
class HertelMehlhornTest {

  @Test
  void theExample() {
    Points corners = Points.ofPairs(0, 0, 4, 0, 4, 4, 2, 1, 0, 4);
    SimplePolygon vee = SimplePolygon.of(corners, Progress.NONE);
    Triangulation ears = EarClipping.triangulate(vee, Progress.NONE);
    Partition pieces = HertelMehlhorn.partition(vee, ears, Progress.NONE);
    assertThat(pieces.pieces()).isEqualTo(3);
  }

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
    return new Partition(partition.region(), joined);
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
}
