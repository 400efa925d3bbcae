package dct.experiment.generate;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.Points;
import java.util.Locale;

/**
 * The outline of a random spanning tree: a winding corridor round each of its branches.
 *
 * <p>Cells lie on a rectangular lattice. A spanning tree of them is drawn, each equally likely (D.
 * Wilson, "Generating random spanning trees more quickly than the cover time", 1996), and loses
 * leaves until it has as many cells as are needed. Each cell has four vertices; the walk round the
 * tree visits all vertices of all cells, on a lattice of half the width. Up to three vertices that
 * are not neighbours are left out to reach n exactly.
 *
 * <p>At last each vertex moves by less than a quarter of the lattice's width in x and in y. Edges
 * without a common vertex are at least √½ widths apart, so that they stay apart. O(n log n)
 * expected time.
 */
final class SpanningTree {
  private static final int[] DX = {0, 1, 0, -1}; // down, right, up, left
  private static final int[] DY = {-1, 0, 1, 0};
  private static final int[] CORNER_X = {0, 1, 1, 0}; // from the lower left, counter-clockwise
  private static final int[] CORNER_Y = {0, 0, 1, 1};
  private static final int NONE = -1;

  private final int columns;
  private final int rows;
  private final SeededRandom random;
  private final byte[] exits; // of each cell, a bit for each direction

  private SpanningTree(int columns, int rows, SeededRandom random) {
    this.columns = columns;
    this.rows = rows;
    this.random = random;
    exits = new byte[columns * rows];
  }

  /**
   * A counter-clockwise polygon of n vertices.
   *
   * @throws CannotGenerateException if the area has too few places
   */
  static Points polygon(int n, Area area, SeededRandom random, Progress progress) {
    Grid grid = area.grid();
    int cells = (n + 3) / 4;
    long mostColumns = grid.columns() / 2;
    long mostRows = grid.rows() / 2;
    if (mostColumns * mostRows < cells) {
      throw new CannotGenerateException(
          String.format(
                  Locale.ROOT,
                  "the outline of a spanning tree with %d vertices needs %d cells of 2 × 2 places; take a",
                  n,
                  cells)
              + " larger area or fewer");
    }
    double wished = Math.sqrt((double) cells * grid.columns() / grid.rows());
    long least = (cells + mostRows - 1) / mostRows;
    int columns = (int) Math.min(mostColumns, Math.max(least, Math.round(wished)));
    SpanningTree tree = new SpanningTree(columns, (cells + columns - 1) / columns, random);
    tree.grow(progress);
    tree.prune(cells);
    return tree.outline(n, cells, grid);
  }

  /** Wilson's way: from each cell a random walk to the tree, its loops left out, joins it. */
  private void grow(Progress progress) {
    byte[] way = new byte[exits.length]; // by which each cell was last left
    boolean[] inTree = new boolean[exits.length];
    inTree[random.nextInt(exits.length)] = true;
    for (int start = 0; start < exits.length; start++) {
      progress.checkCancelled();
      for (int cell = start; !inTree[cell]; cell = next(cell, way[cell])) {
        way[cell] = randomWay(cell);
      }
      for (int cell = start; !inTree[cell]; cell = next(cell, way[cell])) {
        inTree[cell] = true;
        join(cell, way[cell]);
      }
    }
  }

  private byte randomWay(int cell) {
    int way;
    do {
      way = random.nextInt(4);
    } while (next(cell, way) == NONE);
    return (byte) way;
  }

  /** The cell in that direction, or none. */
  private int next(int cell, int way) {
    int x = cell % columns + DX[way];
    int y = Math.floorDiv(cell, columns) + DY[way];
    boolean inside = x >= 0 && x < columns && y >= 0 && y < rows;
    return inside ? y * columns + x : NONE;
  }

  private void join(int cell, int way) {
    exits[cell] ^= (byte) (1 << way);
    exits[next(cell, way)] ^= (byte) (1 << (way ^ 2));
  }

  /** Takes leaves away until so many cells are left. */
  private void prune(int cells) {
    for (int left = exits.length; left > cells; ) {
      int cell = random.nextInt(exits.length);
      if (Integer.bitCount(exits[cell]) == 1) {
        join(cell, Integer.numberOfTrailingZeros(exits[cell])); // a second time undoes it
        left--;
      }
    }
  }

  /** The walk round the tree, a vertex given as cell · 4 + corner. */
  private int[] walk(int cells) {
    int[] walk = new int[4 * cells];
    int cell = 0;
    while (exits[cell] == 0 && cells > 1) {
      cell++;
    }
    int corner = 0;
    for (int k = 0; k < walk.length; k++) {
      walk[k] = 4 * cell + corner;
      if (((exits[cell] >> corner) & 1) == 1) {
        cell = next(cell, corner);
        corner = (corner + 3) % 4;
      } else {
        corner = (corner + 1) % 4;
      }
    }
    return walk;
  }

  private Points outline(int n, int cells, Grid grid) {
    int[] walk = walk(cells);
    int surplus = walk.length - n;
    long[] x = new long[n];
    long[] y = new long[n];
    int size = 0;
    for (int k = 0; k < walk.length; k++) {
      boolean isLeftOut = k % 2 == 0 && k < 2 * surplus;
      if (!isLeftOut) {
        int cell = walk[k] >> 2;
        int corner = walk[k] & 3;
        x[size] = place(2 * (cell % columns) + CORNER_X[corner], 2 * columns, grid.columns());
        y[size++] =
            place(2 * Math.floorDiv(cell, columns) + CORNER_Y[corner], 2 * rows, grid.rows());
      }
    }
    return grid.points(x, y);
  }

  /** A random place less than a quarter of the lattice's width from one of its lines. */
  private long place(int line, int lines, long size) {
    long width = size / lines;
    long most = (width - 1) / 4;
    return line * width + width / 2 - most + random.nextLong(2 * most + 1);
  }
}
