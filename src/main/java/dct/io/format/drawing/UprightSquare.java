package dct.io.format.drawing;

import dct.core.geometry.Box;
import dct.core.geometry.Points;
import java.util.Optional;

/**
 * A square with sides along the axes.
 *
 * @param x the x of its centre
 * @param y its y
 * @param radius half of its side
 */
record UprightSquare(double x, double y, double radius) {
  private static final double ROUNDING = 0.02; // of a side, in drawings of few digits

  /** The square that these are the corners of, in the order of its boundary. */
  static Optional<UprightSquare> of(Points points) {
    if (points.size() != 4) {
      return Optional.empty();
    }
    Box box = Box.of(points);
    double width = box.maxX() - box.minX();
    double height = box.maxY() - box.minY();
    for (int v = 0; v < 4; v++) {
      int next = (v + 1) % 4;
      boolean isUpright = points.x(v) == points.x(next);
      boolean isLevel = points.y(v) == points.y(next);
      boolean isAlternating = points.x(v) != points.x((v + 2) % 4);
      if (isUpright == isLevel || !isAlternating) {
        return Optional.empty();
      }
    }
    return Math.abs(width - height) > ROUNDING * width
        ? Optional.empty()
        : Optional.of(
            new UprightSquare(box.minX() + width / 2, box.minY() + height / 2, width / 2));
  }
}
