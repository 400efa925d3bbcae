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
   * The triangulation of sites with these triangles, which tile their hull.
   *
   * @param corners three sites a triangle, counter-clockwise
   */
  static Triangulation of(Points points, int[] corners) {
    Dcel dcel = dcel(points.size(), 0, corners);
    return new Triangulation(Domain.SITES, points, dcel, number -> EdgeKind.DIAGONAL);
  }

  /**
   * Another triangulation of the same, with these triangles.
   *
   * @param corners three vertices a triangle, counter-clockwise
   */
  static Triangulation of(Triangulation any, int[] corners) {
    int outer = any.dcel().origin(any.dcel().faceEdge(Dcel.OUTER));
    return any.with(dcel(any.vertexCount(), outer, corners));
  }

  private static Dcel dcel(int n, int outer, int[] corners) {
    TriangleMesh mesh = new TriangleMesh(n, corners.length / 3);
    for (int k = 0; k < corners.length; k += 3) {
      mesh.add(corners[k], corners[k + 1], corners[k + 2]);
    }
    return mesh.close(n, outer);
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

  /**
   * Links the half-edges without a triangle: at each vertex of a ring one arrives and one leaves.
   *
   * @param outer a vertex of the outer ring, if there are several
   */
  private Dcel close(int n, int outer) {
    int[] leaving = new int[n];
    Arrays.fill(leaving, Dcel.NONE);
    for (int e = 0; e < used; e++) {
      if (links.next()[e] == HalfEdges.NONE) {
        leaving[links.origin()[e]] = e;
      }
    }
    int[] cycles = new int[n];
    int count = 0;
    for (int e = used - 1; e >= 0; e--) {
      if (links.next()[e] == HalfEdges.NONE) {
        cycles[count++] = e;
        if (closeCycle(e, leaving, outer)) {
          cycles[count - 1] = cycles[0];
          cycles[0] = e;
        }
      }
    }
    return Dcel.of(n, links, Arrays.copyOf(cycles, count), Progress.NONE);
  }

  /** Links a cycle; whether it passes this vertex. */
  private boolean closeCycle(int first, int[] leaving, int vertex) {
    boolean passes = false;
    int e = first;
    do {
      passes |= links.origin()[e] == vertex;
      int following = leaving[links.origin()[e ^ 1]];
      links.link(e, following);
      e = following;
    } while (e != first);
    return passes;
  }
}
