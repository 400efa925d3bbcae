package dct.core.degree.region;

import dct.core.degree.Preference;
import dct.core.geometry.Box;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.SmallestAngle;
import java.util.Arrays;

/**
 * What a {@link PreferredTable} compares where the counts of unmet vertices are equal, in whole
 * numbers of so many bits: the less, the better.
 *
 * <p>Costs of chords are added, and lengths are rounded to a grid for that; the sum of all stays
 * below 2 to the number of bits. Costs of triangles, of which the largest counts, are the leading
 * bits of the cotangent of the smallest angle.
 */
final class SecondCost {
  private static final long LEAST = Double.doubleToRawLongBits(0.5); // below every cotangent
  private static final int COUNT_END = 60; // counts end below this bit
  private static final int DOUBLE_BITS = 63; // of the range from there to infinity

  private final Preference preference;
  private final double[] x; // by position
  private final double[] y;
  private final int[] vertex; // by position: its number in triangulations
  private final int bits;
  private final double scale; // of lengths

  /**
   * The costs in polygons whose coordinates and numbers stand in these arrays when they are asked
   * for, by position on the counter-clockwise walk.
   *
   * @param bits at least 32
   * @param longest no chord is longer
   */
  SecondCost(
      Preference preference, double[] x, double[] y, int[] vertex, int bits, double longest) {
    this.preference = preference;
    this.x = x;
    this.y = y;
    this.vertex = vertex;
    this.bits = bits;
    int bitsOfOne = bits - Integer.SIZE + Integer.numberOfLeadingZeros(x.length);
    scale = Math.scalb(1.0, bitsOfOne - 1) / longest;
  }

  /** The costs in one polygon. */
  static SecondCost of(Preference preference, SimplePolygon polygon) {
    int[] vertex = polygon.walk();
    double[] x = Arrays.stream(vertex).mapToDouble(polygon.points()::x).toArray();
    double[] y = Arrays.stream(vertex).mapToDouble(polygon.points()::y).toArray();
    int bits = bitsBeside(vertex.length);
    return new SecondCost(preference, x, y, vertex, bits, longest(x, y));
  }

  /** How many bits a long has left beside a count of so many vertices. */
  static int bitsBeside(int vertices) {
    return COUNT_END - Integer.SIZE + Integer.numberOfLeadingZeros(vertices);
  }

  /** No two of these points are farther apart. */
  static double longest(double[] x, double[] y) {
    Box box = Box.of(Points.of(x, y));
    return Preference.length(box.maxX() - box.minX(), box.maxY() - box.minY());
  }

  /** The number of bits. */
  int bits() {
    return bits;
  }

  /** Whether the largest cost of a triangle counts, rather than the sum of those of the chords. */
  boolean isLargest() {
    return preference.kind() == Preference.Kind.ANGLE;
  }

  /** What the chord between two positions costs. */
  long ofChord(int i, int j) {
    return ofEdge(x[i] - x[j], y[i] - y[j], vertex[i], vertex[j]);
  }

  /** What an edge between two vertices costs that differ by this vector. */
  long ofEdge(double dx, double dy, int u, int v) {
    return switch (preference.kind()) {
      case ANGLE -> 0;
      case LENGTH -> Math.round(scale * Preference.length(dx, dy));
      case KEPT -> preference.isGiven(u, v) ? 0 : 1;
    };
  }

  /** What a triangle costs, counter-clockwise by position. */
  long ofTriangle(int i, int k, int j) {
    return ofTriangle(x[i], y[i], x[k], y[k], x[j], y[j]);
  }

  /** What a triangle costs, counter-clockwise. */
  long ofTriangle(double ax, double ay, double bx, double by, double cx, double cy) {
    double cotangent = SmallestAngle.cotangent(ax, ay, bx, by, cx, cy);
    return (Double.doubleToRawLongBits(cotangent) - LEAST) >>> (DOUBLE_BITS - bits);
  }
}
