package dct.core.geometry;

import java.util.Arrays;

/**
 * A list of points in the plane, in the order entered; immutable.
 *
 * <p>Coordinates are finite and are those of the file: no unit, no direction of y is implied.
 * Negative zero is stored as zero, so that equal points have equal bits.
 */
public final class Points {
  /** In place of a point's number: there is none. */
  public static final int NONE = -1;

  private final double[] x;
  private final double[] y;

  private Points(double[] x, double[] y) {
    this.x = x;
    this.y = y;
  }

  /**
   * The points (x[0], y[0]), (x[1], y[1]), …; the arrays are copied.
   *
   * @throws IllegalArgumentException if the lengths differ or a coordinate is not finite
   */
  public static Points of(double[] x, double[] y) {
    if (x.length != y.length) {
      throw new IllegalArgumentException(x.length + " x-coordinates, " + y.length + " y");
    }
    return new Points(cleaned(x), cleaned(y));
  }

  /** The points given as x0, y0, x1, y1, …. */
  public static Points ofPairs(double... pairs) {
    double[] x = new double[pairs.length / 2];
    double[] y = new double[pairs.length / 2];
    for (int i = 0; i < x.length; i++) {
      x[i] = pairs[2 * i];
      y[i] = pairs[2 * i + 1];
    }
    return of(x, y);
  }

  private static double[] cleaned(double[] values) {
    double[] copy = new double[values.length];
    for (int i = 0; i < values.length; i++) {
      if (!Double.isFinite(values[i])) {
        throw new IllegalArgumentException("coordinate " + i + " is " + values[i]);
      }
      copy[i] = values[i] + 0.0; // -0.0 + 0.0 is 0.0
    }
    return copy;
  }

  /** The number of points. */
  public int size() {
    return x.length;
  }

  /** The x-coordinate of point i. */
  public double x(int i) {
    return x[i];
  }

  /** The y-coordinate of point i. */
  public double y(int i) {
    return y[i];
  }

  /** A copy of all x-coordinates. */
  public double[] xs() {
    return x.clone();
  }

  /** A copy of all y-coordinates. */
  public double[] ys() {
    return y.clone();
  }

  /** Whether points i and j have the same coordinates. */
  public boolean same(int i, int j) {
    return x[i] == x[j] && y[i] == y[j];
  }

  /** {@link Predicates#orient} of the points a, b, c. */
  public int orient(int a, int b, int c) {
    return Predicates.orient(x[a], y[a], x[b], y[b], x[c], y[c]);
  }

  /** {@link Predicates#inCircle} of the points a, b, c, d. */
  public int inCircle(int a, int b, int c, int d) {
    return Predicates.inCircle(x[a], y[a], x[b], y[b], x[c], y[c], x[d], y[d]);
  }

  /** Whether a lies before b in the order by y, then x. */
  public boolean yxLess(int a, int b) {
    return y[a] < y[b] || (y[a] == y[b] && x[a] < x[b]);
  }

  /** These points with (px, py) inserted as number {@code index}. */
  public Points inserted(int index, double px, double py) {
    return of(inserted(x, index, px), inserted(y, index, py));
  }

  private static double[] inserted(double[] values, int index, double value) {
    double[] longer = Arrays.copyOf(values, values.length + 1);
    System.arraycopy(values, index, longer, index + 1, values.length - index);
    longer[index] = value;
    return longer;
  }

  /** These points without number {@code index}. */
  public Points removed(int index) {
    return new Points(removed(x, index), removed(y, index));
  }

  private static double[] removed(double[] values, int index) {
    double[] shorter = Arrays.copyOf(values, values.length - 1);
    System.arraycopy(values, index + 1, shorter, index, shorter.length - index);
    return shorter;
  }

  /** These points with number {@code index} moved to (px, py). */
  public Points moved(int index, double px, double py) {
    Points moved = new Points(x.clone(), y.clone());
    moved.x[index] = cleaned(new double[] {px})[0];
    moved.y[index] = cleaned(new double[] {py})[0];
    return moved;
  }

  /**
   * The number of the only point that is elsewhere in the other list; {@link #NONE} if there is no
   * such point, or more than one, or the lists differ in length.
   */
  public int onlyDifference(Points that) {
    if (size() != that.size()) {
      return NONE;
    }
    int first = firstDifference(that, 0);
    return first >= 0 && firstDifference(that, first + 1) < 0 ? first : NONE;
  }

  private int firstDifference(Points that, int from) {
    int byX = Arrays.mismatch(x, from, x.length, that.x, from, x.length);
    int end = byX < 0 ? x.length : from + byX;
    int byY = Arrays.mismatch(y, from, end, that.y, from, end);
    return byY >= 0 ? from + byY : byX >= 0 ? end : NONE;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Points that && Arrays.equals(x, that.x) && Arrays.equals(y, that.y);
  }

  @Override
  public int hashCode() {
    return 31 * Arrays.hashCode(x) + Arrays.hashCode(y);
  }

  @Override
  public String toString() {
    return size() + " points";
  }
}
