package dct.core.triangulate;

import dct.core.Progress;
import dct.core.dcel.HalfEdges;
import dct.core.dcel.HalfEdges.FreeEdges;
import dct.core.geometry.Points;
import dct.core.geometry.Predicates;
import java.util.concurrent.RecursiveTask;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * The recursion of {@link Delaunay} over {@link KdOrder}, on {@link HalfEdges}; names as in Guibas
 * and Stolfi (1985), Figure 23. {@link ConstrainedDelaunay} starts with it, too.
 *
 * <p>The part [lo, hi) owns the edges 3·lo … 3·hi − 1, which is enough, since m sites have at most
 * 3m − 3 edges. Each part has its own list of those not in use, so that parts can be computed in
 * parallel. The arrays of the links are read directly, since every call would cost here.
 */
final class DelaunayMerge {
  private static final int PARALLEL = 1 << 10; // parts of at least this size are forked
  private static final int REPORTED = 1 << 13; // parts of at least this size report progress

  private final HalfEdges links; // between places in the order
  private final int[] next;
  private final int[] prev;
  private final int[] origin;
  private final KdOrder order;
  private final double[] x;
  private final double[] y;
  private final Progress progress;
  private final AtomicInteger done = new AtomicInteger();

  DelaunayMerge(Points points, Progress progress) {
    this.progress = progress;
    progress.report(0, "Sorting the sites");
    order = new KdOrder(points, progress);
    x = order.x;
    y = order.y;
    links = new HalfEdges(3 * x.length, 3 * x.length);
    next = links.next();
    prev = links.prev();
    origin = links.origin();
  }

  /** Triangulates all sites, two or more; returns a half-edge of the outer face. */
  int run() {
    return new Task(0, x.length, true, KdOrder.ROOT).invoke().ldo ^ 1;
  }

  /** The order of the sites; what {@link #placed} links are places in it. */
  KdOrder order() {
    return order;
  }

  /** The links between the places of the sites. */
  HalfEdges placed() {
    return links;
  }

  /** The links between the sites; those between the places are gone afterwards. */
  HalfEdges links() {
    for (int e = 0; e < origin.length; e++) {
      if (next[e] != HalfEdges.NONE) {
        origin[e] = order.site[origin[e]];
      }
    }
    return links;
  }

  /** What a merge needs to know of a triangulated part. */
  private static final class Part {
    int ldo; // counter-clockwise hull half-edge that leaves the first site along the axis
    int rdo; // clockwise hull half-edge that leaves the last site along the axis
    final FreeEdges free = new FreeEdges(); // the part's edges not in use
  }

  private final class Task extends RecursiveTask<Part> {
    private static final long serialVersionUID = 1L;
    private final int lo;
    private final int hi;
    private final boolean byX;
    private final int node;

    Task(int lo, int hi, boolean byX, int node) {
      this.lo = lo;
      this.hi = hi;
      this.byX = byX;
      this.node = node;
    }

    @Override
    protected Part compute() {
      return triangulate(lo, hi, byX, node);
    }
  }

  /** Triangulates the part [lo, hi), which is that of the node if it has one. */
  private Part triangulate(int lo, int hi, boolean byX, int node) {
    if (hi - lo <= KdOrder.LEAF) {
      order.sortFew(lo, hi);
      return triangulateSorted(lo, hi);
    }
    int middle = order.cellCut(node);
    if (middle == lo) {
      return triangulate(lo, hi, !byX, 2 * node + 1);
    }
    if (middle == hi) {
      return triangulate(lo, hi, !byX, 2 * node);
    }
    if (middle > lo + 1 && middle < hi - 1) {
      return halves(lo, middle, hi, byX, 2 * node, 2 * node + 1);
    }
    return halves(lo, order.cutAtMedian(lo, hi, byX), hi, byX, KdOrder.MEDIANS, KdOrder.MEDIANS);
  }

