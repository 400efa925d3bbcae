package dct.core.geometry;

import dct.core.geometry.SegmentPoints.Place;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Optional;

/**
 * A straight line without ends, in exact numbers.
 *
 * @param x the x of a point on it
 * @param y the y of that point
 * @param dx along it; not both of these are zero
 * @param dy along it
 */
public record Line(BigDecimal x, BigDecimal y, BigDecimal dx, BigDecimal dy) {
  private static final MathContext DIGITS = new MathContext(40); // of a double there are 17

  /** The line through two different points, all coordinates being finite. */
  public static Line through(double ax, double ay, double bx, double by) {
    BigDecimal x = new BigDecimal(ax);
    BigDecimal y = new BigDecimal(ay);
    return new Line(x, y, new BigDecimal(bx).subtract(x), new BigDecimal(by).subtract(y));
  }

  /** The line from a point in a direction, all numbers being finite. */
  public static Line along(double x, double y, double dx, double dy) {
    return new Line(new BigDecimal(x), new BigDecimal(y), new BigDecimal(dx), new BigDecimal(dy));
  }

  /**
   * Where it crosses another line: each coordinate is the double nearest to the exact one, so that
   * it lies on a level or upright line exactly. Nothing if they are parallel.
   */
  public Optional<Place> crossing(Line other) {
    BigDecimal denominator = cross(dx, dy, other.dx, other.dy);
    if (denominator.signum() == 0) {
      return Optional.empty();
    }
    BigDecimal numerator = cross(other.x.subtract(x), other.y.subtract(y), other.dx, other.dy);
    double atX = at(x, dx, numerator, denominator);
    double atY = at(y, dy, numerator, denominator);
    boolean finite = Double.isFinite(atX) && Double.isFinite(atY);
    return finite ? Optional.of(new Place(atX, atY)) : Optional.empty();
  }

  private static double at(BigDecimal from, BigDecimal step, BigDecimal n, BigDecimal d) {
    return from.multiply(d).add(step.multiply(n)).divide(d, DIGITS).doubleValue();
  }

  private static BigDecimal cross(BigDecimal ax, BigDecimal ay, BigDecimal bx, BigDecimal by) {
    return ax.multiply(by).subtract(ay.multiply(bx));
  }
}
