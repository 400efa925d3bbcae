package dct.cli;

import dct.core.Progress;
import java.io.PrintStream;
import java.util.Locale;

/**
 * Says on standard error, in a line now and then, how far a study is and how long it will go on.
 */
final class TimeLeft implements Progress {
  private static final double FIRST_SECONDS = 2;
  private static final double SECONDS_BETWEEN = 5;
  private static final double NANOS = 1e9;

  private final PrintStream err;
  private final boolean isShown;
  private final Interruption interruption;
  private final long start = System.nanoTime();
  private double due = FIRST_SECONDS; // of the next line; in seconds since the start

  TimeLeft(PrintStream err, boolean isShown, Interruption interruption) {
    this.err = err;
    this.isShown = isShown;
    this.interruption = interruption;
  }

  @Override
  public synchronized void report(double fraction, String message) {
    double seconds = (System.nanoTime() - start) / NANOS;
    if (isShown && seconds >= due) {
      due = seconds + SECONDS_BETWEEN;
      long left = Math.round(seconds * (1 - fraction) / fraction);
      err.printf(
          Locale.ROOT,
          "%3d %%, %s, about %d:%02d left%n",
          (int) (100 * fraction),
          message,
          left / 60,
          left % 60);
    }
  }

  @Override
  public boolean isCancelled() {
    return interruption.isAsked();
  }
}
