package dct.core.degree.bound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Deadline;
import dct.core.Progress;
import dct.core.degree.LocalBound;
import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.exact.ExactSites;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.testing.RandomSets.Family;
import java.util.BitSet;
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
 * LowerBound bound = SiteBounds.ofWindows(start, goal, Progress.NONE);
 * }</pre>
 */
class WindowBoundTest {
  private static List<Family> families() {
    return SmallSets.families();
  }

  private static LowerBound bound(Triangulation start) {
    ParityGoal goal = ParityGoal.allEven(start.vertexCount());
    return SiteBounds.ofWindows(start, goal, Progress.NONE);
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
    LowerBound bound = bound(cross(10));
    assertThat(bound.value()).isEqualTo(4);
    assertThat(bound.reason()).isEqualTo("windows that cannot be all even");
    assertThat(bound.windows()).extracting(LocalBound::unmet).containsOnly(1).hasSize(3);
  }

  @Test
  void otherWishesHaveWindowsToo() {
    Triangulation start = cross(3);
    int n = start.vertexCount();
    ParityGoal[] goals = {ParityGoal.allOdd(n), ParityGoal.allEven(n).with(0, Wish.ANY)};
    for (ParityGoal goal : goals) {
      LowerBound bound = SiteBounds.ofWindows(start, goal, Progress.NONE);
      int least = ExactSites.optimize(start, goal, Progress.NONE).unmet();
      assertThat(bound.value()).isBetween(1, least);
      assertThat(bound.reason()).isEqualTo("windows that cannot be granted all wishes");
    }
  }

  @Test
  void claimsAreProvenAgain() {
    Triangulation start = cross(10);
    ParityGoal goal = ParityGoal.allEven(start.vertexCount());
    List<LocalBound> windows = bound(start).windows();
    assertThat(claimed(start, goal, windows)).isEqualTo(4);
    assertThat(claimed(start, goal, windows.subList(0, 2))).isEqualTo(2);
  }

  @Test
  void claimsThatAreFalseCountForNothing() {
    Triangulation start = cross(10);
    ParityGoal goal = ParityGoal.allEven(start.vertexCount());
    LocalBound window = bound(start).windows().get(0);
    assertThat(claimed(start, goal, List.of(window, window, window))).isEqualTo(2);
    BitSet withoutOne = (BitSet) window.sites().clone();
    withoutOne.clear(withoutOne.stream().skip(4).findFirst().orElseThrow());
    assertThat(claimed(start, goal, List.of(new LocalBound(withoutOne, 1)))).isZero();
    assertThat(claimed(start, goal, List.of(new LocalBound(window.sites(), 5)))).isZero();
  }

  private static int claimed(Triangulation start, ParityGoal goal, List<LocalBound> windows) {
    return SiteBounds.ofWindows(start, goal, windows, Progress.NONE).value();
  }

  @Test
  void aCancelEndsIt() {
    Triangulation start = cross(10);
    ParityGoal goal = ParityGoal.allEven(start.vertexCount());
    Progress cancelled = new Deadline(Progress.NONE, 0);
    assertThatThrownBy(() -> SiteBounds.ofWindows(start, goal, cancelled))
        .isInstanceOf(CancellationException.class);
  }
}
