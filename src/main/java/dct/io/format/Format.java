package dct.io.format;

import java.io.IOException;

/** A format of files that shapes are read from; it is told by a file's content alone. */
public interface Format {

  /** What lists and messages call it, as {@code GeoJSON}. */
  String title();

  /** Whether y grows upwards, as in mathematics and on maps. */
  default boolean yUp() {
    return true;
  }

  /** Whether a file that starts so is of this format. */
  boolean fits(Head head);

  /**
   * Reads everything; linear.
   *
   * @throws dct.io.text.BadInputException at the first place that is wrong, in one sentence
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  Shapes read(Input input) throws IOException;
}
