package dct.experiment.generate;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.Points;

/**
 * A comb: pointed teeth of random length and width on a straight back, as in V. Chvátal's "A
 * combinatorial theorem in plane geometry" (1975), where each tooth needs a guard of its own.
 *
 * <p>Tips lie in the upper third of the area and gaps in the lower, so that the teeth are long;
 * they go back in x, which keeps them apart. O(n) time.
 */
final class Comb {
  private Comb() {}

  /** A counter-clockwise polygon of n vertices that begins with its back. */
  static Points polygon(int n, Area area, SeededRandom random, Progress progress) {
    Grid grid = area.grid();
    String what = "a comb of " + n + " vertices";
    Strata.check(Math.max(n - 2, 2), grid.columns(), what);
    Strata.check(3, grid.rows(), what);
    int[] column = Strata.increasing(n - 2, grid.columns(), random);
    long third = grid.rows() / 3;
    long[] x = new long[n];
    long[] y = new long[n];
    x[1] = grid.columns() - 1;
    for (int k = 2; k < n; k++) {
      long depth = random.nextLong(third);
      x[k] = column[n - 1 - k];
      y[k] = k % 2 == 0 ? grid.rows() - 1 - depth : 1 + depth;
    }
    return grid.points(x, y);
  }
}
