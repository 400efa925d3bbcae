package dct.ui.dialog;

import dct.io.format.SeveralShapes;
import dct.io.format.Shapes;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;

/**
 * What a file or a text turned out to hold: what was meant of it, or several shapes of which one is
 * to be chosen.
 *
 * @param meant what was made of it
 * @param several the shapes, if nothing said which is meant
 */
public record Found<T>(Optional<T> meant, Optional<Shapes> several) {

  /** What this reading finds. */
  public static <T> Found<T> by(Supplier<T> reading) {
    try {
      return new Found<>(Optional.of(reading.get()), Optional.empty());
    } catch (SeveralShapes e) {
      return new Found<>(Optional.empty(), Optional.of(e.shapes()));
    }
  }

  /**
   * Hands it on.
   *
   * @param choose asks which of the shapes is meant; it is called later, since a dialog waits for
   *     its answer and the queue of jobs must not wait with it
   */
  public void handOn(Consumer<T> take, Consumer<Shapes> choose) {
    meant.ifPresent(take);
    several.ifPresent(shapes -> SwingUtilities.invokeLater(() -> choose.accept(shapes)));
  }
}
