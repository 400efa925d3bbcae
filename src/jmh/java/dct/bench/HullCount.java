package dct.bench;

import dct.core.geometry.Predicates;
import java.util.Arrays;

/** The number of different sites on the boundary of the convex hull, by Andrew's monotone chain. */
final class HullCount {
  private HullCount() {}

  static int of(double[] x, double[] y) {
    Integer[] order = new Integer[x.length];
    Arrays.setAll(order, i -> i);
    Arrays.parallelSort(
        order, (i, j) -> x[i] == x[j] ? Double.compare(y[i], y[j]) : Double.compare(x[i], x[j]));
    return chain(x, y, order, 1) + chain(x, y, order, -1) - 2;
  }

  /** The sites on the lower (sign 1) or upper (−1) chain, those within its edges included. */
  private static int chain(double[] x, double[] y, Integer[] order, int sign) {
    int[] stack = new int[order.length];
    int size = 0;
    for (int v : order) {
      while (size > 1 && sign * turn(x, y, stack[size - 2], stack[size - 1], v) < 0) {
        size--;
      }
      stack[size++] = v;
    }
    return size;
  }

  private static int turn(double[] x, double[] y, int a, int b, int c) {
    return Predicates.orient(x[a], y[a], x[b], y[b], x[c], y[c]);
  }
}
