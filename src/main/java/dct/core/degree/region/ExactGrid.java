package dct.core.degree.region;

/**
 * Whether coordinates lie on so coarse a grid that the determinant of an orientation test has no
 * rounding error: all are multiples of one power of two, the unit, and differ by at most 2^26
 * units. Then differences are exact, their products are whole numbers of squared units up to 2^52,
 * and so is the difference of two products up to 2^53. Collinear points of a lattice are then
 * decided as fast as others.
 */
final class ExactGrid {
  private static final double MOST_UNITS = 0x1p26;
  private static final double SMALLEST_UNIT = 0x1p-400;
  private static final double LARGEST = 0x1p400;

  private ExactGrid() {}

  /** Whether these coordinates do; linear time. */
  static boolean holds(double[] x, double[] y) {
    double unit = Math.min(unit(x), unit(y));
    return unit >= SMALLEST_UNIT
        && Math.max(extent(x), extent(y)) <= MOST_UNITS * Math.min(unit, LARGEST / MOST_UNITS);
  }

  /** The largest power of two that divides every value; infinite if all are zero. */
  private static double unit(double[] values) {
    double unit = Double.POSITIVE_INFINITY;
    for (double value : values) {
      if (value != 0) {
        unit = Math.min(unit, lowestBit(value));
      }
    }
    return unit;
  }

  /** The value of the lowest bit that is set. */
  private static double lowestBit(double value) {
    long bits = Double.doubleToRawLongBits(value);
    long withoutLowest = bits & (bits - 1);
    boolean isPower = (bits << 12) == 0;
    return isPower ? Math.abs(value) : Math.abs(value - Double.longBitsToDouble(withoutLowest));
  }

  private static double extent(double[] values) {
    double low = Double.POSITIVE_INFINITY;
    double high = Double.NEGATIVE_INFINITY;
    for (double value : values) {
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    return high - low;
  }
}
