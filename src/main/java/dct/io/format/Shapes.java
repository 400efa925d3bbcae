package dct.io.format;

import java.util.List;

/**
 * What was read from a file.
 *
 * @param format the title of its format
 * @param shapes in the order of the file, at least one
 * @param notes what was left out, a sentence each without a full stop, as {@code 3 comments and a z
 *     column left out}
 */
public record Shapes(String format, List<Shape> shapes, List<String> notes) {

  /** Copies the lists. */
  public Shapes {
    shapes = List.copyOf(shapes);
    notes = List.copyOf(notes);
  }

  /** A file with one shape, of which nothing was left out. */
  public static Shapes of(String format, Shape shape) {
    return new Shapes(format, List.of(shape), List.of());
  }
}
