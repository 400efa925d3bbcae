package dct.core.degree.region;

import dct.core.Deadline;
import dct.core.Progress;
import dct.core.degree.SearchLimits;

/** Tells a search when to stop, and the user how far it is; may be asked by several threads. */
public final class SearchClock {
  private final Progress progress; // cancelled when the time is up, too
  private volatile boolean struck;

  public SearchClock(SearchLimits limits, Progress progress) {
    this.progress = new Deadline(progress, limits.seconds());
  }

  /** Whether the user or the limit of time has ended the search; once true, always true. */
  public boolean isOver() {
    if (!struck && progress.isCancelled()) {
      struck = true;
    }
    return struck;
  }

  /** Whether {@link #isOver} was ever true: the search did not do all it would have done. */
  public boolean struck() {
    return struck;
  }

  /** Tells the user the best count so far. */
  public void report(double fraction, int unsatisfied) {
    progress.report(fraction, "Best so far: " + unsatisfied + " unsatisfied");
  }
}
