package dct.io.format;

import java.io.IOException;

/** Writes a drawing in one format; linear. */
@FunctionalInterface
public interface DrawingWriter {

  /**
   * Writes everything.
   *
   * @throws CannotHold if the format cannot hold the drawing; nothing is written then
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  void write(Drawing drawing, TextOut out) throws IOException;
}
