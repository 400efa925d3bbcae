package dct.cli;

import dct.core.geometry.Points;
import java.util.function.IntPredicate;

/**
 * A triangulation as it was before a run of flips, seen through the one after it.
 *
 * <pre>
 *       a                a
 *      /|\              / \
 *     / | \            /   \
 *    u  |  v   --->   u-----v      e leads from u to v, a lies on its left, b on its right
 *     \ | /            \   /
 *      \|/              \ /
 *       b                b
 * </pre>
 *
 * The quadrilaterals of different flips share no triangle, so that each can be undone by itself.
 */
final class FlipUndo {
  private final Points points;
  private final PlaneGraph graph;
  private final IntPredicate flipped; // by half-edge
  private final int[] change; // of the degree of each vertex by undoing all flips
  private int count;
  private int wrong = -1;

  /**
   * Undoes the flips.
   *
   * @param graph a triangulation
   * @param flipped tells of each half-edge whether a flip made its edge, which is not on the rim
   */
  FlipUndo(Points points, PlaneGraph graph, IntPredicate flipped) {
    this.points = points;
    this.graph = graph;
    this.flipped = flipped;
    this.change = new int[points.size()];
    for (int e = 0; e < graph.halfEdges(); e += 2) {
      if (flipped.test(e)) {
        undo(e);
      }
    }
  }

  private void undo(int e) {
    int u = graph.origin(e);
    int v = graph.target(e);
    int a = apex(e);
    int b = apex(e ^ 1);
    boolean convex = points.orient(u, b, a) > 0 && points.orient(b, v, a) > 0;
    if (!convex || !isAlone(e) || !isAlone(e ^ 1)) {
      wrong = e;
    }
    change[u]--;
    change[v]--;
    change[a]++;
    change[b]++;
    count++;
  }

  /** Whether the other two sides of the triangle left of e were not flipped. */
  private boolean isAlone(int e) {
    int f = graph.next(e);
    return !flipped.test(f) && !flipped.test(graph.next(f));
  }

  private int apex(int e) {
    return graph.target(graph.next(e));
  }

  /** The number of flips. */
  int count() {
    return count;
  }

  /** A half-edge that is said to come from a flip and cannot, or −1. */
  int wrong() {
    return wrong;
  }

  /** The degree of a vertex before the flips. */
  int degreeBefore(int v) {
    return graph.degree(v) + change[v];
  }

  /**
   * A half-edge at which the triangulation before the flips was not Delaunay, or −1.
   *
   * <p>A triangulation is Delaunay if it is so at every inner edge: of the two triangles there, the
   * far corner of one is not inside the circle of the other (Delaunay 1934).
   *
   * @param outer by half-edge, whether the outer face is on its left
   */
  int notDelaunay(boolean[] outer) {
    for (int e = 0; e < outer.length; e += 2) {
      if (!outer[e] && !outer[e ^ 1] && !wasDelaunay(e)) {
        return e;
      }
    }
    return -1;
  }

  private boolean wasDelaunay(int e) {
    int u = graph.origin(e);
    int v = graph.target(e);
    if (flipped.test(e)) {
      return points.inCircle(u, apex(e ^ 1), apex(e), v) <= 0;
    }
    return points.inCircle(u, v, apexBefore(e), apexBefore(e ^ 1)) <= 0;
  }

  /** The third corner of the triangle left of e before the flips. */
  private int apexBefore(int e) {
    int f = graph.next(e);
    int g = graph.next(f);
    if (flipped.test(f)) {
      return apex(f ^ 1);
    }
    return apex(flipped.test(g) ? g ^ 1 : e);
  }
}
