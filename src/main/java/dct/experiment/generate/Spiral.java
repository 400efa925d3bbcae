package dct.experiment.generate;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.Points;

/**
 * A corridor of random width wound up to a rectangular spiral, which consists of a convex chain and
 * a reflex one; with an odd number of vertices it ends in a point. (The spiral polygons of S. Ghosh
 * and others; see S. Ghosh, "Visibility Algorithms in the Plane", 2007.)
 *
 * <p>Legs go right, up, left and down, inwards. Each has an outer and an inner wall; on each of the
 * four sides of the area the walls lie one inside the other, on lines that are drawn for opposite
 * sides together, so that no two walls meet. O(n) time.
 */
final class Spiral {
  private final int legs; // and one more, on whose outer wall the last one ends
  private final int[] column; // increasing; the spiral begins at the first
  private final int[] row;

  private Spiral(int n, Grid grid, SeededRandom random) {
    legs = (n - 1) / 2;
    int columns = 1 + 2 * (legsOn(1) + legsOn(3));
    int rows = 2 * (legsOn(0) + legsOn(2));
    String what = "a spiral of " + n + " vertices";
    Strata.check(columns, grid.columns(), what);
    Strata.check(rows, grid.rows(), what);
    column = Strata.increasing(columns, grid.columns(), random);
    row = Strata.increasing(rows, grid.rows(), random);
  }

  /** A counter-clockwise polygon of n vertices, the outer walls first. */
  static Points polygon(int n, Area area, SeededRandom random, Progress progress) {
    Grid grid = area.grid();
    return new Spiral(n, grid, random).points(n, grid);
  }

  /** The number of legs on a side: 0 is the lowest, 1 the right, 2 the upper, 3 the left one. */
  private int legsOn(int side) {
    return (legs + 4 - side) >> 2;
  }

  private Points points(int n, Grid grid) {
    long[] x = new long[n];
    long[] y = new long[n];
    for (int k = 0; k < n; k++) {
      boolean outer = 2 * k < n;
      int corner = outer ? k : n - 1 - k;
      x[k] = cornerX(corner, outer);
      y[k] = cornerY(corner, outer);
    }
    return grid.points(x, y);
  }

  /** The corner at which a leg begins; the walls of odd legs are upright. */
  private int cornerX(int leg, boolean outer) {
    return leg == 0 ? column[0] : wall(leg % 2 == 1 ? leg : leg - 1, outer);
  }

  private int cornerY(int leg, boolean outer) {
    return wall(leg % 2 == 0 ? leg : leg - 1, outer);
  }

  /** The line on which a wall lies; the last leg's walls both end on an outer one. */
  private int wall(int leg, boolean outer) {
    int depth = (leg >> 2) * 2 + (outer || leg == legs ? 0 : 1);
    return switch (leg % 4) {
      case 0 -> row[depth];
      case 1 -> column[column.length - 1 - depth];
      case 2 -> row[row.length - 1 - depth];
      default -> column[1 + depth];
    };
  }
}
