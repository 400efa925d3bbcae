package dct.core.degree;

import static dct.core.degree.ConvexPolygons.MOST;
import static dct.core.degree.ConvexPolygons.convex;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.testing.RandomPolygons;
import dct.testing.Transforms;
import dct.testing.TriangulationAssert;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Alternate Quadrangulation-Triangulation of convex polygons, against the lemmas.
 *
 * <pre>
 * Points corners = Points.ofPairs(0, 0, 4, 0, 6, 3, 4, 6, 0, 6, -2, 3);
 * SimplePolygon hexagon = SimplePolygon.of(corners, Progress.NONE);
 * Triangulation even = Aqt.triangulate(hexagon, Progress.NONE);
 * even.count(EdgeKind.DIAGONAL); // 3
 * DegreeCount.of(even).odd(); // 0, since 3 divides 6
 * </pre>
 */
class AqtTest {

  @Test
  void theExample() {
    Points corners = Points.ofPairs(0, 0, 4, 0, 6, 3, 4, 6, 0, 6, -2, 3);
    SimplePolygon hexagon = SimplePolygon.of(corners, Progress.NONE);
    Triangulation even = Aqt.triangulate(hexagon, Progress.NONE);
    assertThat(even.count(EdgeKind.DIAGONAL)).isEqualTo(3);
    assertThat(DegreeCount.of(even).odd()).isZero();
  }

  /** Lemma 3.2: all even if 3 divides n. Lemma 3.3: all but two otherwise. */
  @Test
  void meetsLemmas32And33() {
    for (int n = 3; n <= MOST; n++) {
      SimplePolygon polygon = convex(n);
      Triangulation t = Aqt.triangulate(polygon, Progress.NONE);
      TriangulationAssert.assertThat(t)
          .as("n %d", n)
          .isTriangulationOf(polygon)
          .hasInnerEdgesOnlyOf(EdgeKind.DIAGONAL);
      assertThat(DegreeCount.of(t).odd()).as("n %d", n).isEqualTo(n % 3 == 0 ? 0 : 2);
    }
  }

  /** Brute force over all triangulations of small convex polygons: fewer cannot be odd. */
  @Test
  void noTriangulationOfASmallConvexPolygonHasFewerOddVertices() {
    for (int n = 3; n <= 11; n++) {
      assertThat(DegreeCount.of(Aqt.triangulate(convex(n), Progress.NONE)).odd())
          .as("n %d", n)
          .isEqualTo(ConvexPolygons.extremes(n)[0]);
    }
  }

  @Test
  void startsAtTheLowestNumber() {
    for (int first = 0; first < 9; first++) {
      SimplePolygon polygon =
          SimplePolygon.of(
              Transforms.startingAt(RandomPolygons.convex(9, new Random(1)), first), Progress.NONE);
      assertThat(Aqt.triangulate(polygon, Progress.NONE).degree(0))
          .as("begun at %d", first)
          .isEqualTo(6);
    }
  }

  @Test
  void refusesWhatIsNotStrictlyConvex() {
    SimplePolygon straight =
        SimplePolygon.of(Points.ofPairs(0, 0, 2, 0, 4, 0, 2, 3), Progress.NONE);
    assertThatThrownBy(() -> Aqt.triangulate(straight, Progress.NONE))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("180°");
    SimplePolygon reflex = SimplePolygon.of(Points.ofPairs(0, 0, 4, 0, 1, 1, 0, 4), Progress.NONE);
    assertThatThrownBy(() -> Aqt.triangulate(reflex, Progress.NONE))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("180°");
  }
}
