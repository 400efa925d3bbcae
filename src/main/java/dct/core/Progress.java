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
}
