package dct.testing;

import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import java.util.Arrays;
import java.util.function.Consumer;

/** Every triangulation of a small polygon, one after the other, by brute force. */
public final class EveryTriangulation {
  private final Points points; // counter-clockwise
  private final int n;
  private final int[] degree;
  private final int[] triangles; // three positions each
  private final Visitor visitor;
  private int found; // triangles

  /** Is told of each triangulation. */
  @FunctionalInterface
  public interface Visitor {
    /**
     * One triangulation; the arrays are used again for the next one.
     *
     * @param degrees by position on the counter-clockwise walk
     * @param triangles three positions each, ascending
     */
    void accept(int[] degrees, int[] triangles);
  }

  private EveryTriangulation(SimplePolygon polygon, Visitor visitor) {
    int[] walk = polygon.walk();
    n = walk.length;
    double[] x = new double[n];
    double[] y = new double[n];
    for (int k = 0; k < n; k++) {
      x[k] = polygon.points().x(walk[k]);
      y[k] = polygon.points().y(walk[k]);
    }
    points = Points.of(x, y);
    degree = new int[n];
    triangles = new int[3 * (n - 2)];
    this.visitor = visitor;
  }

  /** Calls the visitor with the degrees, by position on the counter-clockwise walk. */
  public static void of(SimplePolygon polygon, Consumer<int[]> visitor) {
    of(polygon, (degrees, triangles) -> visitor.accept(degrees));
  }

  /** Calls the visitor with the degrees and the triangles. */
  public static void of(SimplePolygon polygon, Visitor visitor) {
    EveryTriangulation run = new EveryTriangulation(polygon, visitor);
    Arrays.fill(run.degree, 2);
    run.cut(new Chords(0, run.n - 1, null));
  }

  private record Chords(int i, int j, Chords others) {}

  private void cut(Chords chords) {
    Chords open = chords;
    while (open != null && open.j == open.i + 1) {
      open = open.others;
    }
    if (open == null) {
      visitor.accept(degree, triangles);
      return;
    }
    for (int k = open.i + 1; k < open.j; k++) {
      if (isTriangle(open.i, k, open.j)) {
        count(open.i, k, 1);
        count(k, open.j, 1);
        triangles[3 * found] = open.i;
        triangles[3 * found + 1] = k;
        triangles[3 * found + 2] = open.j;
        found++;
        cut(new Chords(open.i, k, new Chords(k, open.j, open.others)));
        found--;
        count(open.i, k, -1);
        count(k, open.j, -1);
      }
    }
  }

  private void count(int i, int j, int change) {
    if (j > i + 1) {
      degree[i] += change;
      degree[j] += change;
    }
  }

  /** The chord ij is inside, so an empty triangle on it that no edge crosses is inside too. */
  private boolean isTriangle(int i, int k, int j) {
    if (Exact.orient(points, i, k, j) <= 0) {
      return false;
    }
    for (int v = 0; v < n; v++) {
      if (v != i && v != k && v != j && isInClosed(v, i, k, j)) {
        return false;
      }
    }
    return isUncrossed(i, k) && isUncrossed(k, j);
  }

  private boolean isInClosed(int v, int a, int b, int c) {
    return Exact.orient(points, a, b, v) >= 0
        && Exact.orient(points, b, c, v) >= 0
        && Exact.orient(points, c, a, v) >= 0;
  }

  private boolean isUncrossed(int a, int b) {
    for (int c = 0; c < n; c++) {
      int d = (c + 1) % n;
      boolean apart = c != a && c != b && d != a && d != b;
      if (apart
          && Exact.orient(points, a, b, c) * Exact.orient(points, a, b, d) < 0
          && Exact.orient(points, c, d, a) * Exact.orient(points, c, d, b) < 0) {
        return false;
      }
    }
    return true;
  }
}
