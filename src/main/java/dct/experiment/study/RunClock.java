package dct.experiment.study;

import java.util.Locale;

/** Tells how long a study has run and about how long it will go on. */
public final class RunClock {
  private static final double NANOS = 1e9;

  private final long start = System.nanoTime();

  /** The seconds since the clock was made. */
  public double seconds() {
    return (System.nanoTime() - start) / NANOS;
  }

  /** How far the study is and what is left, when this part of its work is done. */
  public String words(double fraction) {
    return words(fraction, seconds());
  }

  /** The same after so many seconds. */
  static String words(double fraction, double seconds) {
    int percent = (int) (100 * fraction);
    if (fraction <= 0) {
      return percent + " %";
    }
    long left = Math.round(seconds * (1 - fraction) / fraction);
    return String.format(Locale.ROOT, "%d %%, about %d:%02d left", percent, left / 60, left % 60);
  }
}
