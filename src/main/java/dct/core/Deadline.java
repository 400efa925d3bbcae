package dct.core;

/**
 * A progress that also asks to stop once a time has passed. Once it has asked to stop it does so
 * for ever. For every step of a search that has a limit of time, also from several threads.
 */
public final class Deadline implements Progress {
  private static final double NANOS = 1e9;

  private final Progress progress;
  private final long start = System.nanoTime();
  private final double nanos; // how long, from the start
  private volatile boolean struck;

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
    if (!struck && (progress.isCancelled() || System.nanoTime() - start >= nanos)) {
      struck = true;
    }
    return struck;
  }

  /** Whether {@link #isCancelled} was ever true: someone was told to stop before the end. */
  public boolean hasStruck() {
    return struck;
  }
}
