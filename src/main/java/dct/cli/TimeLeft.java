package dct.cli;

import dct.core.Progress;
import dct.experiment.study.RunClock;
import java.io.PrintStream;

/**
 * Says on standard error, in a line now and then, how far a long work is and how long it will go
 * on, and stops it when the user asks.
 */
final class TimeLeft implements Progress {
  private static final double FIRST_SECONDS = 2;
  private static final double SECONDS_BETWEEN = 5;

  private final PrintStream err;
  private final boolean isShown;
  private final Interruption interruption;
  private final RunClock clock = new RunClock();
  private double due = FIRST_SECONDS; // of the next line

  TimeLeft(PrintStream err, boolean isShown, Interruption interruption) {
    this.err = err;
    this.isShown = isShown;
    this.interruption = interruption;
  }

  @Override
  public synchronized void report(double fraction, String message) {
    if (isShown && clock.seconds() >= due) {
      due = clock.seconds() + SECONDS_BETWEEN;
      err.println(message + ", " + clock.words(fraction));
    }
  }

  @Override
  public boolean isCancelled() {
    return interruption.isAsked();
  }
}
