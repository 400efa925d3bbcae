package dct.problem.verify;

import dct.core.geometry.Points;
import java.util.function.IntPredicate;

/**
 * The edges as they were before a run of flips, from those after it.
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
 * The quadrilaterals of different flips of Scan-Flip share no triangle, so that each can be undone
 * by itself. O(m).
 */
final class FlipUndo {
  private final PlaneGraph graph;
  private final IntPredicate flipped; // by edge
  private final int[] from; // by edge, before the flips
  private final int[] to;
  private int count;

  /**
   * Undoes the flips.
   *
   * @param graph a triangulation
   * @param flipped tells of each edge whether a flip made it; such an edge is not on the rim
   * @throws FalseClaim if an edge cannot have come from a flip
   */
  FlipUndo(Points points, PlaneGraph graph, ClaimedEdges edges, IntPredicate flipped) {
    this.graph = graph;
    this.flipped = flipped;
    this.from = edges.fromAll();
    this.to = edges.toAll();
    for (int edge = 0; edge < from.length; edge++) {
      if (flipped.test(edge)) {
        undo(points, edge, edges.line(edge));
      }
    }
  }

  private void undo(Points points, int edge, int line) {
    int e = 2 * edge;
    int u = graph.origin(e);
    int v = graph.target(e);
    int a = graph.apex(e);
    int b = graph.apex(e + 1);
    boolean convex = points.orient(u, b, a) > 0 && points.orient(b, v, a) > 0;
    FalseClaim.unless(
        convex && isAlone(e) && isAlone(e + 1),
        line,
        "edge " + graph.name(e) + " cannot have come from a flip");
    from[edge] = b;
    to[edge] = a;
    count++;
  }

  /** Whether the other two sides of the triangle left of e were not flipped. */
  private boolean isAlone(int e) {
    int f = graph.next(e);
    return !flipped.test(f >> 1) && !flipped.test(graph.next(f) >> 1);
  }

  /** The number of flips. */
  int count() {
    return count;
  }

  /** The triangulation before the flips, its edges numbered as after them. */
  PlaneGraph before(Points points) {
    return count == 0 ? graph : new PlaneGraph(points, from, to);
  }
}
