package dct.experiment.generate;

import java.util.Arrays;
import java.util.function.IntPredicate;

/**
 * Which edges pass through which of about n square cells, so that those that an edge may meet are
 * found without looking at all. Two edges that meet are listed together in some cell.
 */
final class EdgeCells {
  /** No edge. */
  static final int NONE = -1;

  private static final double SLACK = 1e-3; // far above the rounding errors of a crossing's place

  private final Places p;
  private final int side;
  private final int columns;
  private final int[][] edges; // of each cell
  private final int[] count;
  private int[] passed = new int[64]; // the cells last found by pass()
  private int passedCount;

  EdgeCells(Places places) {
    this.p = places;
    int width = 1;
    int height = 1;
    for (int i = 0; i < p.size(); i++) {
      width = Math.max(width, p.x(i) + 1);
      height = Math.max(height, p.y(i) + 1);
    }
    side = (int) Math.ceil(Math.sqrt((double) width * height / p.size()));
    columns = (width - 1) / side + 1;
    int rows = (height - 1) / side + 1;
    edges = new int[columns * rows][];
    count = new int[edges.length];
  }

  /** Lists an edge between these vertices. */
  void add(int edge, int a, int b) {
    pass(a, b);
    for (int k = 0; k < passedCount; k++) {
      int cell = passed[k];
      if (edges[cell] == null) {
        edges[cell] = new int[4];
      } else if (count[cell] == edges[cell].length) {
        edges[cell] = Arrays.copyOf(edges[cell], 2 * count[cell]);
      }
      edges[cell][count[cell]++] = edge;
    }
  }

  /** Takes an edge between these vertices off the lists. */
  void remove(int edge, int a, int b) {
    pass(a, b);
    for (int k = 0; k < passedCount; k++) {
      int cell = passed[k];
      int i = 0;
      while (edges[cell][i] != edge) {
        i++;
      }
      edges[cell][i] = edges[cell][--count[cell]];
    }
  }

  /** The first edge that passes a cell of the segment ab and fulfils the condition, or none. */
  int find(int a, int b, IntPredicate condition) {
    pass(a, b);
    for (int k = 0; k < passedCount; k++) {
      int cell = passed[k];
      for (int i = 0; i < count[cell]; i++) {
        if (condition.test(edges[cell][i])) {
          return edges[cell][i];
        }
      }
    }
    return NONE;
  }

  /** Finds the cells that the segment ab passes, row by row upwards. */
  private void pass(int a, int b) {
    int low = p.y(a) <= p.y(b) ? a : b;
    int high = low == a ? b : a;
    int lastRow = p.y(high) / side;
    passedCount = 0;
    for (int row = p.y(low) / side; row <= lastRow; row++) {
      double enter = xAt(low, high, Math.max(p.y(low), (double) row * side));
      double leave = xAt(low, high, Math.min(p.y(high), (row + 1.0) * side));
      if (p.y(low) == p.y(high)) {
        leave = p.x(high);
      }
      passRow(row, low, high, Math.min(enter, leave), Math.max(enter, leave));
    }
  }

  private double xAt(int low, int high, double y) {
    double dy = p.y(high) - p.y(low);
    return dy == 0 ? p.x(low) : p.x(low) + (p.x(high) - p.x(low)) * ((y - p.y(low)) / dy);
  }

  private void passRow(int row, int a, int b, double from, double to) {
    int left = Math.max((int) (from - SLACK), Math.min(p.x(a), p.x(b)));
    int right = Math.min((int) (to + SLACK), Math.max(p.x(a), p.x(b)));
    for (int column = left / side; column <= right / side; column++) {
      if (passedCount == passed.length) {
        passed = Arrays.copyOf(passed, 2 * passedCount);
      }
      passed[passedCount++] = row * columns + column;
    }
  }
}
