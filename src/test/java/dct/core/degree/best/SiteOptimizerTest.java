package dct.core.degree.best;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ScanFlip;
import dct.core.degree.SearchLimits;
import dct.core.degree.bound.SmallSets;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.testing.CancelledAfter;
import dct.testing.RandomSets;
import dct.testing.TriangulationAssert;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class SiteOptimizerTest {
  private static final LowerBound NONE = new LowerBound(0, "none");

  /** Sites with whole coordinates below 10,000, all different. */
  private static Sites uniform(int n, long seed) {
    Random random = new Random(seed);
    double[] pairs = new double[2 * n];
    for (int i = 0; i < pairs.length; i++) {
      pairs[i] = random.nextInt(10_000);
    }
    return Sites.of(Points.ofPairs(pairs), Progress.NONE);
  }

  private static Triangulation delaunay(Sites sites) {
    return Delaunay.triangulate(sites, Progress.NONE);
  }

  /** Fact 2 of the boundary: all even only if 3 divides the number of hull sites. */
  private static LowerBound evenBound(Triangulation t) {
    return new LowerBound(t.boundaryCount() % 3 == 0 ? 0 : 2, "hull sites mod 3");
  }

  private static Optimum optimize(Sites sites, ParityGoal goal, LowerBound bound) {
    Optimum best =
        SiteOptimizer.optimize(
            delaunay(sites), goal, bound, new SearchLimits(1, 0.002, 60), Progress.NONE);
    requireSound(best, sites);
    return best;
  }

  private static void requireSound(Optimum best, Sites sites) {
    TriangulationAssert.assertThat(best.triangulation()).isTriangulationOf(sites);
    assertThat(best.unmet()).isEqualTo(recount(best.triangulation(), best.goal()));
  }

  /** Counts the degrees from the edges, without the topology's own degrees. */
  private static int recount(Triangulation t, ParityGoal goal) {
    int[] degree = new int[t.vertexCount()];
    for (int edge = 0; edge < t.edgeCount(); edge++) {
      degree[t.from(edge)]++;
      degree[t.to(edge)]++;
    }
    int unmet = 0;
    for (int v = 0; v < degree.length; v++) {
      unmet += goal.wish(v).isGrantedBy(degree[v]) ? 0 : 1;
    }
    return unmet;
  }

  @ParameterizedTest
  @CsvSource({"100, 1", "100, 2", "100, 3", "300, 4", "1000, 5", "3000, 6", "10000, 7"})
  void attains_the_bound_on_uniform_sites(int n, long seed) {
    Sites sites = uniform(n, seed);
    LowerBound bound = evenBound(delaunay(sites));
    Optimum best = optimize(sites, ParityGoal.allEven(sites.size()), bound);
    assertThat(best.unmet()).as("seed %d", seed).isEqualTo(bound.value());
    assertThat(best.isProven()).isTrue();
    assertThat(best.interrupted()).isFalse();
  }

  @Test
  void attains_the_bound_on_so_many_sites_that_they_are_searched_in_parts() {
    Sites sites = uniform(40_000, 8);
    LowerBound bound = evenBound(delaunay(sites));
    Optimum best = optimize(sites, ParityGoal.allEven(sites.size()), bound);
    assertThat(best.unmet()).isEqualTo(bound.value());
  }

  @ParameterizedTest
  @ValueSource(ints = {99, 100, 1000, 5001})
  void makes_all_odd_but_at_most_the_one_that_the_handshake_forbids(int n) {
    Sites sites = uniform(n, n);
    int parity = sites.size() % 2;
    Optimum best =
        optimize(sites, ParityGoal.allOdd(sites.size()), new LowerBound(parity, "handshake"));
    assertThat(best.unmet()).isEqualTo(parity);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  void satisfies_random_wishes_but_at_most_the_one_that_the_handshake_forbids(long seed) {
    Sites sites = uniform(2000, seed);
    ParityGoal.Wish[] wishes = new ParityGoal.Wish[sites.size()];
    Random random = new Random(seed);
    int odd = 0;
    for (int v = 0; v < wishes.length; v++) {
      odd += random.nextInt(2) == 0 ? 1 : 0;
      wishes[v] = ParityGoal.Wish.EVEN;
    }
    for (int v = 0; v < odd; v++) {
      wishes[v] = ParityGoal.Wish.ODD;
    }
    List<ParityGoal.Wish> shuffled = new ArrayList<>(List.of(wishes));
    Collections.shuffle(shuffled, random);
    Optimum best =
        optimize(
            sites,
            ParityGoal.of(shuffled.toArray(new ParityGoal.Wish[0])),
            new LowerBound(odd % 2, "handshake"));
    assertThat(best.unmet()).as("seed %d", seed).isEqualTo(odd % 2);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void uses_the_only_vertex_of_which_nothing_is_wished(long seed) {
    Sites sites = uniform(501, seed);
    ParityGoal.Wish[] wishes = new ParityGoal.Wish[sites.size()];
    Arrays.fill(wishes, ParityGoal.Wish.ODD);
    wishes[17] = ParityGoal.Wish.ANY;
    assertThat(optimize(sites, ParityGoal.of(wishes), NONE).unmet()).as("seed %d", seed).isZero();
  }

  @ParameterizedTest
  @ValueSource(ints = {1000, 40_000})
  void gives_the_same_for_the_same_seed_and_not_for_another(int n) {
    Sites sites = uniform(n, 3);
    int[] once = triangles(sites, 5);
    assertThat(triangles(sites, 5)).isEqualTo(once);
    assertThat(triangles(sites, 6)).isNotEqualTo(once);
  }

  private static int[] triangles(Sites sites, long seed) {
    Triangulation start = delaunay(sites);
    return SiteOptimizer.optimize(
            start,
            ParityGoal.allEven(sites.size()),
            evenBound(start),
            new SearchLimits(seed, 0.01, Double.POSITIVE_INFINITY),
            Progress.NONE)
        .triangulation()
        .triangles();
  }

  @ParameterizedTest
  @CsvSource({"2, 3", "4, 4", "3, 11", "5, 7", "13, 13", "64, 64"})
  void attains_two_on_full_lattices(int columns, int rows) {
    double[] pairs = new double[2 * columns * rows];
    for (int i = 0; i < columns * rows; i++) {
      int row = i / columns;
      pairs[2 * i] = i % columns;
      pairs[2 * i + 1] = row;
    }
    Sites sites = Sites.of(Points.ofPairs(pairs), Progress.NONE);
    LowerBound two = new LowerBound(2, "a full lattice rectangle");
    assertThat(optimize(sites, ParityGoal.allEven(columns * rows), two).isProven()).isTrue();
  }

  @Test
  void anneals_where_descent_stops_and_gives_the_same_for_the_same_seed() {
    Sites sites = perpendicularLines(15); // attains 4, so that a bound of 0 sets everything going
    Optimum best = optimize(sites, ParityGoal.allEven(sites.size()), NONE);
    Optimum again = optimize(sites, ParityGoal.allEven(sites.size()), NONE);
    assertThat(best.interrupted()).isFalse();
    assertThat(again.triangulation().triangles()).isEqualTo(best.triangulation().triangles());
  }

  /** Sites on both axes, the origin among them. */
  private static Sites perpendicularLines(int n) {
    double[] pairs = new double[4 * n];
    int half = n / 2;
    for (int i = 0; i < n; i++) {
      pairs[2 * i] = i - half;
      pairs[2 * n + 2 * i + 1] = i - half;
    }
    return Sites.of(Points.ofPairs(pairs), Progress.NONE);
  }

  @Test
  void returns_the_start_where_it_is_as_good_as_the_bound() {
    Sites sites = uniform(200, 1);
    Triangulation start = delaunay(sites);
    ParityGoal goal = ParityGoal.allEven(sites.size());
    LowerBound weak = new LowerBound(goal.unmet(start), "as it is");
    Optimum best = SiteOptimizer.optimize(start, goal, weak, SearchLimits.DEFAULT, Progress.NONE);
    assertThat(best.triangulation()).isSameAs(start);
    assertThat(best.isProven()).isTrue();
  }

  @ParameterizedTest
  @ValueSource(ints = {2, 3, 10})
  void leaves_sites_on_one_line_as_they_are(int n) {
    double[] pairs = new double[2 * n];
    for (int i = 0; i < n; i++) {
      pairs[2 * i] = i;
      pairs[2 * i + 1] = 3 * i;
    }
    Sites sites = Sites.of(Points.ofPairs(pairs), Progress.NONE);
    assertThat(optimize(sites, ParityGoal.allEven(n), NONE).interrupted()).isFalse();
  }

  @Test
  void is_never_worse_than_the_start_on_structured_sites() {
    for (RandomSets.Family family : RandomSets.families()) {
      for (int n = 4; n < 60; n += 18) {
        Sites sites = family.make(n, 11);
        Triangulation start = delaunay(sites);
        ParityGoal goal = ParityGoal.allEven(sites.size());
        Optimum best = optimize(sites, goal, NONE);
        assertThat(best.unmet())
            .as("%s, n = %d, seed 11", family, n)
            .isLessThanOrEqualTo(goal.unmet(start));
      }
    }
  }

  @Test
  void cancelled_before_the_start_gives_the_start() {
    Sites sites = uniform(500, 2);
    Optimum best = cancelledAfter(sites, 0);
    assertThat(best.interrupted()).isTrue();
    assertThat(best.unmet()).isEqualTo(best.goal().unmet(delaunay(sites)));
  }

  @ParameterizedTest
  @ValueSource(ints = {8, 12, 20, 60})
  void cancelled_on_the_way_gives_the_best_so_far(int looks) {
    for (int n : new int[] {8000, 30_000}) {
      Sites sites = uniform(n, 2);
      Optimum best = cancelledAfter(sites, looks);
      requireSound(best, sites);
      assertThat(best.interrupted()).isTrue();
      assertThat(best.unmet()).isLessThan(best.goal().unmet(delaunay(sites)));
    }
  }

  private static Optimum cancelledAfter(Sites sites, int looks) {
    Triangulation start = delaunay(sites);
    ParityGoal goal = ParityGoal.allEven(sites.size());
    return SiteOptimizer.optimize(
        start, goal, NONE, SearchLimits.DEFAULT, new CancelledAfter(looks));
  }

  /** 270 sites on the sides of a triangle and five in it: nothing proves what is found. */
  @Test
  void what_is_open_is_searched_until_the_limit_of_time() {
    double[] pairs = SmallSets.sidesOfTriangle(90);
    Sites sites = Sites.of(Points.ofPairs(pairs), Progress.NONE);
    SearchLimits limits = new SearchLimits(1, 0.001, 8);
    Optimum best =
        SiteOptimizer.optimize(delaunay(sites), ParityGoal.allEven(275), limits, Progress.NONE);
    requireSound(best, sites);
    assertThat(best.isProven()).isFalse();
    assertThat(best.interrupted()).isTrue();
  }

  @Test
  void a_limit_of_time_that_is_up_gives_scan_flip() {
    Sites sites = uniform(1000, 2);
    Triangulation start = delaunay(sites);
    ParityGoal goal = ParityGoal.allEven(sites.size());
    SearchLimits none = new SearchLimits(1, 1, 0);
    Optimum best = SiteOptimizer.optimize(start, goal, NONE, none, Progress.NONE);
    requireSound(best, sites);
    assertThat(best.interrupted()).isTrue();
    assertThat(best.unmet()).isEqualTo(goal.unmet(ScanFlip.run(start, Progress.NONE).after()));
  }

  /** 23 sites, 20 of them on one side of the hull. */
  private static Sites longSide() {
    double[] pairs = new double[46];
    for (int i = 0; i < 20; i++) {
      pairs[2 * i] = i < 15 ? i : 3 * i - 40;
      pairs[2 * i + 1] = i < 15 ? 0 : i % 4;
    }
    double[] rest = {7, 6, 11, 5, 2, 5};
    System.arraycopy(rest, 0, pairs, 40, 6);
    return Sites.of(Points.ofPairs(pairs), Progress.NONE);
  }

  /** Sites on the sides of a triangle, the same number on each. */
  private static Sites triangleSides(int onSide) {
    double[] pairs = new double[6 * onSide];
    for (int i = 0; i < onSide; i++) {
      int[] at = {i, 0, onSide - i, i, 0, onSide - i};
      for (int k = 0; k < 6; k++) {
        pairs[6 * i + k] = at[k];
      }
    }
    return Sites.of(Points.ofPairs(pairs), Progress.NONE);
  }

  private static List<Sites> ofEveryKind() {
    return List.of(
        uniform(14, 1),
        uniform(300, 1),
        longSide(),
        triangleSides(8),
        latticeTriangle(12, 0, 1, 0));
  }

  /** Whatever the question at which the user cancels: sound, and once it is done, Scan-Flip. */
  @Test
  void cancelled_at_any_question_gives_a_sound_result_no_worse_than_scan_flip() {
    for (Sites sites : ofEveryKind()) {
      Triangulation start = delaunay(sites);
      ParityGoal goal = ParityGoal.allEven(sites.size());
      int flipped = goal.unmet(ScanFlip.run(start, Progress.NONE).after());
      for (int looks = 1; looks < 3000; looks += 1 + looks / 4) {
        Optimum best = cancelledAfter(sites, looks);
        requireSound(best, sites);
        int allowed = looks < 3 ? goal.unmet(start) : flipped;
        assertThat(best.unmet()).as("after %d", looks).isLessThanOrEqualTo(allowed);
        assertThat(best.unmet()).isGreaterThanOrEqualTo(best.bound().value());
        assertThat(best.interrupted() && best.isProven()).isFalse();
      }
    }
  }

  /** The bound that takes longer is there before the search that could take minutes. */
  @Test
  void strips_are_not_searched_where_a_bound_proves_the_optimum() {
    double[] pairs = {
      0, 0, 1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 6, 0, 7, 0, 8, 0, 9, 0, 10, 0, 11, 0, 12, 0, 13, 0, 5, 6,
      10, 3, 9, 4, 3, 5, 0, 5, 6, 5, 13, 6, 13, 3, 11, 5
    };
    Sites sites = Sites.of(Points.ofPairs(pairs), Progress.NONE);
    Triangulation start = delaunay(sites);
    AtomicInteger reports = new AtomicInteger();
    Progress counting =
        new Progress() {
          @Override
          public void report(double fraction, String message) {
            reports.incrementAndGet();
          }

          @Override
          public boolean isCancelled() {
            return false;
          }
        };
    Optimum best =
        BestTriangulation.of(
            start, ParityGoal.allEven(sites.size()), SearchLimits.DEFAULT, counting);
    assertThat(best.isProven()).as(best.verdict()).isTrue();
    assertThat(reports.get()).isLessThan(20);
  }

  // ---- lattices

  /** The lattice points i + j &lt; k in the basis (1, 0), (shear, 1), or its mirror image. */
  private static Sites latticeTriangle(int k, int turns, int mirror, int shear) {
    double[] pairs = new double[k * (k + 1)];
    int at = 0;
    for (int i = 0; i < k; i++) {
      for (int j = 0; i + j < k; j++) {
        double x = i + shear * j;
        double y = mirror * j;
        pairs[at++] = turns == 0 ? x : -y;
        pairs[at++] = turns == 0 ? y : x;
      }
    }
    return Sites.of(Points.ofPairs(pairs), Progress.NONE);
  }

  @ParameterizedTest
  @ValueSource(ints = {12, 15, 24})
  void a_lattice_may_lie_in_any_way(int k) {
    for (int shear = -3; shear <= 3; shear++) {
      for (int mirror = -1; mirror <= 1; mirror += 2) {
        for (int turns = 0; turns < 2; turns++) {
          Sites sites = latticeTriangle(k, turns, mirror, shear);
          Optimum best = optimize(sites, ParityGoal.allEven(sites.size()), NONE);
          assertThat(best.unmet())
              .as("%d, shear %d, mirror %d, turns %d", k, shear, mirror, turns)
              .isZero();
        }
      }
    }
  }

  /** Only one walk in dozens succeeds here, whichever triangulation of the lattice it is from. */
  @ParameterizedTest
  @CsvSource({"12, 97", "23, 361"})
  void a_lattice_whose_last_row_is_a_part_of_one_attains_its_bound(int columns, int n) {
    double[] pairs = new double[2 * n];
    for (int i = 0; i < n; i++) {
      int row = i / columns;
      pairs[2 * i] = i % columns;
      pairs[2 * i + 1] = row;
    }
    Sites sites = Sites.of(Points.ofPairs(pairs), Progress.NONE);
    ParityGoal goal = ParityGoal.allEven(n);
    Optimum best = BestTriangulation.of(sites, goal, SearchLimits.DEFAULT, Progress.NONE);
    requireSound(best, sites);
    assertThat(best.unmet()).isEqualTo(2);
    assertThat(best.isProven()).isTrue();
  }

  // ---- no site inside the hull

  @Test
  void sites_on_the_sides_of_a_triangle_are_solved_as_its_polygon() {
    for (int onSide = 6; onSide <= 12; onSide += 2) {
      Sites sites = triangleSides(onSide);
      ParityGoal goal = ParityGoal.allEven(sites.size());
      double[] ring = new double[2 * sites.size()];
      for (int k = 0; k < sites.size(); k++) { // the three sides one after the other
        int v = 3 * (k % onSide) + k / onSide;
        ring[2 * k] = sites.points().x(v);
        ring[2 * k + 1] = sites.points().y(v);
      }
      SimplePolygon polygon = SimplePolygon.of(Points.ofPairs(ring), Progress.NONE);
      Optimum asPolygon = BestTriangulation.of(polygon, goal, SearchLimits.DEFAULT, Progress.NONE);
      Optimum asSites = optimize(sites, goal, NONE);
      assertThat(asSites.isProven()).as("%d: %s", onSide, asSites.verdict()).isTrue();
      assertThat(asSites.unmet()).isEqualTo(asPolygon.unmet());
    }
  }

  @Test
  void reports_the_best_count_so_far() {
    List<String> messages = Collections.synchronizedList(new ArrayList<>());
    Progress listening =
        new Progress() {
          @Override
          public void report(double fraction, String message) {
            assertThat(fraction).isBetween(0.0, 1.0);
            messages.add(message);
          }

          @Override
          public boolean isCancelled() {
            return false;
          }
        };
    Sites sites = uniform(30_000, 9);
    Triangulation start = delaunay(sites);
    SiteOptimizer.optimize(
        start, ParityGoal.allEven(sites.size()), evenBound(start), SearchLimits.DEFAULT, listening);
    assertThat(messages).hasSizeGreaterThan(3).anyMatch(m -> m.matches("Best so far: \\d+ unmet"));
  }
}
