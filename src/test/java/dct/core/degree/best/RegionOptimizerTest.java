package dct.core.degree.best;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.ScanFlip;
import dct.core.degree.SearchLimits;
import dct.core.degree.bound.RegionBounds;
import dct.core.degree.exact.OddSetSearch;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import dct.testing.EveryRegionTriangulation;
import dct.testing.RandomRegions;
import dct.testing.RandomSets;
import dct.testing.TriangulationAssert;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Bounds, exact optima and searches of small regions against all their triangulations.
 *
 * <pre>
 * Optimum best = RegionOptimizer.optimize(region, start, goal, SearchLimits.DEFAULT, progress);
 * best.unmet(); // best.bound().value() where it is proven
 * </pre>
 */
class RegionOptimizerTest {
  private static final int REGIONS = Integer.getInteger("dct.regions", 300);
  private static final long STEPS = 200_000; // of an enumeration
  private static final long UNLIMITED = Long.MAX_VALUE / 2;

  @Test
  void boundsAreNotAboveAndExactMethodsReachTheOptimum() {
    List<RandomSets.Family> families = RandomSets.families();
    int checked = 0;
    int holes = 0;
    int sites = 0;
    for (int seed = 0; checked < REGIONS; seed++) {
      RandomSets.Family family = families.get(seed % families.size());
      int n = 8 + seed % 7;
      Rings rings = RandomRegions.make(family, n, seed % 3, seed % 4 == 0 ? 15 : 0, seed);
      EveryRegionTriangulation every = new EveryRegionTriangulation(rings, STEPS);
      if (every.isComplete()) {
        Region region = Region.of(rings, Progress.NONE);
        check(region, every, new Random(seed), String.format(Locale.ROOT, "%s %d", family, seed));
        checked++;
        holes += region.holes();
        sites += region.sites();
      }
    }
    assertThat(holes).isGreaterThan(REGIONS / 3);
    assertThat(sites).isGreaterThan(REGIONS / 3);
  }

  private static void check(
      Region region, EveryRegionTriangulation every, Random random, String what) {
    int n = region.size();
    Triangulation start = MonotoneTriangulation.triangulate(region, Progress.NONE);
    assertThat(every.least(ParityGoal.allEven(n))).as(what).isLessThanOrEqualTo(n);
    for (ParityGoal goal :
        List.of(
            ParityGoal.allEven(n),
            ParityGoal.allOdd(n),
            wishes(n, random, Wish.EVEN, Wish.ODD),
            wishes(n, random, Wish.values()),
            onRings(region, random))) {
      int least = every.least(goal);
      String that = what + ", " + goal;
      LowerBound bound = RegionBounds.of(region, goal);
      assertThat(bound.value()).as("%s: %s", that, bound).isBetween(0, least);
      checkExact(region, start, goal, least, that);
      checkSearch(region, start, goal, least, that);
    }
  }

  private static void checkExact(
      Region region, Triangulation start, ParityGoal goal, int least, String what) {
    OddSetSearch search = OddSetSearch.of(start, goal, Progress.NONE).orElseThrow();
    for (int unmet = 0; unmet < least; unmet++) {
      assertThat(search.search(unmet, UNLIMITED))
          .as("%s, %d of %d", what, unmet, least)
          .isEqualTo(OddSetSearch.Outcome.REFUTED);
    }
    assertThat(search.search(least, UNLIMITED)).as(what).isEqualTo(OddSetSearch.Outcome.FOUND);
    TriangulationAssert.assertThat(search.found()).as(what).isTriangulationOf(region);
    assertThat(goal.unmet(search.found())).as(what).isEqualTo(least);
  }

  private static void checkSearch(
      Region region, Triangulation start, ParityGoal goal, int least, String what) {
    Optimum found =
        RegionOptimizer.optimize(region, start, goal, SearchLimits.DEFAULT, Progress.NONE);
    TriangulationAssert.assertThat(found.triangulation()).as(what).isTriangulationOf(region);
    assertThat(goal.unmet(found.triangulation())).as(what).isEqualTo(found.unmet());
    assertThat(found.unmet()).as(what).isEqualTo(least);
    assertThat(found.isProven()).as("%s: %s", what, found.verdict()).isTrue();
    int flipped = goal.unmet(ScanFlip.run(start, Progress.NONE).after());
    assertThat(found.unmet()).as(what).isLessThanOrEqualTo(flipped);
  }

  private static ParityGoal wishes(int n, Random random, Wish... choice) {
    Wish[] wishes = new Wish[n];
    for (int v = 0; v < n; v++) {
      wishes[v] = choice[random.nextInt(choice.length)];
    }
    return ParityGoal.of(wishes);
  }

  /** Any wishes on the rings, even inside: where the boundary count says most. */
  private static ParityGoal onRings(Region region, Random random) {
    ParityGoal goal = wishes(region.size(), random, Wish.EVEN, Wish.EVEN, Wish.ODD);
    for (int v = 0; v < goal.size(); v++) {
      goal = region.rings().isOnRing(v) ? goal : goal.with(v, Wish.EVEN);
    }
    return goal;
  }

  /** A square with a square hole: eight triangles, and all vertices can be even. */
  @Test
  void aFrameIsProvenFromItsRings() {
    Points frame = Points.ofPairs(0, 0, 9, 0, 9, 9, 0, 9, 3, 3, 6, 3, 6, 6, 3, 6);
    List<int[]> rings = List.of(new int[] {0, 1, 2, 3}, new int[] {4, 5, 6, 7});
    Region region = Region.of(Rings.of(frame, rings), Progress.NONE);
    Triangulation start = MonotoneTriangulation.triangulate(region, Progress.NONE);
    ParityGoal goal = ParityGoal.allEven(8);
    Optimum best =
        RegionOptimizer.optimize(region, start, goal, SearchLimits.DEFAULT, Progress.NONE);
    assertThat(RegionBounds.of(region, goal).reason())
        .isEqualTo("rings of 4, 4 vertices, 4 ± 4 ≡ 0 mod 3");
    assertThat(best.isProven()).isTrue();
  }
}
