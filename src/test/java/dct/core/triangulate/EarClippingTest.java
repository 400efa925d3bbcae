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
 * Ears are cut off a polygon; on polygons of many kinds in {@code PolygonAlgorithmsTest}.
 *
 * <pre>
 * Points corners = Points.ofPairs(0, 0, 4, 0, 3, 4, 2, 2, 1, 4);
 * SimplePolygon em = SimplePolygon.of(corners, Progress.NONE);
 * Triangulation made = EarClipping.triangulate(em, Progress.NONE);
 * made.triangleCount(); // 3
 * made.count(EdgeKind.DIAGONAL); // 2: every diagonal cuts off an ear
 * </pre>
 */
class EarClippingTest {

  @Test
  void theExample() {
    Points corners = Points.ofPairs(0, 0, 4, 0, 3, 4, 2, 2, 1, 4);
    SimplePolygon em = SimplePolygon.of(corners, Progress.NONE);
    Triangulation made = EarClipping.triangulate(em, Progress.NONE);
    assertThat(made.triangleCount()).isEqualTo(3);
    assertThat(made.count(EdgeKind.DIAGONAL)).isEqualTo(2);
    assertThat(made.count(EdgeKind.PARTITION)).isEqualTo(0);
  }

  /** Two runs number their edges alike. */
  @Test
  void edgesAreNumberedAlikeInEveryRun() {
    Points comb = RandomPolygons.comb(2_000, new Random(1));
    SimplePolygon polygon = SimplePolygon.of(comb, Progress.NONE);
    Triangulation first = EarClipping.triangulate(polygon, Progress.NONE);
    Triangulation second = EarClipping.triangulate(polygon, Progress.NONE);
    TriangulationAssert.assertThat(first).isTriangulationOf(polygon);
    for (int edge = 0; edge < first.edgeCount(); edge++) {
      assertThat(second.from(edge)).isEqualTo(first.from(edge));
      assertThat(second.to(edge)).isEqualTo(first.to(edge));
    }
  }
}
