package dct.core.geometry;

/**
 * The smallest angle of a triangle, by its cotangent: the larger that is, the smaller the angle.
 *
 * <p>Only sums, products and quotients are used, so that all machines agree on every bit; the
 * result does not depend on the corner named first.
 */
public final class SmallestAngle {
  private static final double LARGE = 0x1p300; // squares of what is less do not overflow
  private static final double SMALL = 0x1p-300;

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
    double size = Math.max(largest(px, py), Math.max(largest(qx, qy), largest(rx, ry)));
    if (size > LARGE || size < SMALL) {
      double s = Math.scalb(1.0, size > LARGE ? -Math.getExponent(size) : Double.MAX_EXPONENT / 2);
      return cotangent(s * ax, s * ay, s * bx, s * by, s * cx, s * cy);
    }
    return Math.max(at(px, py, rx, ry), Math.max(at(qx, qy, px, py), at(rx, ry, qx, qy)));
  }

  private static double largest(double x, double y) {
    return Math.max(Math.abs(x), Math.abs(y));
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
