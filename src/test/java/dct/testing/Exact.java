package dct.testing;

import dct.core.geometry.Points;
import java.math.BigInteger;

/**
 * Exact geometry for tests, independent of the code under test: a generous floating filter, then
 * whole numbers. Every finite double is a whole multiple of some power of two, so that scaling all
 * arguments by one power makes them integers.
 */
public final class Exact {
  private static final double FILTER = 1e-13; // far above the rounding error of either determinant
  private static final double LEAST = 1e-100; // below this a product may have underflowed
  private static final double MOST = 1e300;

  private Exact() {}

  /** The turn a, b, c among these points: −1, 0 or 1. */
  public static int orient(Points p, int a, int b, int c) {
    return orient(p.x(a), p.y(a), p.x(b), p.y(b), p.x(c), p.y(c));
  }

  /** The sign of the doubled area of the triangle a, b, c. */
  public static int orient(double ax, double ay, double bx, double by, double cx, double cy) {
    double left = (bx - ax) * (cy - ay);
    double right = (by - ay) * (cx - ax);
    double size = Math.abs(left) + Math.abs(right);
    if (size > LEAST && size < MOST && Math.abs(left - right) > FILTER * size) {
      return left > right ? 1 : -1;
    }
    BigInteger[] v = scaled(ax, ay, bx, by, cx, cy);
    return cross(v[2].subtract(v[0]), v[3].subtract(v[1]), v[4].subtract(v[0]), v[5].subtract(v[1]))
        .signum();
  }

  /** Whether d lies inside (1), on (0) or outside (−1) the circle through counter-clockwise abc. */
  public static int inCircle(Points p, int a, int b, int c, int d) {
    return inCircle(p.x(a), p.y(a), p.x(b), p.y(b), p.x(c), p.y(c), p.x(d), p.y(d));
  }

  /** The sign of the in-circle determinant. */
  public static int inCircle(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
    double u = square(ax - dx, ay - dy);
    double v = square(bx - dx, by - dy);
    double w = square(cx - dx, cy - dy);
    double a = u * ((bx - dx) * (cy - dy) - (by - dy) * (cx - dx));
    double b = v * ((cx - dx) * (ay - dy) - (cy - dy) * (ax - dx));
    double c = w * ((ax - dx) * (by - dy) - (ay - dy) * (bx - dx));
    // |x y'| is at most the larger square, so that this bounds the rounding of the cross products.
    double size = u * Math.max(v, w) + v * Math.max(u, w) + w * Math.max(u, v);
    if (size > LEAST && size < MOST && Math.abs(a + b + c) > FILTER * size) {
      return a + b + c > 0 ? 1 : -1;
    }
    return inCircle(scaled(ax, ay, bx, by, cx, cy, dx, dy));
  }

  private static double square(double x, double y) {
    return x * x + y * y;
  }

  private static int inCircle(BigInteger[] v) {
    BigInteger[] x = new BigInteger[3];
    BigInteger[] y = new BigInteger[3];
    for (int i = 0; i < 3; i++) {
      x[i] = v[2 * i].subtract(v[6]);
      y[i] = v[2 * i + 1].subtract(v[7]);
    }
    BigInteger sum = BigInteger.ZERO;
    for (int i = 0; i < 3; i++) {
      int j = (i + 1) % 3;
      int k = (i + 2) % 3;
      BigInteger lift = x[i].multiply(x[i]).add(y[i].multiply(y[i]));
      sum = sum.add(lift.multiply(cross(x[j], y[j], x[k], y[k])));
    }
    return sum.signum();
  }

  /** u × v. */
  static BigInteger cross(BigInteger ux, BigInteger uy, BigInteger vx, BigInteger vy) {
    return ux.multiply(vy).subtract(uy.multiply(vx));
  }

  /** All values times one power of two that makes them integers. */
  static BigInteger[] scaled(double... values) {
    int lowest = Integer.MAX_VALUE;
    for (double value : values) {
      lowest = Math.min(lowest, exponentOfLastBit(value));
    }
    BigInteger[] integers = new BigInteger[values.length];
    for (int i = 0; i < values.length; i++) {
      int exponent = exponentOfLastBit(values[i]);
      long mantissa = mantissa(values[i]);
      integers[i] =
          mantissa == 0
              ? BigInteger.ZERO
              : BigInteger.valueOf(mantissa).shiftLeft(exponent - lowest);
    }
    return integers;
  }

  private static long mantissa(double value) {
    long bits = Double.doubleToRawLongBits(value);
    long fraction = bits & 0xFFFFFFFFFFFFFL;
    long mantissa = (bits & 0x7FF0000000000000L) == 0 ? fraction : fraction | 0x10000000000000L;
    long odd = mantissa == 0 ? 0 : mantissa >> Long.numberOfTrailingZeros(mantissa);
    return bits < 0 ? -odd : odd;
  }

  private static int exponentOfLastBit(double value) {
    if (value == 0) {
      return Integer.MAX_VALUE;
    }
    long bits = Double.doubleToRawLongBits(value);
    long fraction = bits & 0xFFFFFFFFFFFFFL;
    int biased = (int) ((bits >> 52) & 0x7FF);
    long mantissa = biased == 0 ? fraction : fraction | 0x10000000000000L;
    return Math.max(biased, 1) - 1075 + Long.numberOfTrailingZeros(mantissa);
  }
}
