package dct.core.geometry;

import dct.core.Progress;
import java.util.Arrays;

/**
 * Points in the order of a Hilbert curve through their box, so that points near in the order are
 * near in the plane. Points in the same of 65,536² cells keep the order of their numbers. O(n log
 * n) time.
 */
public final class HilbertOrder {
  private static final int BITS = 16;
  private static final int SIDE = 1 << BITS;

  private HilbertOrder() {}

  /**
   * The numbers of the points in this order.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static int[] of(Points points, Progress progress) {
    double[] x = points.xs();
    double[] y = points.ys();
    double left = min(x);
    double low = min(y);
    double scale = scale(Math.max(max(x) - left, max(y) - low));
    long[] keys = new long[x.length];
    for (int i = 0; i < keys.length; i++) {
      Progress.check(progress, i);
      keys[i] = key(cell((x[i] - left) * scale), cell((y[i] - low) * scale)) << 31 | i;
    }
    Arrays.parallelSort(keys);
    progress.checkCancelled();
    int[] order = new int[keys.length];
    for (int k = 0; k < order.length; k++) {
      order[k] = (int) (keys[k] & Integer.MAX_VALUE);
    }
    return order;
  }

  private static double scale(double extent) {
    double scale = (SIDE - 1) / extent;
    return Double.isFinite(scale) ? scale : 0;
  }

  private static int cell(double value) {
    return Math.min(SIDE - 1, (int) value);
  }

  private static double min(double[] values) {
    return Arrays.stream(values).min().orElse(0);
  }

  private static double max(double[] values) {
    return Arrays.stream(values).max().orElse(0);
  }

  /**
   * The place of a cell along the curve. A quarter of the square is walked as the whole is, but
   * some with the axes swapped and some also turned round; no branch, for none could be predicted.
   */
  private static long key(int column, int row) {
    long key = 0;
    int swapped = 0;
    int turned = 0;
    for (int bit = BITS - 1; bit >= 0; bit--) {
      int x = (column >> bit) & 1;
      int y = (row >> bit) & 1;
      int exchange = (x ^ y) & swapped;
      int right = x ^ exchange ^ turned;
      int up = y ^ exchange ^ turned;
      key = key << 2 | ((3 * right) ^ up);
      turned ^= right & (up ^ 1);
      swapped ^= up ^ 1;
    }
    return key;
  }
}
