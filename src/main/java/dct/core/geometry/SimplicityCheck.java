package dct.core.geometry;

import dct.core.Progress;
import java.util.Optional;

/**
 * Whether a closed chain of vertices bounds a simple polygon; if not, where it fails.
 *
 * <p>Takes any finite points, in boundary order. A chain is simple if it has three vertices or
 * more, not all on one line, no two of them coincide, no vertex lies on an edge that is not its
 * own, and no two edges meet but in their common vertex. Straight (180°) vertices are allowed.
 *
 * <p>Plane sweep of Shamos and Hoey (1976), O(n log n) expected time and O(n) space, exact. Among
 * several defects the one reported is: coinciding vertices, with the lowest number; then a spike,
 * at the lowest number; then what the sweep, from high to low y, finds first.
 */
public final class SimplicityCheck {
  private final Points points;
  private final Progress progress;
  private final int n;
  private final int[] order; // lowest point first
  private final int[] rank; // place of each vertex in that order
  private Defect defect; // the first one found, or null

  private SimplicityCheck(Points points, Progress progress) {
    this.points = points;
    this.progress = progress;
    n = points.size();
    order = PlaneOrder.byYThenX(points, progress);
    rank = new int[n];
    for (int k = 0; k < n; k++) {
      Progress.check(progress, k);
      rank[order[k]] = k;
    }
  }

  /**
   * The first defect of the closed chain through these points, or nothing if it is simple.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Optional<Defect> firstDefect(Points points, Progress progress) {
    if (points.size() < 3) {
      int n = points.size();
      return Optional.of(new Defect(Defect.Kind.TOO_FEW, 0, 0, 0, 0, n));
    }
    return Optional.ofNullable(new SimplicityCheck(points, progress).run());
  }

  private Defect run() {
    findDuplicate();
    if (defect == null) {
      findCollinear();
    }
    if (defect == null) {
      findSpike();
    }
    if (defect == null) {
      sweep();
    }
    return defect;
  }

  private void findDuplicate() {
    int lowest = n;
    int other = n;
    for (int k = 1; k < n; k++) {
      Progress.check(progress, k);
      if (order[k - 1] < lowest && points.same(order[k - 1], order[k])) {
        lowest = order[k - 1];
        other = order[k];
      }
    }
    if (lowest < n) {
      report(Defect.Kind.DUPLICATE, lowest, other, lowest);
    }
  }

  private void findCollinear() {
    for (int v = 2; v < n; v++) {
      Progress.check(progress, v);
      if (points.orient(0, 1, v) != 0) {
        return;
      }
    }
    report(Defect.Kind.COLLINEAR, 0, 0, 0);
  }

  private void findSpike() {
    for (int v = 0; v < n && defect == null; v++) {
      Progress.check(progress, v);
      boolean turnsBack = rank[before(v)] < rank[v] == rank[after(v)] < rank[v];
      if (turnsBack && points.orient(before(v), v, after(v)) == 0) {
        report(Defect.Kind.SPIKE, v, v, v);
      }
    }
  }

  private int after(int v) {
    return v + 1 == n ? 0 : v + 1;
  }

  private int before(int v) {
    return v == 0 ? n - 1 : v - 1;
  }

  /** Edge v runs from vertex v to the next one. */
  private void sweep() {
    SweepStatus status = new SweepStatus(points, n);
    for (int k = n - 1; k >= 0 && defect == null; k--) {
      Progress.tick(progress, n - 1 - k, n, "Checking that the boundary is simple");
      int v = order[k];
      boolean arrivesFromAbove = rank[before(v)] > k;
      boolean leavesUpwards = rank[after(v)] > k;
      if (arrivesFromAbove && leavesUpwards) {
        end(status, v);
      } else if (arrivesFromAbove) {
        pass(status, before(v), v, v, after(v));
      } else if (leavesUpwards) {
        pass(status, v, before(v), v, before(v));
      } else {
        start(status, v);
      }
    }
  }

  private void start(SweepStatus status, int v) {
    int l = status.search(v);
    if (status.touched() != SweepStatus.NONE) {
      report(Defect.Kind.TOUCH, v, status.touched(), v);
      return;
    }
    int r = status.after(l);
    boolean nextIsLeft = points.orient(before(v), v, after(v)) > 0;
    int leftEdge = nextIsLeft ? v : before(v);
    int rightEdge = nextIsLeft ? before(v) : v;
    status.insertAfter(l, leftEdge, v, nextIsLeft ? after(v) : before(v));
    status.insertAfter(leftEdge, rightEdge, v, nextIsLeft ? before(v) : after(v));
    comparePair(l, leftEdge);
    comparePair(rightEdge, r);
  }

  private void pass(SweepStatus status, int old, int edge, int v, int lowerEnd) {
    status.replace(old, edge, v, lowerEnd);
    comparePair(status.before(edge), edge);
    comparePair(edge, status.after(edge));
  }

  private void end(SweepStatus status, int v) {
    status.remove(v);
    int l = status.before(before(v));
    status.remove(before(v));
    comparePair(l, status.after(l));
  }

  private void comparePair(int e, int f) {
    boolean both = e != SweepStatus.NONE && f != SweepStatus.NONE;
    if (both && defect == null && after(e) != f && after(f) != e) {
      compare(Math.min(e, f), Math.max(e, f));
    }
  }

  private void compare(int e, int f) {
    int a = e;
    int b = after(e);
    int c = f;
    int d = after(f);
    int abc = points.orient(a, b, c);
    int abd = points.orient(a, b, d);
    int cda = points.orient(c, d, a);
    int cdb = points.orient(c, d, b);
    if (abc * abd < 0 && cda * cdb < 0) {
      defect = Crossings.defect(points, e, f);
    } else if (abc == 0 && abd == 0) {
      if (isBetween(a, c, d) || isBetween(b, c, d) || isBetween(c, a, b)) {
        int inside = isBetween(a, c, d) ? a : isBetween(b, c, d) ? b : c;
        report(Defect.Kind.OVERLAP, e, f, inside);
      }
    } else {
      reportTouch(abc, c, e);
      reportTouch(abd, d, e);
      reportTouch(cda, a, f);
      reportTouch(cdb, b, f);
    }
  }

  private void reportTouch(int side, int v, int edge) {
    if (side == 0 && defect == null && isBetween(v, edge, after(edge))) {
      report(Defect.Kind.TOUCH, v, edge, v);
    }
  }

  private boolean isBetween(int v, int a, int b) {
    return rank[a] < rank[v] == rank[v] < rank[b];
  }

  private void report(Defect.Kind kind, int first, int second, int where) {
    defect = new Defect(kind, first, second, points.x(where), points.y(where), n);
  }
}
