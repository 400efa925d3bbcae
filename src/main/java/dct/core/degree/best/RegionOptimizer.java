package dct.core.degree.best;

import dct.core.Deadline;
import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.Preference;
import dct.core.degree.Preferred;
import dct.core.degree.ScanFlip;
import dct.core.degree.SearchLimits;
import dct.core.degree.bound.RegionBounds;
import dct.core.degree.exact.OddSetProof;
import dct.core.geometry.Region;
import dct.core.triangulate.Triangulation;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/**
 * A triangulation of a region with as few unmet vertices as can be found, and proven optimal where
 * it attains a lower bound.
 *
 * <p>Takes any triangulation of the region. The stages, each only if the bound is not attained yet:
 *
 * <ol>
 *   <li>Scan-Flip, the thesis's method: what comes back is never worse, however early it ends.
 *   <li>A region with one hole and nothing inside is cut open, and solved by the tables of polygons
 *       ({@link ExactAnnulus}): here if they take less than a second, after the first search if
 *       some, in the end if a minute.
 *   <li>Small parts solved anew, and walks that pair up what is left ({@link SiteSearch}); no part
 *       crosses a boundary or a fixed edge.
 *   <li>In turn, some times: sets of few unmet vertices are refuted ({@link OddSetProof}), up to
 *       600 vertices; and the search is begun anew with other random choices.
 * </ol>
 *
 * <p>The same triangulation, goal, seed and effort give the same result unless a limit of time or
 * the user ends the search. Then the best so far is returned at once; for Scan-Flip the limit waits
 * a tenth of a second.
 */
public final class RegionOptimizer {
  private static final int PATIENCE = 300; // rounds of a search that have not helped
  private static final int LITTLE_PATIENCE = 20; // of the first search
  private static final int ROUNDS = 7; // without a limit of time
  private static final int PARTS = 4; // of the steps of a proof, one a round
  private static final int MANY = 2000; // vertices; to begin anew would cost more than to go on
  private static final int SEEDS_APART = 1 << 16; // of searches one after the other

  private static final long AT_ONCE = 200_000_000; // steps of exact tables: less than a second
  private static final long QUICK_STEPS = 2_000_000_000; // some seconds

  private final Region region;
  private final Triangulation start;
  private final ParityGoal goal;
  private final SearchLimits limits;
  private final Deadline clock;
  private final Deadline early; // for what comes first, however short the limit is
  private LowerBound bound;
  private Triangulation best;
  private int unmet;

  private RegionOptimizer(
      Region region, Triangulation start, ParityGoal goal, SearchLimits limits, Progress progress) {
    this.region = region;
    this.start = start;
    this.goal = goal;
    this.limits = limits;
    clock = new Deadline(progress, limits.seconds());
    early = new Deadline(progress, Math.max(SearchLimits.GRACE, limits.seconds()));
    bound = RegionBounds.of(region, goal);
    best = start;
    unmet = goal.unmet(start);
  }

  /**
   * The best triangulation found: one that attains the bound, or the best so far when the search
   * has done all it does for this effort, the time is up or the user has cancelled.
   *
   * @param start any triangulation of the region; it is returned if it attains the bound
   */
  public static Optimum optimize(
      Region region, Triangulation start, ParityGoal goal, SearchLimits limits, Progress progress) {
    return new RegionOptimizer(region, start, goal, limits, progress).run();
  }

  /** The same, and of several equally good ones that were found the most preferred. */
  public static Preferred optimize(
      Region region,
      Triangulation start,
      ParityGoal goal,
      SearchLimits limits,
      Preference preference,
      Progress progress) {
    RegionOptimizer optimizer = new RegionOptimizer(region, start, goal, limits, progress);
    return PreferredRegions.improve(optimizer.run(), preference, limits, optimizer.clock);
  }

  private Optimum run() {
    boolean interrupted = false;
    try {
      improve();
    } catch (CancellationException e) {
      interrupted = true;
    }
    interrupted |= clock.hasStruck();
    return new Optimum(best, goal, unmet, bound, interrupted && isOpen());
  }

  private boolean isOpen() {
    return unmet > bound.value();
  }

  private void improve() {
    if (isOpen()) {
      take(ScanFlip.run(start, early).after());
      clock.checkCancelled();
    }
    Optional<ExactAnnulus> annulus =
        isOpen() ? ExactAnnulus.of(region, goal, best, clock) : Optional.empty();
    cutOpen(annulus, AT_ONCE);
    boolean hasLimit = Double.isFinite(limits.seconds());
    int rounds = start.vertexCount() > MANY && !hasLimit ? 1 : ROUNDS;
    Optional<OddSetProof> proof = Optional.empty();
    for (int k = 0; isOpen() && (k < rounds || hasLimit); k++) {
      search(k);
      clock.checkCancelled();
      if (k == 0) {
        cutOpen(annulus, QUICK_STEPS);
      }
      if (k == 0 && isOpen()) {
        proof = OddSetProof.begin(best, goal, clock);
      }
      if (isOpen()) {
        proof.ifPresent(this::refute);
      }
    }
    cutOpen(annulus, SearchLimits.MOST_STEPS);
  }

  private void cutOpen(Optional<ExactAnnulus> annulus, long mostSteps) {
    annulus
        .filter(tables -> isOpen())
        .flatMap(tables -> tables.optimum(mostSteps))
        .ifPresent(
            optimum -> {
              take(optimum.triangulation());
              bound = optimum.bound();
            });
  }

  private void refute(OddSetProof proof) {
    Optimum known = new Optimum(best, goal, unmet, bound, false);
    long steps = (long) (Math.max(1, limits.effort()) * OddSetProof.STEPS / PARTS);
    Optimum better = proof.improve(known, steps);
    best = better.triangulation();
    unmet = better.unmet();
    bound = better.bound();
    clock.checkCancelled();
  }

  private void search(int k) {
    long seed = limits.seed() + (long) SEEDS_APART * k;
    SiteSearch search = new SiteSearch(start, goal, seed, clock);
    boolean isFirst =
        k == 0 && start.vertexCount() <= MANY; // refuting may be quicker than going on
    search.pairUp(bound.value(), isFirst ? LITTLE_PATIENCE : PATIENCE);
    if (search.unmet() < unmet) {
      take(search.triangulation());
    }
  }

  private void take(Triangulation found) {
    int count = goal.unmet(found);
    if (count < unmet) {
      best = found;
      unmet = count;
    }
  }
}
