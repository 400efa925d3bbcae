package dct.core.geometry;

import dct.core.Progress;
import java.util.Arrays;
import java.util.Optional;

/**
 * Whether rings bound a region, or a closed chain of vertices a simple polygon; if not, where it
 * fails.
 *
 * <p>Takes any finite points. A chain is simple if it has three vertices or more, not all on one
 * line, no two of them coincide, no vertex lies on an edge that is not its own, and no two edges
 * meet but in their common vertex. Straight (180°) vertices are allowed. {@link Rings} bound a
 * region if all this holds of all rings and fixed edges together, the holes lie in the outer ring
 * and none in another, and sites and fixed edges lie in the region.
 *
 * <p>Plane sweep of Shamos and Hoey (1976), O(n log n) expected time and O(n) space, exact. Among
 * several defects the one reported is: coinciding vertices, with the lowest number; then a spike,
 * at the lowest number; then what the sweep, from high to low y, finds first.
 */
public final class SimplicityCheck {
  private final Rings rings;
  private final boolean isChain; // the rings are one chain of all vertices in their order
  private final Points points;
  private final Progress progress;
  private final int n;
  private final int[] order; // lowest point first
  private final int[] rank; // place of each vertex in that order
  private final EdgeStars stars; // of the vertices that are not met by two edges of a ring alone
  private boolean[] insideRight; // by edge: the region is on its right; empty for a chain
  private int[] highest; // by ring: its highest vertex; empty for a chain
  private Defect defect; // the first one found, or null

  private SimplicityCheck(Rings rings, Progress progress) {
    this.rings = rings;
    this.isChain = rings.isChain();
    this.points = rings.points();
    this.progress = progress;
    n = points.size();
    order = PlaneOrder.byYThenX(points, progress);
    rank = new int[n];
    for (int k = 0; k < n; k++) {
      Progress.check(progress, k);
      rank[order[k]] = k;
    }
    stars = new EdgeStars(rings, rank);
  }

  /**
   * The first defect of the closed chain through these points, or nothing if it is simple.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Optional<Defect> firstDefect(Points points, Progress progress) {
    return firstDefect(Rings.ofChain(points), progress);
  }

  /**
   * The first defect of the rings, or nothing if they bound a region.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Optional<Defect> firstDefect(Rings rings, Progress progress) {
    for (int r = 0; r < rings.count(); r++) {
      if (rings.size(r) < 3) {
        int v = r == 0 ? 0 : rings.vertex(r, 0);
        Defect.Kind kind = r == 0 ? Defect.Kind.TOO_FEW : Defect.Kind.SMALL_HOLE;
        return Optional.of(new Defect(kind, v, v, 0, 0, rings.size(r)));
      }
    }
    return Optional.ofNullable(new SimplicityCheck(rings, progress).run());
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
      findInside();
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
    int a = rings.vertex(0, 0);
    int b = rings.vertex(0, 1);
    for (int k = 2; k < rings.size(0); k++) {
      Progress.check(progress, k);
      if (points.orient(a, b, rings.vertex(0, k)) != 0) {
        return;
      }
    }
    report(Defect.Kind.COLLINEAR, a, a, a);
  }

  private void findSpike() {
    for (int v = 0; v < n && defect == null; v++) {
      Progress.check(progress, v);
      if (!rings.isOnRing(v)) {
        continue;
      }
      boolean turnsBack = rank[before(v)] < rank[v] == rank[after(v)] < rank[v];
      if (turnsBack && points.orient(before(v), v, after(v)) == 0) {
        report(Defect.Kind.SPIKE, v, v, v);
      }
    }
  }

  private int after(int v) {
    if (isChain) {
      return v + 1 == n ? 0 : v + 1;
    }
    return rings.after(v);
  }

  private int before(int v) {
    if (isChain) {
      return v == 0 ? n - 1 : v - 1;
    }
    return rings.before(v);
  }

  private int from(int edge) {
    return edge < n ? edge : rings.from(edge);
  }

  private int to(int edge) {
    return edge < n ? after(edge) : rings.to(edge);
  }

  /** On which side of each edge the region is, if the rings bound one. */
  private void findInside() {
    boolean chain = rings.isChain();
    insideRight = new boolean[chain ? 0 : n + rings.fixedCount()];
    highest = new int[chain ? 0 : rings.count()];
    Arrays.fill(insideRight, chain ? 0 : n, insideRight.length, true);
    for (int r = 0; r < highest.length; r++) {
      Progress.check(progress, r);
      int top = rings.vertex(r, 0);
      for (int k = 1; k < rings.size(r); k++) {
        top = rank[rings.vertex(r, k)] > rank[top] ? rings.vertex(r, k) : top;
      }
      highest[r] = top;
      boolean clockwise = points.orient(before(top), top, after(top)) < 0;
      boolean insideLeft = clockwise == r > 0; // of a walk along the ring as it was given
      for (int k = 0; k < rings.size(r); k++) {
        int v = rings.vertex(r, k);
        boolean down = rank[after(v)] < rank[v];
        insideRight[v] = down == insideLeft;
      }
    }
  }

  private void sweep() {
    SweepStatus status = new SweepStatus(points, n + rings.fixedCount());
    for (int k = n - 1; k >= 0 && defect == null; k--) {
      Progress.tick(progress, n - 1 - k, n, "Checking that the boundary is simple");
      int v = order[k];
      if (isChain || !stars.has(v)) {
        boundary(status, v);
      } else {
        star(status, v);
      }
    }
  }

