package dct.ui.dialog;

import dct.io.format.UnclearInput;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;

/**
 * What a file or a text turned out to hold: what was meant of it, or why that is not clear.
 *
 * @param meant what was made of it
 * @param unclear what there is to choose from, if nothing said what is meant
 */
public record Found<T>(Optional<T> meant, Optional<UnclearInput> unclear) {

  /** What this reading finds. */
  public static <T> Found<T> by(Supplier<T> reading) {
    try {
      return new Found<>(Optional.of(reading.get()), Optional.empty());
    } catch (UnclearInput e) {
      return new Found<>(Optional.empty(), Optional.of(e));
    }
  }

  /**
   * Hands it on.
   *
   * @param choose asks what is meant; it is called later, since a dialog waits for its answer and
   *     the queue of jobs must not wait with it
   */
  public void handOn(Consumer<T> take, Consumer<UnclearInput> choose) {
    meant.ifPresent(take);
    unclear.ifPresent(asked -> SwingUtilities.invokeLater(() -> choose.accept(asked)));
  }
}
