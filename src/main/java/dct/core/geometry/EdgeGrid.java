package dct.core.geometry;

import java.util.Arrays;
import java.util.function.IntPredicate;

/**
 * A square grid over some points that remembers which edges pass through each of its cells, so that
 * only edges nearby are compared. Edges that are no longer there are forgotten when they are met.
 */
final class EdgeGrid {
  private static final int MOST_CELLS = 1024; // along each side
  private static final double MOST_ENTRIES = 1 << 22; // about so many edges in all cells together
  private static final int FIRST = 4;

  /** Says something of the edge between two vertices. */
  @FunctionalInterface
  interface EdgeTest {
    boolean test(int u, int v);
  }

  private final Points points;
  private final int cells;
  private final double left;
  private final double low;
  private final double width; // of a cell, halved like all lengths, lest they overflow
  private final double height;
  private final long[][] edges; // of each cell
  private final int[] counts; // how many of them are in use

  /** An empty grid over these points, with so many cells along each side. */
  EdgeGrid(Points points, int cells) {
    this.points = points;
    this.cells = cells;
    double[] x = points.xs();
    double[] y = points.ys();
    left = Arrays.stream(x).min().orElse(0) / 2;
    low = Arrays.stream(y).min().orElse(0) / 2;
    width = (Arrays.stream(x).max().orElse(0) / 2 - left) / cells;
    height = (Arrays.stream(y).max().orElse(0) / 2 - low) / cells;
    edges = new long[cells * cells][];
    counts = new int[cells * cells];
  }

  /** How many cells along each side suit a closed chain through the points. */
  static int cellsFor(Points points) {
    return cellsFor(Rings.ofChain(points));
  }

  /** How many cells along each side suit these rings and edges: fewer if the edges are long. */
  static int cellsFor(Rings rings) {
    Points points = rings.points();
    EdgeGrid box = new EdgeGrid(points, 1);
    int n = points.size();
    double crossed = 1; // cells by all edges, for each cell along a side
    for (int e = 0; e < n + rings.fixedCount(); e++) {
      if (e >= n || rings.isOnRing(e)) {
        crossed += box.sides(rings.from(e), rings.to(e));
      }
    }
    double cells = Math.min(Math.sqrt(n), MOST_ENTRIES / (3 * crossed));
    return (int) Math.max(1, Math.min(MOST_CELLS, cells));
  }

  /** How wide and high an edge is, as parts of a cell. */
  private double sides(int u, int v) {
    return Math.abs(points.x(v) / 2 - points.x(u) / 2) / width
        + Math.abs(points.y(v) / 2 - points.y(u) / 2) / height;
  }

  /** Does something in every cell that an edge passes, a row after the other, until it says yes. */
  private boolean anyCell(int u, int v, IntPredicate action) {
    int a = points.y(u) < points.y(v) ? u : v;
    int b = a == u ? v : u;
    int first = cell(points.y(a), low, height);
    int top = cell(points.y(b), low, height);
    for (int row = first; row <= top; row++) {
      int one = column(row == first ? points.x(a) : levelX(a, b, row));
      int other = column(row == top ? points.x(b) : levelX(a, b, row + 1));
      int last = Math.min(cells - 1, Math.max(one, other) + 1); // one more for the rounding
      for (int column = Math.max(0, Math.min(one, other) - 1); column <= last; column++) {
        if (action.test(row * cells + column)) {
          return true;
        }
      }
    }
    return false;
  }

  private int cell(double coordinate, double from, double step) {
    double cell = Math.floor((coordinate / 2 - from) / step);
    return (int) Math.max(0, Math.min(cells - 1.0, cell)); // not a number where all are the same
  }

  private int column(double x) {
    return cell(x, left, width);
  }

  /** About where the edge from a up to b enters a row. */
  private double levelX(int a, int b, int row) {
    double from = points.y(a) / 2;
    double part = (low + row * height - from) / (points.y(b) / 2 - from);
    double within = Math.max(0, Math.min(1, part));
    return points.x(a) * (1 - within) + points.x(b) * within;
  }

  /** Remembers an edge. */
  void add(int u, int v) {
    long edge = (long) u << 32 | v;
    anyCell(
        u,
        v,
        cell -> {
          long[] here = edges[cell] == null ? new long[FIRST] : edges[cell];
          here = counts[cell] == here.length ? Arrays.copyOf(here, 2 * here.length) : here;
          here[counts[cell]++] = edge;
          edges[cell] = here;
          return false;
        });
  }

  /**
   * Asks of the edges near one until the answer is yes.
   *
   * @param exists whether an edge is still there
   * @return whether the answer was yes for any
   */
  boolean anyNear(int u, int v, EdgeTest exists, EdgeTest question) {
    return anyCell(u, v, cell -> anyIn(cell, exists, question));
  }

  private boolean anyIn(int cell, EdgeTest exists, EdgeTest question) {
    for (int i = 0; i < counts[cell]; i++) {
      int u = (int) (edges[cell][i] >> 32);
      int v = (int) edges[cell][i];
      if (!exists.test(u, v)) {
        edges[cell][i--] = edges[cell][--counts[cell]];
      } else if (question.test(u, v)) {
        return true;
      }
    }
    return false;
  }
}
