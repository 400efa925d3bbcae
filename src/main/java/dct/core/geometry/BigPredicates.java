package dct.core.geometry;

import java.math.BigDecimal;

/** The determinants of {@link Predicates} in decimal arithmetic of any length, slow and certain. */
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

  static BigDecimal minus(double p, double q) {
    return new BigDecimal(p).subtract(new BigDecimal(q));
  }

  private static BigDecimal lift(BigDecimal x, BigDecimal y) {
    return x.multiply(x).add(y.multiply(y));
  }

  static BigDecimal cross(BigDecimal ux, BigDecimal uy, BigDecimal vx, BigDecimal vy) {
    return ux.multiply(vy).subtract(vx.multiply(uy));
  }
}
