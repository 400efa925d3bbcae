package dct.core.degree;

import java.util.List;

/**
 * Something to be drawn over a triangulation to explain a bound; it names points by their numbers.
 */
public sealed interface Mark {

  /** What a mark stands for; the picture gives each a colour of its own. */
  enum Tone {
    /** The first of each three. */
    ONE,
    /** The second of each three. */
    TWO,
    /** The third of each three. */
    THREE,
    /** Black of two colours. */
    BLACK,
    /** White of two colours. */
    WHITE,
    /** What the explanation speaks of. */
    MAIN,
    /** What cannot be as it is wished. */
    FAULT
  }

  /** Its tone. */
  Tone tone();

  /**
   * A vertex, with a short label.
   *
   * @param label a number or a word, perhaps empty
   */
  record Vertex(int vertex, Tone tone, String label) implements Mark {}

  /** The segment between two vertices. */
  record Segment(int from, int to, Tone tone) implements Mark {}

  /** The inside of a polygon with these vertices as corners. */
  record Area(List<Integer> corners, Tone tone) implements Mark {
    /** The list is copied. */
    public Area {
      corners = List.copyOf(corners);
    }
  }

  /**
   * A rectangle along the axes, with a short label; its coordinates are those of the points.
   *
   * @param label a number or a word, perhaps empty
   */
  record Band(double left, double low, double right, double high, Tone tone, String label)
      implements Mark {}
}
