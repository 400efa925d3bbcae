package dct.core.degree.bound;

import dct.core.Progress;
import dct.core.degree.LocalBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.colour.HullRing;
import dct.core.degree.colour.OddSites;
import dct.core.degree.exact.OddSetSearch;
import dct.core.degree.exact.OddSetSearch.Outcome;
import java.util.Optional;

/** Proves how many sites of a window miss their wishes, with a budget for all windows together. */
final class WindowProof {
  private static final long MOST_STEPS = 100_000; // for one number of one window
  private static final long MOST_STEPS_AGAIN =
      4 * MOST_STEPS; // with the triangles in another order

  private final ParityGoal goal;
  private final Progress progress;
  private long left;

  WindowProof(ParityGoal goal, long mostSteps, Progress progress) {
    this.goal = goal;
    this.progress = progress;
    left = mostSteps;
  }

  /** Whether the budget is used up: nothing more is proven then. */
  boolean isSpent() {
    return left <= 0;
  }

  /** Whether it was proven. */
  boolean holds(OddSites sites, LocalBound claim) {
    return holds(sites, claim, MOST_STEPS);
  }

  /** Whether it was proven from the triangles at its sites alone, with more steps if need be. */
  boolean holds(HullRing ring, LocalBound claim) {
    Optional<OddSites> sites =
        isSpent()
            ? Optional.empty()
            : OddSites.of(ring, claim.sites(), WindowSites.MOST_TRIANGLES, progress);
    return sites.isPresent() && holds(sites.get(), claim, MOST_STEPS_AGAIN);
  }

  private boolean holds(OddSites sites, LocalBound claim, long mostSteps) {
    if (isSpent()) {
      return false;
    }
    progress.checkCancelled();
    long before = sites.steps();
    OddSetSearch search = OddSetSearch.within(sites, claim.sites(), goal, progress);
    Outcome outcome = search.search(claim.unmet() - 1, Math.min(left, mostSteps));
    left -= search.steps() - before + claim.sites().cardinality();
    return outcome == Outcome.REFUTED;
  }
}
