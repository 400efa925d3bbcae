package dct.core.degree.exact;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.dcel.HalfEdges;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import java.util.Arrays;

/** A triangulation of a few sites from its triangles. O(n²) space. */
final class TriangleMesh {
  private final int[][] edge; // half-edge by origin and target, or Dcel.NONE
  private final HalfEdges links;
  private int used; // half-edges

  private TriangleMesh(int n, int triangles) {
    edge = new int[n][n];
    for (int[] row : edge) {
      Arrays.fill(row, Dcel.NONE);
    }
    int most = 3 * triangles; // three edges a triangle if no two share one
    links = new HalfEdges(most, most);
    Arrays.fill(links.next(), HalfEdges.NONE);
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
    links.link(edge(a, b), edge(b, c));
    links.link(edge(b, c), edge(c, a));
    links.link(edge(c, a), edge(a, b));
  }

  private int edge(int from, int to) {
    if (edge[from][to] == Dcel.NONE) {
      edge[from][to] = used++;
      edge[to][from] = used++;
      links.origin()[edge[from][to]] = from;
      links.origin()[edge[to][from]] = to;
    }
    return edge[from][to];
  }

  /** Links the half-edges without a triangle: at each hull site one arrives and one leaves. */
  private Dcel close(int n) {
    int[] leaving = new int[n];
    for (int e = 0; e < used; e++) {
      if (links.next()[e] == HalfEdges.NONE) {
        leaving[links.origin()[e]] = e;
      }
    }
    int outer = Dcel.NONE;
    for (int e = 0; e < used; e++) {
      if (links.next()[e] == HalfEdges.NONE) {
        links.link(e, leaving[links.origin()[e ^ 1]]);
        outer = e;
      }
    }
    return Dcel.of(n, links, outer, Progress.NONE);
  }
}