  private Part halves(int lo, int middle, int hi, boolean byX, int leftNode, int rightNode) {
    if (hi - lo < PARALLEL) {
      Part left = triangulate(lo, middle, !byX, leftNode);
      return mergeAlong(left, triangulate(middle, hi, !byX, rightNode), byX, hi - lo);
    }
    Task left = new Task(lo, middle, !byX, leftNode);
    left.fork();
    Part right = triangulate(middle, hi, !byX, rightNode);
    return mergeAlong(left.join(), right, byX, hi - lo);
  }

  /** A few sites that are sorted by x: all cuts are by x, and nothing is turned. */
  private Part triangulateSorted(int lo, int hi) {
    if (hi - lo == 2) {
      return segment(lo);
    }
    if (hi - lo == 3) {
      return triangle(lo);
    }
    int middle = (lo + hi) >>> 1;
    return merge(triangulateSorted(lo, middle), triangulateSorted(middle, hi));
  }

  private Part mergeAlong(Part left, Part right, boolean byX, int sites) {
    if (sites >= REPORTED) {
      progress.checkCancelled();
      // Each level of the recursion handles every site once; the levels below are not reported.
      int levels = Integer.SIZE - Integer.numberOfLeadingZeros(x.length / REPORTED);
      double fraction = done.addAndGet(sites) / ((double) levels * x.length);
      progress.report(0.1 + 0.8 * Math.min(1, fraction), "Merging Delaunay triangulations");
    }
    turn(left, byX);
    turn(right, byX);
    return merge(left, right);
  }

  // ---- small parts

  private Part segment(int lo) {
    Part part = new Part();
    int a = links.segment(6 * lo, lo, lo + 1);
    part.ldo = a;
    part.rdo = a ^ 1;
    release(part, 3 * lo + 1, 3 * (lo + 2));
    return part;
  }

  private Part triangle(int lo) {
    Part part = new Part();
    int a = links.segment(6 * lo, lo, lo + 1);
    int b = links.segment(6 * lo + 2, lo + 1, lo + 2);
    links.link(a, b);
    links.link(b ^ 1, a ^ 1);
    int turn = orient(lo, lo + 1, lo + 2);
    int firstFree = 3 * lo + 2;
    part.ldo = a;
    part.rdo = b ^ 1;
    if (turn != 0) {
      int c = links.connect(2 * firstFree++, b ^ 1, a);
      if (turn < 0) {
        part.ldo = c ^ 1;
        part.rdo = c;
      }
    }
    release(part, firstFree, 3 * (lo + 3));
    return part;
  }

  private void release(Part part, int firstEdge, int endEdge) {
    for (int edge = endEdge - 1; edge >= firstEdge; edge--) {
      links.give(part.free, 2 * edge);
    }
  }

  // ---- the hull: counter-clockwise half-edges, whose twins border the outer face

  /** Moves the part's two half-edges along the hull to its first and last site by x or by y. */
  private void turn(Part part, boolean byX) {
    int e = part.ldo;
    while (precedes(e ^ 1, e, byX)) {
      e = hullAfter(e);
    }
    while (precedes(hullBefore(e), e, byX)) {
      e = hullBefore(e);
    }
    int f = part.rdo ^ 1;
    while (precedes(f ^ 1, f, byX)) {
      f = hullBefore(f);
    }
    while (precedes(f ^ 1, hullAfter(f) ^ 1, byX)) {
      f = hullAfter(f);
    }
    part.ldo = e;
    part.rdo = f ^ 1;
  }

  /** Whether the site that e leaves precedes the one that f leaves. */
  private boolean precedes(int e, int f, boolean byX) {
    return order.precedes(origin[e], origin[f], byX);
  }

  private int hullAfter(int e) {
    return prev[e ^ 1] ^ 1;
  }

  private int hullBefore(int e) {
    return next[e ^ 1] ^ 1;
  }

  // ---- the merge

