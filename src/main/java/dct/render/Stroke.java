package dct.render;

/**
 * How lines and shapes are drawn.
 *
 * @param ink the colour
 * @param width the width of lines, in pixels
 * @param dashed whether lines are dashed
 */
public record Stroke(Ink ink, double width, boolean dashed) {

  /** A solid stroke. */
  public static Stroke solid(Ink ink, double width) {
    return new Stroke(ink, width, false);
  }

  /** A dashed stroke. */
  public static Stroke dashed(Ink ink, double width) {
    return new Stroke(ink, width, true);
  }

  /** The same for filled shapes, where width plays no part. */
  public static Stroke fill(Ink ink) {
    return new Stroke(ink, 1, false);
  }
}
