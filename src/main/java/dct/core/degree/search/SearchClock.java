package dct.core.degree.search;

import dct.core.Progress;
import dct.core.degree.SearchLimits;

/** Tells a search when to stop, and the user how far it is; may be asked by several threads. */
final class SearchClock {
  private final Progress progress;
  private final long start = System.nanoTime();
  private final double seconds;
  private volatile boolean struck;

  SearchClock(SearchLimits limits, Progress progress) {
    this.progress = progress;
    this.seconds = limits.seconds();
  }

  /** Whether the user or the limit of time has ended the search; once true, always true. */
  boolean isOver() {
    if (!struck && (progress.isCancelled() || (System.nanoTime() - start) * 1e-9 >= seconds)) {
      struck = true;
    }
    return struck;
  }

  /** Whether {@link #isOver} was ever true: the search did not do all it would have done. */
  boolean struck() {
    return struck;
  }

  /** Tells the user the best count so far. */
  void report(double fraction, int unsatisfied) {
    progress.report(fraction, "Best so far: " + unsatisfied + " unsatisfied");
  }
}
