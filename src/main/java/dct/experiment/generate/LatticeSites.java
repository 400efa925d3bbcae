package dct.experiment.generate;

import dct.core.SeededRandom;
import dct.core.geometry.Points;

/** Sites on a square lattice over the area, row by row; the last row may be a part of one. */
final class LatticeSites {
  private LatticeSites() {}

  /**
   * The sites of the widest lattice with n places in this area.
   *
   * @param random where to put each site within its own square, or null for the middle
   * @throws CannotGenerateException if there are fewer than n places
   */
  static Points sites(int n, Area area, SeededRandom random) {
    Grid grid = area.grid();
    long width = width(n, grid);
    if (width == 0) {
      throw new CannotGenerateException(
          n + " sites do not fit into " + grid.places() + " places; take a larger area or fewer");
    }
    long columns = grid.columns() / width;
    long[] x = new long[n];
    long[] y = new long[n];
    for (int i = 0; i < n; i++) {
      x[i] = i % columns * width + (random == null ? width / 2 : random.nextLong(width));
      y[i] = i / columns * width + (random == null ? width / 2 : random.nextLong(width));
    }
    return grid.points(x, y);
  }

  private static long width(int n, Grid grid) {
    long width = 1 + (long) Math.sqrt((double) grid.columns() * grid.rows() / n);
    while (width > 0 && (grid.columns() / width) * (grid.rows() / width) < n) {
      width--;
    }
    return width;
  }
}
