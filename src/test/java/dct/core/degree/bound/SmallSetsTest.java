package dct.core.degree.bound;

import static dct.core.degree.exact.OddSetSearch.Outcome.FOUND;
import static dct.core.degree.exact.OddSetSearch.Outcome.REFUTED;
import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.LocalBound;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.colour.HullRing;
import dct.core.degree.colour.OddSites;
import dct.core.degree.exact.ExactSites;
import dct.core.degree.exact.OddSetSearch;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.testing.FlipGraph;
import dct.testing.RandomSets.Family;
import dct.testing.TriangulationAssert;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Bounds and exact optima of small sets against all their triangulations. */
class SmallSetsTest {
  private static final int SEEDS = Integer.getInteger("dct.sets.seeds", 12);
  private static final int MOST = 9;
  private static final long UNLIMITED = Long.MAX_VALUE / 2;

  private static List<Family> families() {
    return SmallSets.families();
  }

  @ParameterizedTest
  @MethodSource("families")
  void boundsAreNotAboveAndExactSitesReachTheOptimum(Family family) {
    for (long seed = 0; seed < SEEDS; seed++) {
      for (int n = 3; n <= MOST; n++) {
        Sites sites = family.make(n, 31 * seed + n);
        if (sites.size() >= 2 && sites.size() <= MOST + 1) {
          check(sites, "%s, n = %d, seed %d".formatted(family, n, seed), new Random(seed));
        }
      }
    }
  }

  private static void check(Sites sites, String name, Random random) {
    Triangulation start = Delaunay.triangulate(sites, Progress.NONE);
    FlipGraph all = new FlipGraph(sites.points());
    for (ParityGoal goal : goals(start, random)) {
      int least = all.least(goal);
      String what = name + ", " + sites.points().size() + " sites";
      LowerBound bound = SiteBounds.of(start, goal, Progress.NONE);
      assertThat(bound.value()).as("%s: %s", what, bound).isLessThanOrEqualTo(least);
      assertThat(SiteBounds.quick(start, goal, Progress.NONE).value())
          .as(what)
          .isBetween(0, bound.value());
      if (start.triangleCount() > 0) {
        checkStrips(HullRing.of(start), goal, least, what);
      }
      Optimum optimum = ExactSites.optimize(start, goal, Progress.NONE);
      TriangulationAssert.assertThat(optimum.triangulation()).isTriangulationOf(sites);
      assertThat(goal.unmet(optimum.triangulation())).as(what).isEqualTo(least);
      assertThat(optimum.isProven()).as(what).isTrue();
      if (start.triangleCount() > 0) {
        checkOddSets(start, goal, least, what);
        checkWindow(start, all, goal, random, what);
      }
    }
    if (start.triangleCount() > 0) {
      ParityGoal any = SmallSets.randomGoal(start.vertexCount(), random);
      checkWindows(start, all, ParityGoal.allEven(any.size()), name);
      checkWindows(start, all, any, name);
    }
  }

  /** A slab or a box, against the least number of unmet sites in it in all triangulations. */
  private static void checkWindow(
      Triangulation start, FlipGraph all, ParityGoal goal, Random random, String what) {
    Points points = start.points();
    int a = random.nextInt(points.size());
    int b = random.nextInt(points.size());
    boolean isSlab = random.nextBoolean();
    BitSet window = new BitSet();
    for (int v = 0; v < points.size(); v++) {
      boolean isBetween = isBetween(points.x(a), points.x(v), points.x(b));
      window.set(v, isBetween && (isSlab || isBetween(points.y(a), points.y(v), points.y(b))));
    }
    int least = all.least(within(goal, window));
    OddSites sites = OddSites.of(HullRing.of(start), window, 10_000, Progress.NONE).orElseThrow();
    OddSetSearch search = OddSetSearch.within(sites, window, goal, Progress.NONE);
    assertThat(search.search(least, UNLIMITED)).as("%s, window %s", what, window).isEqualTo(FOUND);
  }

  private static boolean isBetween(double a, double x, double b) {
    return Math.min(a, b) <= x && x <= Math.max(a, b);
  }

  /** The same wishes, but for none outside a window. */
  private static ParityGoal within(ParityGoal goal, BitSet window) {
    ParityGoal within = goal;
    for (int v = 0; v < goal.size(); v++) {
      within = window.get(v) ? within : within.with(v, Wish.ANY);
    }
    return within;
  }

  /** Windows against the least number of unmet sites in each, and their sum against all. */
  private static void checkWindows(
      Triangulation start, FlipGraph all, ParityGoal goal, String what) {
    LowerBound bound = SiteBounds.ofWindows(start, goal, Progress.NONE);
    BitSet seen = new BitSet();
    for (LocalBound window : bound.windows()) {
      assertThat(seen.intersects(window.sites())).as(what).isFalse();
      seen.or(window.sites());
      assertThat(window.unmet())
          .as("%s, %s", what, window)
          .isBetween(1, all.least(within(goal, window.sites())));
    }
    assertThat(bound.value()).as(what).isLessThanOrEqualTo(all.least(goal));
  }

  private static void checkOddSets(Triangulation start, ParityGoal goal, int least, String what) {
    OddSetSearch search = OddSetSearch.of(start, goal, Progress.NONE).orElseThrow();
    for (int unmet = 0; unmet < least; unmet++) {
      assertThat(search.search(unmet, UNLIMITED)).as("%s, %d", what, unmet).isEqualTo(REFUTED);
    }
    assertThat(search.search(least, UNLIMITED)).as(what).isEqualTo(FOUND);
    TriangulationAssert.assertThat(search.found())
        .isTriangulationOf(Sites.of(start.points(), Progress.NONE));
    assertThat(goal.unmet(search.found())).as(what).isEqualTo(least);
  }

  private static void checkStrips(HullRing ring, ParityGoal goal, int least, String what) {
    int strips = HullWalkBound.ofStrips(ring, goal, Progress.NONE).orElseThrow().value();
    int walk = HullWalkBound.ofWalk(ring, goal, -1, Progress.NONE).orElseThrow().value();
    assertThat(walk).as("walk, %s", what).isBetween(strips, least);
  }

  private static List<ParityGoal> goals(Triangulation start, Random random) {
    int n = start.vertexCount();
    List<ParityGoal> goals = new ArrayList<>();
    goals.add(ParityGoal.allEven(n));
    goals.add(ParityGoal.allOdd(n));
    for (int i = 0; i < 3; i++) {
      goals.add(SmallSets.randomGoal(n, random));
      if (start.triangleCount() > 0) {
        goals.add(SmallSets.randomHullGoal(HullRing.of(start), random));
      }
    }
    return goals;
  }
}
