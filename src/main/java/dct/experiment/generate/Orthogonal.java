package dct.experiment.generate;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.Points;
import java.util.Arrays;
import java.util.Locale;

/**
 * A random orthogonal polygon: the outline of a random region of cells, the columns and rows of
 * which then get random widths. Its edges are level and upright in turn.
 *
 * <p>The region grows from one cell by random neighbours (after M. Eden, "A two-dimensional growth
 * process", 1961) that keep its outline simple and take no corner away, until there are n corners.
 * (Another way with the same range is "Generating random orthogonal polygons", A. Tomás and A.
 * Bajuelos, 2004, which takes O(n²) time.) O(n) expected time.
 */
final class Orthogonal {
  private static final int CELLS = 3; // of the box, for each vertex
  private static final int TRIES = 20;

  private Orthogonal() {}

  /**
   * A counter-clockwise polygon of n vertices.
   *
   * @throws CannotGenerateException if n is odd or less than 4, or none was found
   */
  static Points polygon(int n, Area area, SeededRandom random, Progress progress) {
    if (n % 2 == 1 || n < 4) {
      throw new CannotGenerateException(
          "an orthogonal polygon has an even number of vertices, 4 or more; " + n + " is not");
    }
    Grid grid = area.grid();
    double wished = Math.sqrt(CELLS * (double) n * grid.columns() / grid.rows());
    int width = (int) Math.min(grid.columns() - 1, (long) wished + 3);
    int height = (int) Math.min(grid.rows() - 1, (long) (CELLS * n / wished) + 3);
    for (int tries = 0; tries < TRIES && width > 0 && height > 0; tries++) {
      progress.checkCancelled();
      CellRegion region = new CellRegion(width, height);
      if (region.growTo(n, random)) {
        return stretched(region, grid, random);
      }
    }
    throw new CannotGenerateException(
        String.format(
            Locale.ROOT,
            "no orthogonal polygon of %d vertices was found in %s; take a larger area or fewer",
            n,
            area));
  }

  private static Points stretched(CellRegion region, Grid grid, SeededRandom random) {
    int[] outline = region.outline();
    int[] column = new int[outline.length];
    int[] row = new int[outline.length];
    for (int k = 0; k < outline.length; k++) {
      column[k] = outline[k] % region.width();
      row[k] = Math.floorDiv(outline[k], region.width());
    }
    return grid.points(spread(column, grid.columns(), random), spread(row, grid.rows(), random));
  }

  /** The lines from the least to the largest, at random distances over the whole range. */
  private static long[] spread(int[] lines, long size, SeededRandom random) {
    int least = Arrays.stream(lines).min().orElseThrow();
    int largest = Arrays.stream(lines).max().orElseThrow();
    int[] place = Strata.increasing(largest - least + 1, size, random);
    return Arrays.stream(lines).mapToLong(line -> place[line - least]).toArray();
  }
}
