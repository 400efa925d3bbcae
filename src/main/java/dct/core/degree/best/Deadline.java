package dct.core.degree.best;

import dct.core.Progress;

/** A progress that also asks to stop once a time has passed. */
final class Deadline implements Progress {
  private static final double NANOS = 1e9;

  private final Progress progress;
  private final long start = System.nanoTime();
  private final double nanos; // how long, from the start

  Deadline(Progress progress, double seconds) {
    this.progress = progress;
    nanos = seconds * NANOS;
  }

  @Override
  public void report(double fraction, String message) {
    progress.report(fraction, message);
  }

  @Override
  public boolean isCancelled() {
    return progress.isCancelled() || System.nanoTime() - start > nanos;
  }
}
