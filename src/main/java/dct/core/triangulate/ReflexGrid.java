package dct.core.triangulate;

import dct.core.geometry.Box;
import dct.core.geometry.Points;

/**
 * The vertices of a polygon whose angle is 180° or more, in the cells of a grid of about as many
 * cells: tells whether one lies in a given triangle.
 */
final class ReflexGrid {
  // In cells; rounding of grid coordinates stays below 2^-20 for every grid that fits in memory.
  private static final double MARGIN = 0x1p-10;

  private final Points points;
  private final boolean[] isReflex; // by vertex
  private final int[] start; // by cell: where its vertices start; one more at the end
  private final int[] members; // the vertices, cell by cell
  private final int columns;
  private final int rows;
  private final double minX;
  private final double minY;
  private final double columnsPerUnit;
  private final double rowsPerUnit;
  private final Band band = new Band();
  private long looks;

  /** A grid over all points; takes possession of {@code isReflex}. */
  ReflexGrid(Points points, boolean[] isReflex) {
    this.points = points;
    this.isReflex = isReflex;
    Box box = Box.of(points);
    int wanted = Math.max(1, count(isReflex));
    double width = box.maxX() - box.minX();
    double height = box.maxY() - box.minY();
    double aspect = Math.sqrt(wanted * (width / height));
    columns = Math.max(1, (int) Math.min(wanted, aspect)); // 1 if the aspect is not a number
    rows = Math.max(1, wanted / columns);
    minX = box.minX();
    minY = box.minY();
    columnsPerUnit = perUnit(columns, width);
    rowsPerUnit = perUnit(rows, height);
    start = new int[columns * rows + 1];
    members = new int[count(isReflex)];
    fill();
  }

  private static double perUnit(int cells, double length) {
    double perUnit = cells / length;
    return Double.isFinite(perUnit) ? perUnit : 0; // then all is in the first cell
  }

  private static int count(boolean[] flags) {
    int count = 0;
    for (boolean flag : flags) {
      count += flag ? 1 : 0;
    }
    return count;
  }

  /** Counting sort of the reflex vertices by cell. */
  private void fill() {
    for (int v = 0; v < isReflex.length; v++) {
      if (isReflex[v]) {
        start[cell(v)]++;
      }
    }
    int end = 0;
    for (int c = 0; c < start.length; c++) {
      end += start[c];
      start[c] = end;
    }
    for (int v = isReflex.length - 1; v >= 0; v--) {
      if (isReflex[v]) {
        members[--start[cell(v)]] = v;
      }
    }
  }

  private int cell(int v) {
    return floor(gridY(v), rows) * columns + floor(gridX(v), columns);
  }

  private static int floor(double gridCoordinate, int cells) {
    return (int) Math.max(0, Math.min(cells - 1, gridCoordinate));
  }

  private double gridX(int v) {
    return orZero((points.x(v) - minX) * columnsPerUnit);
  }

  private double gridY(int v) {
    return orZero((points.y(v) - minY) * rowsPerUnit);
  }

  private static double orZero(double value) {
    return value >= 0 ? value : 0; // infinity times nothing is not a number
  }

  /** How many rows and vertices have been looked at so far: what the tests have cost. */
  long looks() {
    return looks;
  }

  /** Vertex v has become convex. */
  void remove(int v) {
    isReflex[v] = false;
  }

  /**
   * Whether no reflex vertex but its corners lies in the closed triangle, counter-clockwise abc.
   * Looks, row by row, at the cells that the triangle meets, so that long thin ones cost little.
   */
  boolean isTriangleFree(int a, int b, int c) {
    double ax = gridX(a);
    double ay = gridY(a);
    double bx = gridX(b);
    double by = gridY(b);
    double cx = gridX(c);
    double cy = gridY(c);
    int lastRow = floor(Math.max(ay, Math.max(by, cy)), rows);
    for (int r = floor(Math.min(ay, Math.min(by, cy)), rows); r <= lastRow; r++) {
      band.start(r);
      band.add(ax, ay, bx, by);
      band.add(bx, by, cx, cy);
      band.add(cx, cy, ax, ay);
      int from = start[r * columns + floor(band.minX - MARGIN, columns)];
      int to = start[r * columns + floor(band.maxX + MARGIN, columns) + 1];
      looks += 1 + to - from;
      if (!isFree(from, to, a, b, c)) {
        return false;
      }
    }
    return true;
  }

  private boolean isFree(int from, int to, int a, int b, int c) {
    for (int k = from; k < to; k++) {
      int v = members[k];
      if (isReflex[v] && v != a && v != b && v != c && isInside(v, a, b, c)) {
        return false;
      }
    }
    return true;
  }

  private boolean isInside(int v, int a, int b, int c) {
    return points.orient(c, a, v) >= 0
        && points.orient(a, b, v) >= 0
        && points.orient(b, c, v) >= 0;
  }

  /** The x-range of what segments have in one row of the grid, widened against rounding. */
  private static final class Band {
    private double low;
    private double high;
    double minX;
    double maxX;

    void start(int row) {
      low = row - MARGIN;
      high = row + 1 + MARGIN;
      minX = Double.POSITIVE_INFINITY;
      maxX = Double.NEGATIVE_INFINITY;
    }

    void add(double px, double py, double qx, double qy) {
      if (Math.max(py, qy) >= low && Math.min(py, qy) <= high) {
        boolean level =
            Math.abs(qy - py) < MARGIN; // lies in the row as a whole; no slope overflows
        double perY = level ? 0 : (qx - px) / (qy - py);
        addX(px + perY * (clamp(py) - py));
        addX(level ? qx : px + perY * (clamp(qy) - py));
      }
    }

    private double clamp(double y) {
      return Math.max(low, Math.min(high, y));
    }

    private void addX(double x) {
      minX = Math.min(minX, x);
      maxX = Math.max(maxX, x);
    }
  }
}