  /** A vertex with two edges of a ring and no other. */
  private void boundary(SweepStatus status, int v) {
    boolean arrivesFromAbove = rank[before(v)] > rank[v];
    boolean leavesUpwards = rank[after(v)] > rank[v];
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

  /** A site, or a vertex with fixed edges: those from above end here, then those below start. */
  private void star(SweepStatus status, int v) {
    int[] above = stars.above(v);
    int[] below = stars.below(v);
    compareAll(above);
    compareAll(below);
    if (defect != null) {
      return;
    }
    int l;
    if (above.length == 0) {
      l = status.search(v);
      if (status.touched() != SweepStatus.NONE) {
        reportTouch(v, status.touched());
        return;
      }
      findStray(l, v);
    } else {
      l = status.before(above[0]);
      for (int edge : above) {
        status.remove(edge);
      }
    }
    int r = status.after(l);
    int left = l;
    for (int edge : below) {
      if (edge >= n && defect == null && !isInsideRight(left)) {
        reportEdge(Defect.Kind.STRAY_EDGE, edge, edge, v);
      }
      status.insertAfter(left, edge, v, stars.otherEnd(edge, v));
      left = edge;
    }
    if (below.length == 0) {
      comparePair(l, r);
    } else {
      comparePair(l, below[0]);
      comparePair(left, r);
    }
  }

  private void compareAll(int[] fan) {
    for (int i = 1; i < fan.length; i++) {
      if (defect == null && stars.areAligned(fan[i - 1], fan[i])) {
        compare(Math.min(fan[i - 1], fan[i]), Math.max(fan[i - 1], fan[i]));
      }
    }
  }

  /** Whether the region is on the right of this edge; on the left of all edges it is not. */
  private boolean isInsideRight(int edge) {
    return edge != SweepStatus.NONE && insideRight[edge];
  }

  /**
   * Of a vertex without an edge above it: whether it is the highest of a hole or a site, and not in
   * the region.
   *
   * @param left the edge on its left
   */
  private void findStray(int left, int v) {
    if (isChain || defect != null || isInsideRight(left)) {
      return;
    }
    int r = rings.ringOf(v);
    if (r == Points.NONE) {
      report(Defect.Kind.STRAY_SITE, v, v, v);
    } else if (r > 0 && highest[r] == v) {
      int around = left == SweepStatus.NONE ? 0 : rings.ringOf(left);
      report(Defect.Kind.STRAY_HOLE, v, around > 0 ? rings.vertex(around, 0) : v, v);
    }
  }

  private void start(SweepStatus status, int v) {
    int l = status.search(v);
    if (status.touched() != SweepStatus.NONE) {
      reportTouch(v, status.touched());
      return;
    }
    findStray(l, v);
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
    if (both && defect == null && !haveCommonEnd(e, f)) {
      compare(Math.min(e, f), Math.max(e, f));
    }
  }

  private boolean haveCommonEnd(int e, int f) {
    if (isChain) {
      return after(e) == f || after(f) == e;
    }
    int a = from(e);
    int b = to(e);
    int c = from(f);
    int d = to(f);
    return b == c || a == d || a == c || b == d;
  }

  private void compare(int e, int f) {
    int a = from(e);
    int b = to(e);
    int c = from(f);
    int d = to(f);
    int abc = points.orient(a, b, c);
    int abd = points.orient(a, b, d);
    int cda = points.orient(c, d, a);
    int cdb = points.orient(c, d, b);
    if (abc * abd < 0 && cda * cdb < 0) {
      defect = Crossings.defect(points, a, b, c, d);
    } else if (abc == 0 && abd == 0) {
      if (isBetween(a, c, d) || isBetween(b, c, d) || isBetween(c, a, b) || isBetween(d, a, b)) {
        int inside = isBetween(a, c, d) ? a : isBetween(b, c, d) ? b : isBetween(c, a, b) ? c : d;
        reportEdge(Defect.Kind.OVERLAP, e, f, inside);
      }
    } else {
      findTouch(abc, c, e);
      findTouch(abd, d, e);
      findTouch(cda, a, f);
      findTouch(cdb, b, f);
    }
  }

  private void findTouch(int side, int v, int edge) {
    if (side == 0 && defect == null && isBetween(v, from(edge), to(edge))) {
      reportTouch(v, edge);
    }
  }

  private boolean isBetween(int v, int a, int b) {
    return v != a && v != b && rank[a] < rank[v] == rank[v] < rank[b];
  }

  private void reportTouch(int v, int edge) {
    int from = from(edge);
    int to = to(edge);
    defect = new Defect(Defect.Kind.TOUCH, v, v, from, to, points.x(v), points.y(v), n);
  }

  /** Reports a fault of edges, which is to be seen at a vertex. */
  private void reportEdge(Defect.Kind kind, int e, int f, int where) {
    double x = points.x(where);
    double y = points.y(where);
    defect = new Defect(kind, from(e), to(e), from(f), to(f), x, y, n);
  }

  /** Reports a fault of one or two vertices. */
  private void report(Defect.Kind kind, int first, int second, int where) {
    double x = points.x(where);
    double y = points.y(where);
    defect = new Defect(kind, first, first, second, second, x, y, n);
  }
}
