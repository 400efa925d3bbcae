package dct.core.degree.bound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Deadline;
import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.colour.AllTriangles;
import dct.core.degree.exact.ExactSites;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.testing.RandomSets.Family;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Windows that cannot be all even:
 *
 * <pre>{@code
 * Triangulation start = Delaunay.triangulate(sites, Progress.NONE);
 * ParityGoal goal = ParityGoal.allEven(start.vertexCount());
 * LowerBound bound = SiteBounds.ofWindows(start, goal, 4, Progress.NONE);
 * }</pre>
 */
class WindowBoundTest {
  private static final int NO_LIMIT = 1000;

  private static List<Family> families() {
    return SmallSets.families();
  }

  private static LowerBound bound(Triangulation start) {
    ParityGoal goal = ParityGoal.allEven(start.vertexCount());
    return SiteBounds.ofWindows(start, goal, NO_LIMIT, Progress.NONE);
  }

  @ParameterizedTest
  @MethodSource("families")
  void neverExceedsTheOptimum(Family family) {
    int tried = 0;
    int attained = 0;
    for (long seed = 0; seed < 40; seed++) {
      Sites sites = family.make(5 + (int) (seed % 8), seed);
      Triangulation start = Delaunay.triangulate(sites, Progress.NONE);
      ParityGoal goal = ParityGoal.allEven(sites.size());
      if (start.triangleCount() > 0 && sites.size() <= ExactSites.ALWAYS) {
        int least = ExactSites.optimize(start, goal, Progress.NONE).unmet();
        int value = bound(start).value();
        assertThat(value).as("%s, seed %d", family, seed).isLessThanOrEqualTo(least);
        attained += value == least ? 1 : 0;
        tried++;
      }
    }
    assertThat(attained).as("of %d sets", tried).isGreaterThanOrEqualTo(tried / 3);
  }

  /** Sites on both axes, the same number on each arm, and the origin. */
  private static Triangulation cross(int onArm) {
    Points points = Points.ofPairs(SmallSets.cross(onArm, onArm));
    return Delaunay.triangulate(Sites.of(points, Progress.NONE), Progress.NONE);
  }

  @Test
  void windowsAddUp() {
    assertThat(bound(cross(10))).isEqualTo(new LowerBound(4, "windows that cannot be all even"));
  }

  @Test
  void otherWishesHaveNoWindows() {
    Triangulation start = cross(3);
    ParityGoal odd = ParityGoal.allOdd(start.vertexCount());
    assertThat(SiteBounds.ofWindows(start, odd, NO_LIMIT, Progress.NONE).value()).isLessThan(2);
  }

  @Test
  void aCancelEndsIt() {
    Triangulation start = cross(10);
    ParityGoal goal = ParityGoal.allEven(start.vertexCount());
    Progress cancelled = new Deadline(Progress.NONE, 0);
    assertThatThrownBy(() -> SiteBounds.ofWindows(start, goal, NO_LIMIT, cancelled))
        .isInstanceOf(CancellationException.class);
  }

  /** All empty triangles, each once, against a look at every three sites. */
  @ParameterizedTest
  @MethodSource("families")
  void findsEveryEmptyTriangle(Family family) {
    for (long seed = 0; seed < 5; seed++) {
      Points points = family.make(4 + 2 * (int) seed, seed).points();
      int expected = 0;
      for (int a = 0; a < points.size(); a++) {
        for (int b = a + 1; b < points.size(); b++) {
          for (int c = b + 1; c < points.size(); c++) {
            expected += isEmpty(points, a, b, c) ? 1 : 0;
          }
        }
      }
      AllTriangles all = AllTriangles.of(points, NO_LIMIT, Progress.NONE).orElseThrow();
      assertThat(all.count()).as("%s, seed %d", family, seed).isEqualTo(expected);
    }
  }

  private static boolean isEmpty(Points points, int a, int b, int c) {
    int turn = points.orient(a, b, c);
    for (int d = 0; d < points.size(); d++) {
      boolean isInside =
          points.orient(a, b, d) * turn >= 0
              && points.orient(b, c, d) * turn >= 0
              && points.orient(c, a, d) * turn >= 0;
      if (d != a && d != b && d != c && isInside) {
        return false;
      }
    }
    return turn != 0;
  }
}
