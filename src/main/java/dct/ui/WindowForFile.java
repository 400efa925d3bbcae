package dct.ui;

import java.util.function.BooleanSupplier;
import javax.swing.SwingUtilities;

/**
 * Closes a window that was opened for a file if the file cannot be read or the user gives it up.
 * Lives on the event thread.
 */
final class WindowForFile {
  private final BooleanSupplier isUnused;
  private final Runnable close;
  private boolean isWaiting; // for the file
  private int failures; // that are not yet told

  /**
   * For a window.
   *
   * @param isUnused whether nothing goes on in it, nothing is shown, and another one is open
   */
  WindowForFile(BooleanSupplier isUnused, Runnable close) {
    this.isUnused = isUnused;
    this.close = close;
  }

  /** The window waits for its file from now on. */
  void begin() {
    isWaiting = true;
  }

  /** Tells of a failure in a dialog, after the present event. */
  void failed(Runnable dialog) {
    failures++;
    SwingUtilities.invokeLater(
        () -> {
          dialog.run();
          failures--;
          ended();
        });
  }

  /** Closes the window if it waited in vain; a dialog over it comes first. */
  void ended() {
    if (isWaiting && failures == 0) {
      isWaiting = false;
      if (isUnused.getAsBoolean()) {
        close.run();
      }
    }
  }
}
