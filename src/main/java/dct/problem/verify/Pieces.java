package dct.problem.verify;

import dct.core.geometry.Points;
import java.util.function.IntPredicate;

/**
 * Whether the diagonals of a decomposition cut a polygon into pieces of the form that the method
 * promises: strictly convex, or monotone in the direction of y.
 *
 * <p>A polygon is strictly convex if each inner angle is less than 180°, and y-monotone if it has
 * no interior cusp: no inner angle of more than 180° between two edges that both lead up, or both
 * down (thesis, Definition 2.5). Height is compared by y, then by x. Both are seen at the vertices
 * alone. O(m).
 */
final class Pieces {
  private final Points points;
  private final PlaneGraph graph;
  private final IntPredicate cuts; // by edge: whether it bounds pieces
  private final IntPredicate outer; // by half-edge: whether the outer face is on its left

  /**
   * The pieces of a triangulated polygon.
   *
   * @param cuts tells of each edge whether it bounds pieces; those of the rim do
   * @param outer tells of each half-edge whether the outer face is on its left
   */
  Pieces(Points points, PlaneGraph graph, IntPredicate cuts, IntPredicate outer) {
    this.points = points;
    this.graph = graph;
    this.cuts = cuts;
    this.outer = outer;
  }

  /**
   * Checks the pieces.
   *
   * @param convex whether they have to be strictly convex, and not just monotone
   * @throws FalseClaim if one of them has not that form
   */
  void check(boolean convex) {
    for (int v = 0; v < points.size(); v++) {
      int degree = graph.degree(v);
      int last = lastCut(v);
      for (int k = 0; k < degree; k++) {
        int e = graph.around(v, k);
        if (cuts.test(e >> 1)) {
          boolean isPiece = !outer.test(last);
          FalseClaim.unless(
              !isPiece || (convex ? isConvex(last, e) : !isCusp(last, e)),
              "at vertex v" + v + " is a piece that is not " + (convex ? "convex" : "monotone"));
          last = e;
        }
      }
    }
  }

  private int lastCut(int v) {
    int k = graph.degree(v) - 1;
    while (!cuts.test(graph.around(v, k) >> 1)) {
      k--;
    }
    return graph.around(v, k);
  }

  /** Whether the angle counter-clockwise from e to f, of one origin, is less than 180°. */
  private boolean isConvex(int e, int f) {
    return points.orient(graph.origin(e), graph.target(e), graph.target(f)) > 0;
  }

  private boolean isCusp(int e, int f) {
    return graph.isUpper(e) == graph.isUpper(f) && !isConvex(e, f);
  }
}
