package dct.core.degree;

import static dct.core.degree.ConvexPolygons.MOST;
import static dct.core.degree.ConvexPolygons.convex;
import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.testing.TriangulationAssert;
import org.junit.jupiter.api.Test;

/**
 * Convex pieces, and AQT in each; on polygons of many kinds in {@code PolygonAlgorithmsTest}.
 *
 * <pre>
 * Points corners = Points.ofPairs(0, 0, 4, 0, 1, 1, 0, 4);
 * SimplePolygon dart = SimplePolygon.of(corners, Progress.NONE);
 * Triangulation made = PartitioningAqt.triangulate(dart, Progress.NONE);
 * made.count(EdgeKind.PARTITION); // 1: v0–v2, between two convex pieces
 * made.count(EdgeKind.DIAGONAL); // 0: the pieces are triangles
 * </pre>
 */
class PartitioningAqtTest {

  @Test
  void theExample() {
    Points corners = Points.ofPairs(0, 0, 4, 0, 1, 1, 0, 4);
    SimplePolygon dart = SimplePolygon.of(corners, Progress.NONE);
    Triangulation made = PartitioningAqt.triangulate(dart, Progress.NONE);
    assertThat(made.count(EdgeKind.PARTITION)).isEqualTo(1);
    assertThat(made.count(EdgeKind.DIAGONAL)).isZero();
  }

  /** One convex piece: the same triangulation, and no edge of a partition. */
  @Test
  void ofAConvexPolygonItIsAqt() {
    for (int n = 3; n <= MOST; n += 7) {
      SimplePolygon polygon = convex(n);
      Triangulation pieces = PartitioningAqt.triangulate(polygon, Progress.NONE);
      assertThat(TriangulationAssert.edgesOfKind(pieces, EdgeKind.DIAGONAL))
          .as("n %d", n)
          .isEqualTo(
              TriangulationAssert.edgesOfKind(
                  Aqt.triangulate(polygon, Progress.NONE), EdgeKind.DIAGONAL));
      assertThat(pieces.count(EdgeKind.PARTITION)).as("n %d", n).isZero();
    }
  }
}
