package dct.experiment.generate;

import dct.core.SeededRandom;
import dct.core.geometry.Points;

/** Places of a grid, all different, with exact tests; their coordinates are below 2^28. */
final class Places {
  private final Grid grid;
  private final int[] x;
  private final int[] y;

  private Places(Grid grid, int[] x, int[] y) {
    this.grid = grid;
    this.x = x;
    this.y = y;
  }

  /**
   * Draws n different places uniformly, in random order, in O(n) unless nearly all are taken.
   *
   * @throws CannotGenerateException if there are fewer
   */
  static Places distinct(int n, Grid grid, SeededRandom random) {
    if (n > grid.places()) {
      throw new CannotGenerateException(
          n + " points do not fit into " + grid.places() + " places; take a larger area or fewer");
    }
    PlaceSet taken = new PlaceSet(grid, n);
    int[] x = new int[n];
    int[] y = new int[n];
    for (int i = 0; i < n; ) {
      x[i] = random.nextInt((int) grid.columns());
      y[i] = random.nextInt((int) grid.rows());
      i += taken.add(x[i], y[i]) ? 1 : 0;
    }
    return new Places(grid, x, y);
  }

  /**
   * Draws n ≥ 3 different places uniformly that do not all lie on one line.
   *
   * @throws CannotGenerateException if there are none
   */
  static Places spread(int n, Grid grid, SeededRandom random) {
    if (Math.min(grid.columns(), grid.rows()) < 2) {
      throw new CannotGenerateException(
          "all places of the area lie on one line; take an area of two rows and columns or more");
    }
    Places places;
    do {
      places = distinct(n, grid, random);
    } while (places.areOnOneLine());
    return places;
  }

  private boolean areOnOneLine() {
    for (int i = 2; i < x.length; i++) {
      if (turn(0, 1, i) != 0) {
        return false;
      }
    }
    return true;
  }

  int size() {
    return x.length;
  }

  int x(int i) {
    return x[i];
  }

  int y(int i) {
    return y[i];
  }

  /** How far b lies to the right of a. */
  long dx(int a, int b) {
    return (long) x[b] - x[a];
  }

  /** How far b lies above a. */
  long dy(int a, int b) {
    return (long) y[b] - y[a];
  }

  /** The turn from a by b to c: positive to the left, negative to the right, zero on a line. */
  long turn(int a, int b, int c) {
    return dx(a, b) * dy(a, c) - dy(a, b) * dx(a, c);
  }

  /** For places on one line: whether v lies between a and b, and is neither. */
  boolean isBetween(int v, int a, int b) {
    return v != a
        && v != b
        && Math.min(x[a], x[b]) <= x[v]
        && x[v] <= Math.max(x[a], x[b])
        && Math.min(y[a], y[b]) <= y[v]
        && y[v] <= Math.max(y[a], y[b]);
  }

  /** The points in the order in which they were drawn. */
  Points points() {
    int[] order = new int[x.length];
    for (int i = 0; i < order.length; i++) {
      order[i] = i;
    }
    return points(order);
  }

  /** The points in this order. */
  Points points(int[] order) {
    long[] xs = new long[order.length];
    long[] ys = new long[order.length];
    for (int k = 0; k < order.length; k++) {
      xs[k] = x[order[k]];
      ys[k] = y[order[k]];
    }
    return grid.points(xs, ys);
  }
}