  /** Joins two parts, all sites of the first before all of the second along the axis. */
  private Part merge(Part left, Part right) {
    int ldo = left.ldo;
    int ldi = left.rdo;
    int rdi = right.ldo;
    int rdo = right.rdo;
    while (true) { // to the lower common tangent
      if (isLeftOf(origin[rdi], ldi)) {
        ldi = next[ldi];
      } else if (isRightOf(origin[ldi], rdi)) {
        rdi = hullAfter(rdi);
      } else {
        break;
      }
    }
    Part part = left;
    links.append(part.free, right.free);
    int basel = connect(part, rdi ^ 1, ldi);
    part.ldo = origin[ldi] == origin[ldo] ? basel ^ 1 : ldo;
    part.rdo = origin[rdi] == origin[rdo] ? basel : rdo;
    rise(part, basel);
    return part;
  }

  /** Merges upwards from the base edge, which runs from the right part to the left one. */
  private void rise(Part part, int lowerTangent) {
    int basel = lowerTangent;
    while (true) {
      int lcand = leftCandidate(part, basel);
      int rcand = rightCandidate(part, basel);
      if (lcand == HalfEdges.NONE && rcand == HalfEdges.NONE) {
        return; // the upper common tangent
      }
      boolean takeRight =
          lcand == HalfEdges.NONE
              || (rcand != HalfEdges.NONE
                  && inCircle(origin[lcand ^ 1], origin[lcand], origin[rcand], origin[rcand ^ 1]));
      basel = takeRight ? connect(part, rcand, basel ^ 1) : connect(part, basel ^ 1, lcand ^ 1);
    }
  }

  /**
   * The edge from the base's left end to the site that the rising bubble meets first, after
   * removing those that the bubble destroys; {@link HalfEdges#NONE} if no site there is above the
   * base.
   */
  private int leftCandidate(Part part, int basel) {
    int lcand = prev[basel ^ 1] ^ 1;
    if (!isRightOf(origin[lcand ^ 1], basel)) {
      return HalfEdges.NONE;
    }
    int following = prev[lcand] ^ 1;
    while (destroys(basel, lcand, following)) {
      delete(part, lcand);
      lcand = following;
      following = prev[lcand] ^ 1;
    }
    return lcand;
  }

  /** The same from the base's right end. */
  private int rightCandidate(Part part, int basel) {
    int rcand = next[basel ^ 1];
    if (!isRightOf(origin[rcand ^ 1], basel)) {
      return HalfEdges.NONE;
    }
    int following = next[rcand ^ 1];
    while (destroys(basel, rcand, following)) {
      delete(part, rcand);
      rcand = following;
      following = next[rcand ^ 1];
    }
    return rcand;
  }

  /**
   * Whether the end of {@code following} is inside the circle through the base and the candidate.
   */
  private boolean destroys(int basel, int candidate, int following) {
    return inCircle(origin[basel ^ 1], origin[basel], origin[candidate ^ 1], origin[following ^ 1]);
  }

  // ---- operators

  /** A new edge from the end of a to the start of b, on the left of both. */
  private int connect(Part part, int a, int b) {
    return links.connect(links.take(part.free), next[a], b);
  }

  private void delete(Part part, int e) {
    links.remove(e);
    links.give(part.free, e);
  }

  // ---- predicates on places

  private int orient(int a, int b, int c) {
    return Predicates.orient(x[a], y[a], x[b], y[b], x[c], y[c]);
  }

  private boolean isLeftOf(int v, int e) {
    return orient(v, origin[e], origin[e ^ 1]) > 0;
  }

  private boolean isRightOf(int v, int e) {
    return orient(v, origin[e ^ 1], origin[e]) > 0;
  }

  private boolean inCircle(int a, int b, int c, int d) {
    return Predicates.inCircle(x[a], y[a], x[b], y[b], x[c], y[c], x[d], y[d]) > 0;
  }
}
