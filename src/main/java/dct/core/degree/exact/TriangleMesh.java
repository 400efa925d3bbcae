package dct.core.degree.exact;

import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import java.util.Arrays;

/** A triangulation of a few sites from its triangles. O(n²) space. */
final class TriangleMesh {
  private final int[][] edge; // half-edge by origin and target, or Dcel.NONE
  private final int[] next;
  private final int[] prev;
  private final int[] origin;
  private int used; // half-edges

  private TriangleMesh(int n, int triangles) {
    edge = new int[n][n];
    for (int[] row : edge) {
      Arrays.fill(row, Dcel.NONE);
    }
    int most = 6 * triangles; // three edges a triangle if no two share one
    next = new int[most];
    prev = new int[most];
    origin = new int[most];
    Arrays.fill(next, Dcel.NONE);
  }

  /**
   * The triangulation with these triangles, which tile the hull of the sites.
   *
   * @param corners three sites a triangle, counter-clockwise
   */
  static Triangulation of(Points points, int[] corners) {
    TriangleMesh mesh = new TriangleMesh(points.size(), corners.length / 3);
    for (int k = 0; k < corners.length; k += 3) {
      mesh.add(corners[k], corners[k + 1], corners[k + 2]);
    }
    Dcel dcel = mesh.close(points.size());
    return new Triangulation(Domain.SITES, points, dcel, number -> EdgeKind.DIAGONAL);
  }

  private void add(int a, int b, int c) {
    link(edge(a, b), edge(b, c));
    link(edge(b, c), edge(c, a));
    link(edge(c, a), edge(a, b));
  }

  private int edge(int from, int to) {
    if (edge[from][to] == Dcel.NONE) {
      edge[from][to] = used++;
      edge[to][from] = used++;
      origin[edge[from][to]] = from;
      origin[edge[to][from]] = to;
    }
    return edge[from][to];
  }

  private void link(int e, int following) {
    next[e] = following;
    prev[following] = e;
  }

  /** Links the half-edges without a triangle: at each hull site one arrives and one leaves. */
  private Dcel close(int n) {
    int[] leaving = new int[n];
    for (int e = 0; e < used; e++) {
      if (next[e] == Dcel.NONE) {
        leaving[origin[e]] = e;
      }
    }
    int outer = Dcel.NONE;
    for (int e = 0; e < used; e++) {
      if (next[e] == Dcel.NONE) {
        link(e, leaving[origin[e ^ 1]]);
        outer = e;
      }
    }
    return Dcel.of(
        n,
        Arrays.copyOf(next, used),
        Arrays.copyOf(prev, used),
        Arrays.copyOf(origin, used),
        outer);
  }
}
