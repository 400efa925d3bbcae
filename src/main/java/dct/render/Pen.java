package dct.render;

/**
 * What a picture is drawn with: a screen, an image, or a file. All coordinates are in pixels, y
 * downwards.
 *
 * <p>{@link #style} is called before each run of shapes of one colour, so that a pen can batch
 * them.
 */
public interface Pen {

  /** Where a text lies with respect to its point, on the baseline. */
  enum Anchor {
    START,
    MIDDLE,
    END
  }

  /** The part of the picture that everything drawn until the next call belongs to. */
  default void part(Part part) {}

  /** The vertex of the scene that the next disc or square is. */
  default void vertex(int vertex) {}

  /** The colour and line of everything drawn until the next call. */
  void style(Stroke stroke);

  /** A straight line. */
  void line(double x1, double y1, double x2, double y2);

  /** A filled disc. */
  void disc(double x, double y, double radius);

  /** A filled rectangle with this upper left corner. */
  void rectangle(double x, double y, double width, double height);

  /** A filled square of half this side, round a point. */
  default void square(double x, double y, double halfSide) {
    rectangle(x - halfSide, y - halfSide, 2 * halfSide, 2 * halfSide);
  }

  /**
   * A filled polygon; where its boundary crosses itself, what lies inside an odd number of times.
   *
   * @param x the coordinates of its corners, in order
   * @param y as many
   */
  void polygon(double[] x, double[] y);

  /** The outline of a circle. */
  void ring(double x, double y, double radius);

  /**
   * A line of text of this size, with a rim in the colour of the ground so that it stays legible.
   */
  void text(double x, double y, Anchor anchor, double size, String text);
}
