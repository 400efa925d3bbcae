package dct.core;

import java.util.concurrent.CancellationException;

/**
 * How a long computation tells its caller where it is, and learns that it should stop.
 *
 * <p>Implementations are called from the computing thread, possibly from several at once, and must
 * return quickly.
 */
public interface Progress {

  /** Reports nothing and never cancels. */
  Progress NONE =
      new Progress() {
        @Override
        public void report(double fraction, String message) {}

        @Override
        public boolean isCancelled() {
          return false;
        }
      };

  /**
   * Tells how far the computation is.
   *
   * @param fraction the part that is done, from 0 to 1
   * @param message what is being done, for a person to read
   */
  void report(double fraction, String message);

  /** Whether the caller has asked the computation to stop. */
  boolean isCancelled();

  /** How many steps of a loop there are from one question to the next. */
  int STRIDE = 1 << 14;

  /**
   * For every step of a long loop: asks {@code progress} in the first one and then in one of {@link
   * #STRIDE}, and costs a comparison in the others.
   *
   * @param step the number of the step, from 0 on
   * @throws CancellationException if {@link #isCancelled()}
   */
  static void check(Progress progress, int step) {
    if ((step & (STRIDE - 1)) == 0) {
      progress.checkCancelled();
    }
  }

  /**
   * The same, and where it asks it also reports.
   *
   * @param steps how many there will be, more than {@code step}
   * @param message what is being done, for a person to read
   * @throws CancellationException if {@link #isCancelled()}
   */
  static void tick(Progress progress, int step, int steps, String message) {
    if ((step & (STRIDE - 1)) == 0) {
      progress.checkCancelled();
      progress.report((double) step / steps, message);
    }
  }

  /**
   * Stops the computation if the caller asked for it.
   *
   * @throws CancellationException if {@link #isCancelled()}
   */
  default void checkCancelled() {
    if (isCancelled()) {
      throw new CancellationException();
    }
  }

  /**
   * What a part of the computation reports to: its fractions lie between these two of the whole.
   *
   * @param from the part that is done at its start, from 0 to 1
   * @param to the part that is done at its end
   */
  default Progress part(double from, double to) {
    Progress whole = this;
    return new Progress() {
      @Override
      public void report(double fraction, String message) {
        whole.report(from + (to - from) * fraction, message);
      }

      @Override
      public boolean isCancelled() {
        return whole.isCancelled();
      }
    };
  }
}
