package dct.core.geometry;

import java.math.BigDecimal;
import java.math.MathContext;

/**
 * The determinants of {@link Predicates} in decimal arithmetic of any length, slow and certain; and
 * the point where two segments cross, at every scale.
 */
final class BigPredicates {

  private BigPredicates() {}

  static int orient(double ax, double ay, double bx, double by, double cx, double cy) {
    return cross(minus(ax, cx), minus(ay, cy), minus(bx, cx), minus(by, cy)).signum();
  }

  static int inCircle(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
    BigDecimal adx = minus(ax, dx);
    BigDecimal ady = minus(ay, dy);
    BigDecimal bdx = minus(bx, dx);
    BigDecimal bdy = minus(by, dy);
    BigDecimal cdx = minus(cx, dx);
    BigDecimal cdy = minus(cy, dy);
    BigDecimal a = lift(adx, ady).multiply(cross(bdx, bdy, cdx, cdy));
    BigDecimal b = lift(bdx, bdy).multiply(cross(cdx, cdy, adx, ady));
    BigDecimal c = lift(cdx, cdy).multiply(cross(adx, ady, bdx, bdy));
    return a.add(b).add(c).signum();
  }

  /** Where the segments ab and cd, which cross, do so: x and y, rounded. */
  static double[] crossing(Points p, int a, int b, int c, int d) {
    BigDecimal ux = minus(p.x(b), p.x(a));
    BigDecimal uy = minus(p.y(b), p.y(a));
    BigDecimal vx = minus(p.x(d), p.x(c));
    BigDecimal vy = minus(p.y(d), p.y(c));
    BigDecimal top = cross(minus(p.x(c), p.x(a)), minus(p.y(c), p.y(a)), vx, vy);
    BigDecimal bottom = cross(ux, uy, vx, vy);
    double x = along(p.x(a), ux, top, bottom);
    double y = along(p.y(a), uy, top, bottom);
    return new double[] {x, y};
  }

  /** from + step · top / bottom, divided last so that only the result is rounded. */
  private static double along(double from, BigDecimal step, BigDecimal top, BigDecimal bottom) {
    BigDecimal sum = new BigDecimal(from).multiply(bottom).add(step.multiply(top));
    return sum.divide(bottom, MathContext.DECIMAL128).doubleValue();
  }

  private static BigDecimal minus(double p, double q) {
    return new BigDecimal(p).subtract(new BigDecimal(q));
  }

  private static BigDecimal lift(BigDecimal x, BigDecimal y) {
    return x.multiply(x).add(y.multiply(y));
  }

  private static BigDecimal cross(BigDecimal ux, BigDecimal uy, BigDecimal vx, BigDecimal vy) {
    return ux.multiply(vy).subtract(vx.multiply(uy));
  }
}
