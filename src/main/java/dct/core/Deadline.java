package dct.core;

/** A progress that also asks to stop once a time has passed. */
public final class Deadline implements Progress {
  private static final double NANOS = 1e9;

  private final Progress progress;
  private final long start = System.nanoTime();
  private final double nanos; // how long, from the start

  /** So many seconds from now; infinitely many set no limit. */
  public Deadline(Progress progress, double seconds) {
    this.progress = progress;
    nanos = seconds * NANOS;
  }

  @Override
  public void report(double fraction, String message) {
    progress.report(fraction, message);
  }

  @Override
  public boolean isCancelled() {
    return progress.isCancelled() || System.nanoTime() - start >= nanos;
  }
}
