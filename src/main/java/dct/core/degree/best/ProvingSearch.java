package dct.core.degree.best;

import dct.core.Deadline;
import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.degree.bound.SiteBounds;
import dct.core.degree.exact.OddSetProof;
import dct.core.triangulate.Triangulation;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinTask;

/**
 * The last stage for sites that are still open: rounds of a proof and, beside it on another core, a
 * search that begins anew.
 *
 * <p>The proof refutes sets of unmet vertices ({@link OddSetProof}), if there are few enough sites;
 * after some rounds in vain windows are tried. The searches have other random choices each time,
 * because the time that one needs varies widely, and every other one begins from another
 * triangulation ({@link HullStart}). Most are short, and some are longer, after M. Luby, A.
 * Sinclair and D. Zuckerman, <i>Optimal Speedup of Las Vegas Algorithms</i> (1993). With a limit of
 * time the rounds go on until it strikes.
 *
 * <p>Proof and search of a round have a number of steps each, and know nothing of each other. A
 * search that attains the bound ends the proof, which could not have said more; a proof that there
 * is nothing better ends the search, which could not have found more. So threads make no difference
 * to the result.
 */
final class ProvingSearch {
  private static final int PATIENCE = 300; // rounds of a search that have not helped
  private static final double SHORT_EFFORT = 0.1; // of most searches
  private static final int MANY = 2000; // sites; to begin anew would cost more than to go on
  private static final int SEEDS_APART = 1 << 16; // of searches one after the other
  private static final int ROUNDS = 7; // without a limit of time
  private static final int PARTS = 12; // of the steps of the proof, in these rounds

  private final Triangulation start;
  private final ParityGoal goal;
  private final SearchLimits limits;
  private final Deadline clock;
  private final boolean hasLimit;
  private SiteSearch search; // the best one
  private LowerBound bound;
  private Optional<OddSetProof> proof = Optional.empty();
  private Triangulation walked; // another start, or null while it is not needed

  /**
   * Gets ready.
   *
   * @param start where searches begin anew
   * @param search the best one so far
   * @param bound proven
   */
  ProvingSearch(
      Triangulation start,
      ParityGoal goal,
      SearchLimits limits,
      Deadline clock,
      SiteSearch search,
      LowerBound bound) {
    this.start = start;
    this.goal = goal;
    this.limits = limits;
    this.clock = clock;
    this.search = search;
    this.bound = bound;
    hasLimit = limits.seconds() < Double.POSITIVE_INFINITY;
  }

  /** The best search so far. */
  SiteSearch search() {
    return search;
  }

  /** The best bound so far. */
  LowerBound bound() {
    return bound;
  }

  private boolean isOpen() {
    return search.unmet() > bound.value();
  }

  /** Until the bound is attained, the effort is spent, or the clock strikes. */
  void run() {
    try {
      Stop stop = new Stop(clock);
      proof = OddSetProof.begin(search.triangulation(), goal, stop);
      if (start.vertexCount() > MANY) {
        search.solveStrips(bound.value(), limits.effort());
        tryWindows();
      }
      if (start.vertexCount() <= MANY || hasLimit) {
        searchAnew(stop);
      }
    } catch (CancellationException e) {
      clock.isCancelled(); // what was found until then remains
    }
  }

  private void searchAnew(Stop stop) {
    for (int k = 1; isOpen() && !clock.isCancelled() && (k <= ROUNDS || hasLimit); k++) {
      round(k, stop);
      if (k == ROUNDS && start.vertexCount() <= MANY) {
        tryWindows();
      }
    }
  }

  private void tryWindows() {
    if (isOpen()) {
      bound = bound.max(SiteBounds.ofWindows(search.triangulation(), goal, clock));
    }
  }

  private void round(int k, Stop stopProof) {
    Stop stopSearch = new Stop(clock);
    stopProof.isAsked = false;
    Optional<ForkJoinTask<Optimum>> beside = proof.map(sets -> beside(sets, k, stopSearch));
    Optional<SiteSearch> other = searchAgain(k, stopSearch);
    stopProof.isAsked = other.isPresent() && other.get().unmet() <= bound.value();
    Optional<Optimum> better = beside.map(ForkJoinTask::join);
    search = other.filter(found -> found.unmet() < search.unmet()).orElse(search);
    better.ifPresent(this::take);
  }

  /** Begins a part of the proof on another core. */
  private ForkJoinTask<Optimum> beside(OddSetProof sets, int k, Stop stopSearch) {
    Optimum known = new Optimum(search.triangulation(), goal, search.unmet(), bound, false);
    long steps = (long) (luby(k) * Math.max(1, limits.effort()) * OddSetProof.STEPS / PARTS);
    return ForkJoinPool.commonPool()
        .submit(
            () -> {
              Optimum better = sets.improve(known, steps);
              stopSearch.isAsked = better.bound().value() >= known.unmet();
              return better;
            });
  }

  private void take(Optimum better) {
    bound = bound.max(better.bound());
    if (better.unmet() < search.unmet()) {
      search = searchFrom(better.triangulation(), 0, clock);
    }
  }

  /** Empty if it was stopped. */
  private Optional<SiteSearch> searchAgain(int k, Stop stop) {
    try {
      SiteSearch other = searchFrom(start(k, stop), SEEDS_APART * k, stop);
      if (k % 2 != 0) {
        other.alignRectangles();
      }
      other.pairUp(bound.value(), PATIENCE);
      other.solveStrips(bound.value(), SHORT_EFFORT * luby(k) * limits.effort());
      return Optional.of(other);
    } catch (CancellationException e) {
      return Optional.empty();
    }
  }

  /** Where the search of a round begins. */
  private Triangulation start(int k, Progress stop) {
    if (k % 2 != 0) {
      return start;
    }
    if (walked == null) {
      walked = HullStart.of(start, goal, stop);
    }
    return walked;
  }

  private SiteSearch searchFrom(Triangulation triangulation, int number, Progress progress) {
    return new SiteSearch(triangulation, goal, limits.seed() + number, progress);
  }

  /** 1, 1, 2, 1, 1, 2, 4, 1, 1, 2, 1, 1, 2, 4, 8, … */
  private static int luby(int k) {
    int whole = Integer.highestOneBit(k + 1); // a run ends at each power of 2 less 1
    return whole == k + 1 ? whole / 2 : luby(k + 1 - whole);
  }

  /** Can be asked to stop before the clock strikes. */
  private static final class Stop implements Progress {
    private final Progress clock;
    private volatile boolean isAsked;

    Stop(Progress clock) {
      this.clock = clock;
    }

    @Override
    public void report(double fraction, String message) {
      clock.report(fraction, message);
    }

    @Override
    public boolean isCancelled() {
      return isAsked || clock.isCancelled();
    }
  }
}
