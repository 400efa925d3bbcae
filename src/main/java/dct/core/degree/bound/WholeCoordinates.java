package dct.core.degree.bound;

import dct.core.Progress;
import dct.core.geometry.Points;
import java.util.Optional;

/**
 * Points whose coordinates are whole multiples of one power of two and less than 2³⁰ of it apart,
 * so that areas can be computed exactly in 64 bits.
 */
final class WholeCoordinates {
  private static final long EXTENT = 1L << 30;
  private static final int LARGEST =
      62; // bits of a coordinate before the first point is subtracted
  private static final int MANTISSA_BITS = 52;

  private final long[] x; // from the first point, in units
  private final long[] y;

  private WholeCoordinates(long[] x, long[] y) {
    this.x = x;
    this.y = y;
  }

  /**
   * The points in units, if they have such coordinates.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static Optional<WholeCoordinates> of(Points points, Progress progress) {
    int unit = Integer.MAX_VALUE;
    int largest = Integer.MIN_VALUE;
    for (int i = 0; i < points.size(); i++) {
      Progress.check(progress, i);
      unit = Math.min(unit, Math.min(lowestBit(points.x(i)), lowestBit(points.y(i))));
      double magnitude = Math.max(Math.abs(points.x(i)), Math.abs(points.y(i)));
      largest = Math.max(largest, Math.getExponent(magnitude));
      if (largest - (long) unit >= LARGEST) {
        return Optional.empty();
      }
    }
    return inUnits(points, unit, progress);
  }

  /** The exponent of the lowest bit that is set; a large number for zero. */
  private static int lowestBit(double value) {
    if (value == 0) {
      return Integer.MAX_VALUE;
    }
    long mantissa = Double.doubleToRawLongBits(value) & ((1L << MANTISSA_BITS) - 1);
    int zeros = Math.min(MANTISSA_BITS, Long.numberOfTrailingZeros(mantissa));
    return Math.max(Math.getExponent(value), Double.MIN_EXPONENT) - MANTISSA_BITS + zeros;
  }

  private static Optional<WholeCoordinates> inUnits(Points points, int unit, Progress progress) {
    long[] x = new long[points.size()];
    long[] y = new long[points.size()];
    for (int i = 0; i < x.length; i++) {
      Progress.check(progress, i);
      x[i] = (long) Math.scalb(points.x(i), -unit) - (i == 0 ? 0 : x[0]);
      y[i] = (long) Math.scalb(points.y(i), -unit) - (i == 0 ? 0 : y[0]);
      if (i > 0 && (Math.abs(x[i]) >= EXTENT || Math.abs(y[i]) >= EXTENT)) {
        return Optional.empty();
      }
    }
    x[0] = 0;
    y[0] = 0;
    return Optional.of(new WholeCoordinates(x, y));
  }

  /** Twice the signed area of the triangle abc. */
  long cross(int a, int b, int c) {
    return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
  }
}
