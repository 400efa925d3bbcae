package dct.core.degree;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import java.util.ArrayList;
import java.util.List;

/**
 * Flips diagonals so that more vertices become even (thesis, Algorithms 3.2 and 3.4).
 *
 * <p>Takes any triangulation. A diagonal d is flipped if the quadrilateral Q(d) of its two
 * triangles is strictly convex (Rule 3) and has more than two odd vertices (Rule 4), if d was not
 * processed (Condition 1) and was not made by a flip of this run (Condition 2). A flip marks the
 * four edges round Q(d) as processed; a rejected diagonal is not marked.
 *
 * <p>For a polygon the vertices are scanned in their order, and at each one its diagonals
 * counter-clockwise from the boundary edge to the next vertex, so that a rejected diagonal is
 * looked at once from each end (proof of Theorem 3.2). For a region the same, at a site inside it
 * from the edge with the lowest number on; fixed edges stay. For sites the interior edges are taken
 * in the order of their numbers, each once. O(n) time.
 *
 * <p>A flip changes the parity of exactly the four corners of Q(d); with three or four of them odd,
 * each flip gains 2 or 4 even vertices.
 */
public final class ScanFlip {
  private final Triangulation before;
  private final Points points;
  private final Dcel dcel;
  private final boolean[] processed; // by edge
  private final boolean[] made; // by edge: by a flip of this run
  private final Progress progress;
  private int looked; // at so many edges
  private final List<Integer> flips = new ArrayList<>(); // edges, in order

  private ScanFlip(Triangulation triangulation, Progress progress) {
    this.progress = progress;
    before = triangulation;
    points = triangulation.points();
    dcel = triangulation.dcel().copy();
    processed = new boolean[triangulation.edgeCount()];
    made = new boolean[triangulation.edgeCount()];
  }

  /**
   * The triangulation before and after one scan.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static FlipResult run(Triangulation triangulation, Progress progress) {
    ScanFlip scan = new ScanFlip(triangulation, progress);
    if (triangulation.domain() == Domain.SITES) {
      scan.scanEdges();
    } else {
      scan.scanVertices();
    }
    return scan.result();
  }

  private void scanVertices() {
    for (int v = 0; v < points.size(); v++) {
      Progress.tick(progress, v, points.size(), "Flipping diagonals");
      int start = firstEdge(v);
      if (dcel.isBoundary(start >> 1)) {
        scanFrom(dcel.rotate(start));
      } else {
        scanRound(start);
      }
    }
  }

  private void scanFrom(int first) {
    int e = first;
    while (!dcel.isBoundary(e >> 1)) {
      Progress.check(progress, looked++);
      int following = dcel.rotate(e); // a flip takes e away from v
      consider(e);
      e = following;
    }
  }

  /** The edges of a site inside a region, as they were before any of them was flipped. */
  private void scanRound(int first) {
    int[] around = new int[dcel.degree(dcel.origin(first))];
    int e = first;
    for (int k = 0; k < around.length; k++) {
      around[k] = e;
      e = dcel.rotate(e);
    }
    int v = dcel.origin(first);
    for (int edge : around) {
      Progress.check(progress, looked++);
      if (dcel.origin(edge) == v) {
        consider(edge);
      }
    }
  }

  /**
   * The half-edge from v along the boundary with the inside on its left; of a site that of the edge
   * with the lowest number.
   */
  private int firstEdge(int v) {
    int start = dcel.outEdge(v);
    int lowest = start;
    int e = start;
    do {
      if (dcel.face(e ^ 1) == Dcel.OUTER) {
        return e;
      }
      lowest = Math.min(lowest, e);
      e = dcel.rotate(e);
    } while (e != start);
    return lowest;
  }

  private void scanEdges() {
    for (int edge = 0; edge < processed.length; edge++) {
      Progress.tick(progress, edge, processed.length, "Flipping diagonals");
      if (!dcel.isBoundary(edge)) {
        consider(2 * edge);
      }
    }
  }

  private void consider(int e) {
    boolean isOpen = !processed[e >> 1] && !made[e >> 1] && before.kind(e >> 1) != EdgeKind.FIXED;
    if (isOpen && hasThreeOdd(e) && isStrictlyConvex(e)) {
      flip(e);
    }
  }

  private boolean hasThreeOdd(int e) {
    int odd = dcel.degree(dcel.origin(e)) & 1;
    odd += dcel.degree(dcel.target(e)) & 1;
    odd += dcel.degree(left(e)) & 1;
    odd += dcel.degree(left(e ^ 1)) & 1;
    return odd > 2;
  }

  /** The corner of the left triangle of e that is not on e. */
  private int left(int e) {
    return dcel.origin(dcel.prev(e));
  }

  private boolean isStrictlyConvex(int e) {
    int a = dcel.origin(e);
    int b = dcel.target(e);
    int c = left(e);
    int d = left(e ^ 1);
    return points.orient(d, c, a) > 0 && points.orient(d, c, b) < 0;
  }

  private void flip(int e) {
    mark(dcel.next(e));
    mark(dcel.prev(e));
    mark(dcel.next(e ^ 1));
    mark(dcel.prev(e ^ 1));
    dcel.flip(e);
    made[e >> 1] = true;
    flips.add(e >> 1);
  }

  private void mark(int e) {
    processed[e >> 1] = true;
  }

  private FlipResult result() {
    Triangulation after =
        new Triangulation(
            before.domain(),
            points,
            dcel,
            edge -> made[edge] ? EdgeKind.FLIPPED : before.kind(edge));
    return new FlipResult(before, after, flips);
  }
}
