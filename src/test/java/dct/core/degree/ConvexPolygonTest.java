package dct.core.degree;

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
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** What the lemmas promise of convex polygons. */
class ConvexPolygonTest {
  private static final int MOST = 300;

  private static SimplePolygon convex(int n) {
    Points p = RandomPolygons.convex(n, new Random(n));
    return SimplePolygon.of(n % 2 == 0 ? p : Transforms.reversed(p), Progress.NONE);
  }

  /** Lemma 3.2: all even if 3 divides n. Lemma 3.3: all but two otherwise. */
  @Test
  void aqtMeetsLemmas32And33() {
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

  /** One convex piece: the same triangulation, and no edge of a partition. */
  @Test
  void partitioningAqtOfAConvexPolygonIsAqt() {
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

  @Test
  void oddFanAttainsTheMostThatThereCanBe() {
    for (int n = 4; n <= MOST; n++) {
      SimplePolygon polygon = convex(n);
      Triangulation t = OddFan.triangulate(polygon, Progress.NONE);
      TriangulationAssert.assertThat(t).as("n %d", n).isTriangulationOf(polygon);
      assertThat(DegreeCount.of(t).odd()).as("n %d", n).isEqualTo(n % 2 == 0 ? n - 2 : n - 3);
    }
  }

  /** Brute force over all triangulations of small convex polygons: both are the best there is. */
  @Test
  void noTriangulationOfASmallConvexPolygonDoesBetter() {
    for (int n = 3; n <= 11; n++) {
      int[] odd = extremes(n);
      SimplePolygon polygon = convex(n);
      assertThat(DegreeCount.of(Aqt.triangulate(polygon, Progress.NONE)).odd())
          .as("n %d", n)
          .isEqualTo(odd[0]);
      assertThat(DegreeCount.of(OddFan.triangulate(polygon, Progress.NONE)).odd())
          .as("n %d", n)
          .isEqualTo(odd[1]);
    }
  }

  /** The least and the most odd vertices over all triangulations of a convex n-gon. */
  private static int[] extremes(int n) {
    int[] best = {n, 0};
    for (int[] degrees : triangulations(0, n - 1, n)) {
      int odd = 0;
      for (int degree : degrees) {
        odd += degree & 1;
      }
      best[0] = Math.min(best[0], odd);
      best[1] = Math.max(best[1], odd);
    }
    return best;
  }

  /** The degrees in each triangulation of the vertices i … j, the side ij included. */
  private static List<int[]> triangulations(int i, int j, int n) {
    List<int[]> all = new ArrayList<>();
    if (j == i + 1) {
      int[] side = new int[n];
      side[i]++;
      side[j]++;
      all.add(side);
      return all;
    }
    for (int k = i + 1; k < j; k++) {
      for (int[] left : triangulations(i, k, n)) {
        for (int[] right : triangulations(k, j, n)) {
          int[] sum = new int[n];
          for (int v = 0; v < n; v++) {
            sum[v] = left[v] + right[v];
          }
          sum[i]++;
          sum[j]++;
          all.add(sum);
        }
      }
    }
    return all;
  }

  @Test
  void aqtStartsAtTheLowestNumber() {
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
  void aqtRefusesWhatIsNotStrictlyConvex() {
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
