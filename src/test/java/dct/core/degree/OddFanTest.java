package dct.core.degree;

import static dct.core.degree.ConvexPolygons.MOST;
import static dct.core.degree.ConvexPolygons.convex;
import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.Triangulation;
import dct.testing.TriangulationAssert;
import org.junit.jupiter.api.Test;

/**
 * Fans of convex polygons have as many odd vertices as there can be.
 *
 * <pre>
 * Points corners = Points.ofPairs(0, 0, 4, 0, 6, 3, 4, 6, 0, 6, -2, 3);
 * SimplePolygon hexagon = SimplePolygon.of(corners, Progress.NONE);
 * Triangulation odd = OddFan.triangulate(hexagon, Progress.NONE);
 * odd.degree(0); // 5: the fan is round v0
 * DegreeCount.of(odd).odd(); // 4: all but the two neighbours of v0
 * </pre>
 */
class OddFanTest {

  @Test
  void theExample() {
    Points corners = Points.ofPairs(0, 0, 4, 0, 6, 3, 4, 6, 0, 6, -2, 3);
    SimplePolygon hexagon = SimplePolygon.of(corners, Progress.NONE);
    Triangulation odd = OddFan.triangulate(hexagon, Progress.NONE);
    assertThat(odd.degree(0)).isEqualTo(5);
    assertThat(DegreeCount.of(odd).odd()).isEqualTo(4);
  }

  @Test
  void attainsTheMostThatThereCanBe() {
    for (int n = 4; n <= MOST; n++) {
      SimplePolygon polygon = convex(n);
      Triangulation t = OddFan.triangulate(polygon, Progress.NONE);
      TriangulationAssert.assertThat(t).as("n %d", n).isTriangulationOf(polygon);
      assertThat(DegreeCount.of(t).odd()).as("n %d", n).isEqualTo(n % 2 == 0 ? n - 2 : n - 3);
    }
  }

  /** Brute force over all triangulations of small convex polygons: more cannot be odd. */
  @Test
  void noTriangulationOfASmallConvexPolygonHasMoreOddVertices() {
    for (int n = 3; n <= 11; n++) {
      assertThat(DegreeCount.of(OddFan.triangulate(convex(n), Progress.NONE)).odd())
          .as("n %d", n)
          .isEqualTo(ConvexPolygons.extremes(n)[1]);
    }
  }
}
