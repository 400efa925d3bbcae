package dct.core.geometry;

import dct.core.Progress;

/**
 * The order of points by y, then x: that of a sweep line turned by an infinitesimal angle, so that
 * no two different points are level.
 *
 * <p>Radix sort of the bits of the coordinates, O(n) time and space; stable, so that equal points
 * keep the order of their numbers.
 */
public final class PlaneOrder {
  private static final int DIGIT_BITS = 11;
  private static final int DIGITS = (Long.SIZE + DIGIT_BITS - 1) / DIGIT_BITS;
  private static final int RADIX = 1 << DIGIT_BITS;

  private PlaneOrder() {}

  /**
   * The numbers of the points, lowest first.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static int[] byYThenX(Points points, Progress progress) {
    int n = points.size();
    int[] order = new int[n];
    long[] keys = new long[n];
    for (int i = 0; i < n; i++) {
      Progress.check(progress, i);
      order[i] = i;
      keys[i] = sortable(points.x(i));
    }
    order = sorted(order, keys, progress);
    for (int i = 0; i < n; i++) {
      Progress.check(progress, i);
      keys[i] = sortable(points.y(i));
    }
    return sorted(order, keys, progress);
  }

  /** Bits that compare, as an unsigned number, as the finite double does. */
  private static long sortable(double value) {
    long bits = Double.doubleToRawLongBits(value);
    return bits ^ ((bits >> 63) | Long.MIN_VALUE);
  }

  /** The numbers in {@code order}, stably sorted by {@code keys[number]}; reuses the array. */
  private static int[] sorted(int[] order, long[] keys, Progress progress) {
    int[][] counts = histograms(keys, progress);
    int[] from = order;
    int[] to = new int[order.length];
    for (int digit = 0; digit < DIGITS; digit++) {
      if (startOffsets(counts[digit], order.length)) {
        scatter(from, to, keys, digit, counts[digit], progress);
        int[] swap = from;
        from = to;
        to = swap;
      }
    }
    return from;
  }

  private static int[][] histograms(long[] keys, Progress progress) {
    int[][] counts = new int[DIGITS][RADIX];
    for (int i = 0; i < keys.length; i++) {
      Progress.check(progress, i);
      for (int digit = 0; digit < DIGITS; digit++) {
        counts[digit][digitOf(keys[i], digit)]++;
      }
    }
    return counts;
  }

  /** Turns counts into first positions; false if all keys have the same digit. */
  private static boolean startOffsets(int[] counts, int n) {
    int start = 0;
    for (int d = 0; d < RADIX; d++) {
      int count = counts[d];
      if (count == n) {
        return false;
      }
      counts[d] = start;
      start += count;
    }
    return true;
  }

  private static void scatter(
      int[] from, int[] to, long[] keys, int digit, int[] next, Progress progress) {
    for (int k = 0; k < from.length; k++) {
      Progress.check(progress, k);
      int i = from[k];
      to[next[digitOf(keys[i], digit)]++] = i;
    }
  }

  private static int digitOf(long key, int digit) {
    return (int) (key >>> (digit * DIGIT_BITS)) & (RADIX - 1);
  }
}
