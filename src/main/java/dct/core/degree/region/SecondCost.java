package dct.core.degree.region;

import dct.core.degree.Preference;
import dct.core.geometry.Box;
import dct.core.geometry.Points;
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
  private static final int DOUBLE_BITS = 63; // of the range from there to infinity

  private final Preference preference;
  private final Points points;
  private final int[] vertex; // by position
  private final int bits;
  private final double scale; // of lengths

  /**
   * The costs in a polygon.
   *
   * @param vertex by position on the counter-clockwise walk
   * @param bits at least 32
   */
  SecondCost(Preference preference, Points points, int[] vertex, int bits) {
    this.preference = preference;
    this.points = points;
    this.vertex = vertex.clone();
    this.bits = bits;
    scale = preference.kind() == Preference.Kind.LENGTH ? scale() : 0;
  }

  private double scale() {
    double[] x = Arrays.stream(vertex).mapToDouble(points::x).toArray();
    double[] y = Arrays.stream(vertex).mapToDouble(points::y).toArray();
    Box box = Box.of(Points.of(x, y));
    double longest = Preference.length(box.maxX() - box.minX(), box.maxY() - box.minY());
    int forOne = bits - Integer.SIZE + Integer.numberOfLeadingZeros(vertex.length);
    return Math.scalb(1.0, forOne - 1) / longest;
  }

  /** Whether the largest cost of a triangle counts, rather than the sum of those of the chords. */
  boolean isLargest() {
    return preference.kind() == Preference.Kind.ANGLE;
  }

  /** What the chord between two positions costs. */
  long ofChord(int i, int j) {
    int u = vertex[i];
    int v = vertex[j];
    return switch (preference.kind()) {
      case ANGLE -> 0;
      case LENGTH ->
          Math.round(
              scale * Preference.length(points.x(u) - points.x(v), points.y(u) - points.y(v)));
      case KEPT -> preference.isGiven(u, v) ? 0 : 1;
    };
  }

  /** What a triangle costs, counter-clockwise by position. */
  long ofTriangle(int i, int k, int j) {
    int a = vertex[i];
    int b = vertex[k];
    int c = vertex[j];
    double cotangent =
        SmallestAngle.cotangent(
            points.x(a), points.y(a), points.x(b), points.y(b), points.x(c), points.y(c));
    return (Double.doubleToRawLongBits(cotangent) - LEAST) >>> (DOUBLE_BITS - bits);
  }
}
