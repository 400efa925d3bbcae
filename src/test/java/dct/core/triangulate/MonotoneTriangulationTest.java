package dct.core.triangulate;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.testing.RandomPolygons;
import dct.testing.TriangulationAssert;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * A polygon is triangulated by way of its monotone pieces; on polygons of many kinds in {@code
 * PolygonAlgorithmsTest}.
 *
 * <pre>
 * Points corners = Points.ofPairs(0, 0, 4, 0, 3, 4, 2, 2, 1, 4);
 * SimplePolygon em = SimplePolygon.of(corners, Progress.NONE);
 * Triangulation made = MonotoneTriangulation.triangulate(em, Progress.NONE);
 * made.triangleCount(); // 3
 * made.count(EdgeKind.PARTITION); // 1: between two monotone pieces
 * </pre>
 */
class MonotoneTriangulationTest {

  @Test
  void theExample() {
    Points corners = Points.ofPairs(0, 0, 4, 0, 3, 4, 2, 2, 1, 4);
    SimplePolygon em = SimplePolygon.of(corners, Progress.NONE);
    Triangulation made = MonotoneTriangulation.triangulate(em, Progress.NONE);
    assertThat(made.triangleCount()).isEqualTo(3);
    assertThat(made.count(EdgeKind.PARTITION)).isEqualTo(1);
    assertThat(made.count(EdgeKind.DIAGONAL)).isEqualTo(1);
  }

  /** Two runs number their edges alike. */
  @Test
  void edgesAreNumberedAlikeInEveryRun() {
    Points comb = RandomPolygons.comb(2_000, new Random(1));
    SimplePolygon polygon = SimplePolygon.of(comb, Progress.NONE);
    Triangulation first = MonotoneTriangulation.triangulate(polygon, Progress.NONE);
    Triangulation second = MonotoneTriangulation.triangulate(polygon, Progress.NONE);
    TriangulationAssert.assertThat(first).isTriangulationOf(polygon);
    for (int edge = 0; edge < first.edgeCount(); edge++) {
      assertThat(second.from(edge)).isEqualTo(first.from(edge));
      assertThat(second.to(edge)).isEqualTo(first.to(edge));
    }
  }
}
