package dct.core.geometry;

/**
 * The smallest angle of a triangle, by its cotangent: the larger that is, the smaller the angle.
 *
 * <p>Only sums, products and quotients are used, so that all machines agree on every bit; the
 * result does not depend on the corner named first.
 */
public final class SmallestAngle {
  private static final double LARGE = 0x1p600; // squares, so that their products do not overflow
  private static final double SMALL = 0x1p-600;

  private SmallestAngle() {}

  /**
   * The cotangent of the smallest angle of a triangle that is counter-clockwise, at least about
   * 0.577; infinite for one so flat that its area vanishes in floating point.
   */
  public static double cotangent(double ax, double ay, double bx, double by, double cx, double cy) {
    double px = bx - ax;
    double py = by - ay;
    double qx = cx - bx;
    double qy = cy - by;
    double rx = ax - cx;
    double ry = ay - cy;
    double p = px * px + py * py;
    double q = qx * qx + qy * qy;
    double r = rx * rx + ry * ry;
    double size = Math.max(p, Math.max(q, r));
    if (!(size < LARGE && size > SMALL)) {
      return scaled(ax, ay, bx, by, cx, cy);
    }
    double cotangent = Double.NEGATIVE_INFINITY;
    if (p <= q && p <= r) { // the smallest angle is opposite the shortest side
      cotangent = at(rx, ry, qx, qy);
    }
    if (q <= p && q <= r) {
      cotangent = Math.max(cotangent, at(px, py, rx, ry));
    }
    if (r <= p && r <= q) {
      cotangent = Math.max(cotangent, at(qx, qy, px, py));
    }
    return cotangent;
  }

  /** Of a triangle of ordinary size and the same form, but for what underflows. */
  private static double scaled(double ax, double ay, double bx, double by, double cx, double cy) {
    double half = 0.5; // so that no difference overflows
    double px = half * bx - half * ax;
    double py = half * by - half * ay;
    double qx = half * cx - half * ax;
    double qy = half * cy - half * ay;
    double size =
        Math.max(Math.max(Math.abs(px), Math.abs(py)), Math.max(Math.abs(qx), Math.abs(qy)));
    if (size == 0) {
      return Double.POSITIVE_INFINITY;
    }
    int power = -Math.getExponent(size);
    return cotangent(
        0,
        0,
        Math.scalb(px, power),
        Math.scalb(py, power),
        Math.scalb(qx, power),
        Math.scalb(qy, power));
  }

  /** The cotangent of the angle between the edge that leaves a corner and the one that comes in. */
  private static double at(double outX, double outY, double inX, double inY) {
    double dot = -outX * inX - outY * inY;
    double cross = outY * inX - outX * inY;
    if (cross > 0) {
      return dot / cross;
    }
    return dot > 0 ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY;
  }

  /** The angle in degrees that has this cotangent. */
  public static double degrees(double cotangent) {
    return StrictMath.toDegrees(StrictMath.atan(1 / cotangent));
  }
}
