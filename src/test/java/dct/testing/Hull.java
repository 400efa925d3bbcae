package dct.testing;

import dct.core.geometry.Points;
import java.util.Arrays;
import java.util.Comparator;

/** The boundary of the convex hull of different points, those inside its edges included. */
final class Hull {

  private Hull() {}

  /**
   * The boundary, counter-clockwise, by Andrew's chains on the order by x, then y, keeping straight
   * points. Points that all lie on one line are given in their order along it, once each.
   */
  static int[] boundary(Points p) {
    Integer[] order = new Integer[p.size()];
    Arrays.setAll(order, i -> i);
    Arrays.sort(order, Comparator.<Integer>comparingDouble(p::x).thenComparingDouble(p::y));
    int[] lower = chain(p, order);
    if (lower.length == order.length && isStraight(p, lower)) {
      return lower;
    }
    Integer[] reversed = new Integer[order.length];
    Arrays.setAll(reversed, i -> order[order.length - 1 - i]);
    int[] upper = chain(p, reversed);
    int[] ring = Arrays.copyOf(lower, lower.length + upper.length - 2);
    System.arraycopy(upper, 1, ring, lower.length, upper.length - 2);
    return ring;
  }

  /** Whether the points of a hull's boundary all lie on one line. */
  static boolean isStraight(Points p, int[] boundary) {
    for (int k = 2; k < boundary.length; k++) {
      if (Exact.orient(p, boundary[0], boundary[1], boundary[k]) != 0) {
        return false;
      }
    }
    return true;
  }

  private static int[] chain(Points p, Integer[] order) {
    int[] stack = new int[order.length];
    int size = 0;
    for (int next : order) {
      while (size >= 2 && Exact.orient(p, stack[size - 2], stack[size - 1], next) < 0) {
        size--;
      }
      stack[size++] = next;
    }
    return Arrays.copyOf(stack, size);
  }
}
