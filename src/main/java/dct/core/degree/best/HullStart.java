package dct.core.degree.best;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.degree.ParityGoal;
import dct.core.degree.bound.SiteBounds;
import dct.core.geometry.Points;
import dct.core.triangulate.Triangulation;
import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Deque;

/**
 * A triangulation with as many edges of a cheapest walk round the hull as fit together ({@link
 * SiteBounds#walkedEdges}), for a search to begin from: along the hull it has few unmet sites where
 * the walk has, and it differs much from the Delaunay triangulation.
 *
 * <p>An edge is made by flips of those that cross it, and left out if one of them belongs to the
 * walk as well, or if many flips do not make it.
 */
final class HullStart {
  private static final int FLIPS_A_CROSSING = 8; // then it is left out

  private final Points points;
  private final Dcel dcel;
  private final BitSet walked = new BitSet(); // edges that stay

  private HullStart(Triangulation start) {
    points = start.points();
    dcel = start.dcel().copy();
  }

  /**
   * The triangulation; that of the start if no walk can be found.
   *
   * @param start any triangulation of the sites, with at least one triangle
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static Triangulation of(Triangulation start, ParityGoal goal, Progress progress) {
    HullStart made = new HullStart(start);
    int[] edges = SiteBounds.walkedEdges(start, goal, progress);
    for (int i = 0; i < edges.length; i += 2) {
      progress.checkCancelled();
      made.insert(edges[i], edges[i + 1]);
    }
    return start.with(made.dcel);
  }

  private void insert(int u, int v) {
    Deque<Integer> crossing =
        dcel.halfEdge(u, v) == Dcel.NONE ? crossing(u, v) : new ArrayDeque<>();
    if (crossing.stream().noneMatch(walked::get)) {
      int left = FLIPS_A_CROSSING * crossing.size();
      while (!crossing.isEmpty() && left > 0) {
        turn(crossing.remove(), u, v, crossing);
        left--;
      }
      if (crossing.isEmpty()) {
        walked.set(dcel.halfEdge(u, v) >> 1);
      }
    }
  }

  /** Flips an edge if that is possible; where it still crosses u v it comes last. */
  private void turn(int edge, int u, int v, Deque<Integer> crossing) {
    int e = 2 * edge;
    int x = dcel.origin(dcel.prev(e));
    int y = dcel.origin(dcel.prev(e ^ 1));
    boolean isConvex = isBetween(x, y, dcel.origin(e), dcel.target(e));
    if (isConvex) {
      dcel.flip(e);
    }
    if (!isConvex || isBetween(u, v, x, y)) {
      crossing.add(edge);
    }
  }

  /** Whether the line through a and b has c and d strictly on its two sides. */
  private boolean isBetween(int a, int b, int c, int d) {
    return points.orient(a, b, c) * points.orient(a, b, d) < 0;
  }

  /** The edges that cross the segment from u to v, which sees it, in the order from u on. */
  private Deque<Integer> crossing(int u, int v) {
    Deque<Integer> crossing = new ArrayDeque<>();
    int e = dcel.next(wedge(u, v)); // from the right of u v to its left, seen from u
    while (dcel.origin(dcel.prev(e ^ 1)) != v) {
      crossing.add(e >> 1);
      int apex = dcel.origin(dcel.prev(e ^ 1));
      int beyond = points.orient(u, v, apex) > 0 ? dcel.next(e ^ 1) : dcel.prev(e ^ 1);
      e = beyond;
    }
    crossing.add(e >> 1);
    return crossing;
  }

  /** The half-edge from u with v strictly inside the triangle's angle on its left. */
  private int wedge(int u, int v) {
    int e = dcel.outEdge(u);
    while (dcel.face(e) == Dcel.OUTER
        || points.orient(u, v, dcel.target(e)) >= 0
        || points.orient(u, v, dcel.target(dcel.rotate(e))) <= 0) {
      e = dcel.rotate(e);
    }
    return e;
  }
}
