package dct.core.geometry;

import java.util.BitSet;
import java.util.Comparator;

/** The convex hull of some points; exact. */
public final class ConvexHull {
  private final Points points;
  private final int[] corner; // counter-clockwise; two where all points lie on one line
  private int size;

  private ConvexHull(Points points, BitSet of) {
    this.points = points;
    int[] order =
        of.stream()
            .boxed()
            .sorted(Comparator.<Integer>comparingDouble(points::x).thenComparingDouble(points::y))
            .mapToInt(Integer::intValue)
            .toArray();
    corner = new int[2 * order.length + 1];
    for (int v : order) {
      add(v, 1);
    }
    int lower = size;
    for (int i = order.length - 2; i >= 0; i--) {
      add(order[i], lower);
    }
    size = Math.max(1, size - 1); // the first one again
  }

  /** Adds a corner, and takes those back, beyond the first few, that lie inside then. */
  private void add(int v, int fixed) {
    while (size > fixed && points.orient(corner[size - 2], corner[size - 1], v) <= 0) {
      size--;
    }
    corner[size++] = v;
  }

  /**
   * Whether no other point lies in the convex hull of these, its boundary included. O(n h + m log
   * m) for m of n points with h on the hull.
   *
   * @param some at least one point; all are different
   */
  public static boolean isAlone(Points points, BitSet some) {
    ConvexHull hull = new ConvexHull(points, some);
    for (int v = some.nextClearBit(0); v < points.size(); v = some.nextClearBit(v + 1)) {
      if (hull.contains(v)) {
        return false;
      }
    }
    return true;
  }

  private boolean contains(int v) {
    for (int i = 0; i < size; i++) {
      if (points.orient(corner[i], corner[i + 1 == size ? 0 : i + 1], v) < 0) {
        return false;
      }
    }
    return size > 2 || isBetween(v);
  }

  /** Whether a point on the line of two corners is between them, or is the only one. */
  private boolean isBetween(int v) {
    int last = corner[size - 1];
    return isBetween(points.x(corner[0]), points.x(v), points.x(last))
        && isBetween(points.y(corner[0]), points.y(v), points.y(last));
  }

  private static boolean isBetween(double low, double value, double high) {
    return Math.min(low, high) <= value && value <= Math.max(low, high);
  }
}
