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
import dct.experiment.generate.RegionShape;
import dct.testing.CancelledAfter;
import dct.testing.EveryRegionTriangulation;
import dct.testing.RandomRegions;
import dct.testing.RandomSets;
import dct.testing.RegionOracle;
import dct.testing.TriangulationAssert;
import java.util.ArrayList;
import java.util.List;
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
  private static final long STEPS = 30_000; // of an enumeration
  private static final long UNLIMITED = Long.MAX_VALUE / 2;

  @Test
  void boundsAreNotAboveAndExactMethodsReachTheOptimum() {
    int checked = 0;
    int holes = 0;
    int sites = 0;
    int fixed = 0;
    for (int seed = 0; checked < REGIONS; seed++) {
      Rings rings = seed % 3 == 0 ? grown(seed) : drawn(new Random(seed));
      EveryRegionTriangulation every = new EveryRegionTriangulation(rings, STEPS);
      if (RegionOracle.isRegion(rings) && every.isComplete()) {
        Region region = Region.of(rings, Progress.NONE);
        check(region, every, new Random(seed), "seed " + seed);
        checked++;
        holes += region.holes();
        sites += region.sites();
        fixed += region.rings().fixedCount();
      }
    }
    assertThat(holes).isGreaterThan(REGIONS / 3);
    assertThat(sites).isGreaterThan(REGIONS / 5);
    assertThat(fixed).isGreaterThan(REGIONS / 20);
  }

  /** A region of any shape, in half of them whole numbers that often lie on one line. */
  private static Rings grown(int seed) {
    List<RandomSets.Family> families = RandomSets.families();
    RandomSets.Family family = families.get(seed / 3 % families.size());
    return RandomRegions.make(family, 7 + seed % 6, seed % 3, seed % 4 == 0 ? 15 : 0, seed);
  }

  /** One or two holes in a ring, now and then a site and a fixed edge; perhaps no region. */
  private static Rings drawn(Random random) {
    List<double[]> points = new ArrayList<>();
    List<int[]> rings = new ArrayList<>();
    boolean hasTwo = random.nextInt(3) == 0;
    rings.add(ring(points, 3 + random.nextInt(hasTwo ? 2 : 4), 0, 60, 100, random));
    rings.add(ring(points, 3 + random.nextInt(hasTwo ? 1 : 3), hasTwo ? -20 : 0, 5, 20, random));
    if (hasTwo) {
      rings.add(ring(points, 3, 20, 5, 20, random));
    } else if (random.nextInt(3) == 0) {
      points.add(new double[] {random.nextInt(100) - 50, random.nextInt(100) - 50});
    }
    int n = points.size();
    int[] fixed = random.nextInt(3) == 0 ? new int[] {0, 1 + random.nextInt(n - 1)} : new int[0];
    double[] x = points.stream().mapToDouble(p -> p[0]).toArray();
    double[] y = points.stream().mapToDouble(p -> p[1]).toArray();
    boolean isRing = fixed.length > 0 && fixed[1] < rings.get(0).length;
    return Rings.of(Points.of(x, y), rings, isRing ? new int[0] : fixed);
  }

  private static int[] ring(
      List<double[]> points, int size, int centre, int least, int most, Random random) {
    int[] ring = new int[size];
    for (int k = 0; k < size; k++) {
      double angle = 2 * Math.PI * (k + 0.8 * random.nextDouble()) / size;
      double radius = least + (most - least) * random.nextDouble();
      ring[k] = points.size();
      points.add(
          new double[] {
            Math.rint(centre + radius * Math.cos(angle)), Math.rint(radius * Math.sin(angle))
          });
    }
    return ring;
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
      checkCutOpen(region, start, goal, least, that);
      checkSearch(region, start, goal, least, that);
    }
  }

  private static void checkCutOpen(
      Region region, Triangulation start, ParityGoal goal, int least, String what) {
    ExactAnnulus.of(region, goal, start, Progress.NONE)
        .ifPresent(
            annulus -> {
              Optimum best = annulus.optimum(Long.MAX_VALUE).orElseThrow();
              TriangulationAssert.assertThat(best.triangulation())
                  .as(what)
                  .isTriangulationOf(region);
              assertThat(goal.unmet(best.triangulation())).as(what).isEqualTo(least);
              assertThat(best.unmet()).as(what).isEqualTo(least);
              assertThat(best.isProven()).as(what).isTrue();
            });
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

  /** Whatever the question at which the user cancels: sound, and no worse than the start. */
  @Test
  void cancelledAtAnyQuestionGivesASoundResult() {
    Region region = RegionShape.HOLES.generate(150, 3, 7, Progress.NONE);
    Triangulation start = MonotoneTriangulation.triangulate(region, Progress.NONE);
    ParityGoal goal = ParityGoal.allEven(region.size());
    for (int looks = 0; looks < 2_000; looks += 1 + looks / 4) {
      Optimum best =
          RegionOptimizer.optimize(
              region, start, goal, SearchLimits.DEFAULT, new CancelledAfter(looks));
      TriangulationAssert.assertThat(best.triangulation()).isTriangulationOf(region);
      assertThat(goal.unmet(best.triangulation()))
          .as("cancelled at question %d", looks)
          .isEqualTo(best.unmet())
          .isBetween(best.bound().value(), goal.unmet(start));
    }
  }

  @Test
  void theSameSeedGivesTheSameTriangulation() {
    Region region = RegionShape.ANNULUS.generate(120, 1, 3, Progress.NONE);
    Triangulation start = MonotoneTriangulation.triangulate(region, Progress.NONE);
    ParityGoal goal = ParityGoal.allOdd(region.size());
    int[] first = triangles(region, start, goal);
    assertThat(triangles(region, start, goal)).isEqualTo(first);
  }

  private static int[] triangles(Region region, Triangulation start, ParityGoal goal) {
    return RegionOptimizer.optimize(region, start, goal, SearchLimits.DEFAULT, Progress.NONE)
        .triangulation()
        .triangles();
  }
}
