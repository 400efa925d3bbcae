package dct.core.triangulate;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.dcel.HalfEdges;
import dct.core.geometry.Crossings;
import dct.core.geometry.PlaneOrder;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.SweepStatus;
import java.util.ArrayList;
import java.util.List;

/**
 * Cuts a region into y-monotone pieces by trapezoidalization (thesis, Algorithm 2.2, which is for
 * simple polygons).
 *
 * <p>Takes any simple polygon or region, straight vertices and level edges included: "above" means
 * higher in the order by y, then x. Returns the pieces, or the trapezoid chords of Figure 2.4.
 *
 * <p>Plane sweep after Garey, Johnson, Preparata and Tarjan (1978): the sweep line passes over
 * trapezoids, each known by its left edge; the supporting vertex on its upper side is kept. Where
 * an interior cusp appears on a trapezoid's lower side, or one was on its upper side, the two
 * supporting vertices are joined. A site is a cusp both ways; a fixed edge parts two trapezoids,
 * and an end of it without another edge on that side is a cusp. O(n log n) expected time, O(n)
 * space, exact. At most one diagonal a cusp; ties cannot occur, since no two vertices are level.
 */
public final class MonotonePartition {
  private final Region region;
  private final boolean isPolygon; // without holes, sites and fixed edges
  private final Points points;
  private final int n;
  private final int[] order; // vertices, lowest first
  private final int[] rank; // place of each vertex in that order
  private final Dcel pieces; // of a polygon, cut one after the other; null otherwise
  private final RegionLinks edges; // null for a polygon, as the next one is
  private final HalfEdges links; // an edge between two rings parts nothing: faces come at the end
  private final SweepStatus status; // the left edges of the trapezoids; edge k leaves position k
  private final int[] rightOf; // by left edge: the right edge of its trapezoid
  private final int[] leftOf; // by right edge: the left edge of its trapezoid
  private final int[]
      support; // by left edge: the half-edge that leaves the upper supporting vertex
  private final boolean[] hangs; // by left edge: that vertex is a cusp above the trapezoid
  private final List<Chord> chords; // null unless wanted

  private MonotonePartition(Region region, boolean withChords, Progress progress) {
    this.region = region;
    isPolygon = region.isPolygon();
    points = region.points();
    n = region.size();
    order = PlaneOrder.byYThenX(points, progress);
    rank = new int[n];
    for (int k = 0; k < n; k++) {
      Progress.check(progress, k);
      rank[order[k]] = k;
    }
    pieces = isPolygon ? Dcel.cycle(region.walk()) : null;
    edges = isPolygon ? null : new RegionLinks(region, rank);
    links = isPolygon ? null : edges.links();
    int bound = region.positions() + region.rings().fixedCount();
    status = new SweepStatus(points, bound);
    rightOf = new int[bound];
    leftOf = new int[bound];
    support = new int[bound];
    hangs = new boolean[bound];
    chords = withChords ? new ArrayList<>() : null;
  }

  /**
   * The monotone pieces of a simple polygon.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Partition partition(SimplePolygon polygon, Progress progress) {
    return partition(Region.of(polygon), progress);
  }

  /**
   * The monotone pieces of a region. Its edges are numbered so: those of rings by their positions,
   * then the fixed ones, then those of the partition.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Partition partition(Region region, Progress progress) {
    MonotonePartition run = new MonotonePartition(region, false, progress);
    run.sweep(progress);
    return new Partition(
        region,
        run.isPolygon ? run.pieces : Dcel.of(run.n, run.links, run.edges.outside(), progress));
  }

  /**
   * The trapezoid chords of a simple polygon: see {@link #chords(Region, Progress)}.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static List<Chord> chords(SimplePolygon polygon, Progress progress) {
    return chords(Region.of(polygon), progress);
  }

  /**
   * The trapezoid chords of a region: from each vertex, level, to the first point of an edge, where
   * the inside is between. They are the lines of Figure 2.4, for pictures of how the partition
   * comes about: each end is rounded towards its vertex, so that no chord leaves the region,
   * whatever the scale.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static List<Chord> chords(Region region, Progress progress) {
    MonotonePartition run = new MonotonePartition(region, true, progress);
    run.sweep(progress);
    return List.copyOf(run.chords);
  }

  /**
   * A level line of sight.
   *
   * @param vertex where it starts
   * @param x where it meets the boundary, rounded towards the vertex
   * @param y the y-coordinate of both ends
   */
  public record Chord(int vertex, double x, double y) {}

  private void sweep(Progress progress) {
    for (int i = n - 1; i >= 0; i--) {
      Progress.tick(progress, n - 1 - i, n, "Cutting into monotone pieces");
      int v = order[i];
      if (isPolygon || !edges.hasStar(v)) {
        visit(v, region.position(v));
      } else {
        star(v);
      }
    }
  }

  private int vertex(int k) {
    return region.vertex(k);
  }

  private int after(int k) {
    if (isPolygon) {
      return k + 1 == n ? 0 : k + 1;
    }
    return region.after(k);
  }

  private int before(int k) {
    if (isPolygon) {
      return k == 0 ? n - 1 : k - 1;
    }
    return region.before(k);
  }

  /** Vertex v at position k, which has two edges of a ring and no other. */
  private void visit(int v, int k) {
    boolean arrivesFromAbove = rank[vertex(before(k))] > rank[v];
    boolean leavesUpwards = rank[vertex(after(k))] > rank[v];
    if (arrivesFromAbove && !leavesUpwards) {
      passLeft(v, k);
    } else if (!arrivesFromAbove && leavesUpwards) {
      passRight(v, k);
    } else {
      boolean convex = turn(v, k) > 0;
      if (arrivesFromAbove) {
        meet(v, k, convex);
      } else {
        part(v, k, convex);
      }
    }
  }

  private int turn(int v, int k) {
    return points.orient(vertex(before(k)), v, vertex(after(k)));
  }

  /** The boundary goes down through v, the inside is on its right. */
  private void passLeft(int v, int k) {
    int old = before(k);
    chord(v, rightOf[old], true);
    if (hangs[old]) {
      join(2 * k, support[old]);
    }
    status.replace(old, k, v, vertex(after(k)));
    openTrapezoid(k, rightOf[old], 2 * k, false);
  }

  /** The boundary goes up through v, the inside is on its left. */
  private void passRight(int v, int k) {
    int left = leftOf[k];
    chord(v, left, false);
    int corner = hangs[left] ? join(2 * k, support[left]) : 2 * k;
    openTrapezoid(left, before(k), corner, false);
  }

  /** Both edges of v go down: the inside starts here, or is parted by a cusp. */
  private void part(int v, int k, boolean convex) {
    int left = status.search(v);
    int right = left == SweepStatus.NONE ? left : rightOf[left];
    status.insertAfter(left, k, v, vertex(after(k)));
    if (convex) {
      openTrapezoid(k, before(k), 2 * k, false);
      return;
    }
    chord(v, left, false);
    chord(v, right, true);
    int corner = join(2 * k, support[left]);
    openTrapezoid(k, right, 2 * k, false);
    openTrapezoid(left, before(k), corner, false);
  }

  /** Both edges of v go up: the inside ends here, or two parts of it meet at a cusp. */
  private void meet(int v, int k, boolean convex) {
    int right = before(k); // the left edge of the trapezoid that ends, or is right of the cusp
    if (hangs[right]) {
      join(2 * k, support[right]);
    }
    int left = status.before(right);
    status.remove(right);
    if (convex) {
      return;
    }
    chord(v, left, false);
    chord(v, rightOf[right], true);
    int corner = hangs[left] ? join(2 * k, support[left]) : 2 * k;
    openTrapezoid(left, rightOf[right], corner, true);
  }

  /** A site, or an end of fixed edges: the general case. */
  private void star(int v) {
    int[] above = edges.above(v);
    int[] below = edges.below(v);
    for (int i = 0; i + 1 < above.length; i++) {
      if (edges.isInsideRight(above[i]) && hangs[above[i]]) {
        join(edges.leaving(above[i + 1], v), support[above[i]]);
      }
    }
    if (above.length + below.length == 0) {
      site(v);
    } else if (above.length == 0) {
      partStar(v, below);
    } else if (below.length == 0) {
      meetStar(v, above);
    } else {
      passStar(v, above, below);
    }
    for (int i = 0; i + 1 < below.length; i++) {
      if (edges.isInsideRight(below[i])) {
        openTrapezoid(below[i], below[i + 1], edges.leaving(below[i], v), false);
      }
    }
  }

  private void site(int v) {
    int left = status.search(v);
    int right = rightOf[left];
    chord(v, left, false);
    chord(v, right, true);
    openTrapezoid(left, right, links.hang(links.take(), v, support[left]), true);
  }

  private void partStar(int v, int[] below) {
    int left = status.search(v);
    insertAll(left, below, v);
    if (!edges.isInsideLeft(below[0])) {
      return;
    }
    int last = below[below.length - 1];
    int corner = edges.leaving(last, v);
    int right = rightOf[left];
    chord(v, left, false);
    chord(v, right, true);
    int joined = join(corner, support[left]);
    openTrapezoid(last, right, corner, false);
    openTrapezoid(left, below[0], joined, false);
  }

  private void meetStar(int v, int[] above) {
    int first = above[0];
    int last = above[above.length - 1];
    boolean inside = edges.isInsideLeft(first);
    int left = inside ? leftOf[first] : SweepStatus.NONE;
    int right = inside ? rightOf[last] : SweepStatus.NONE;
    removeAll(above);
    if (!inside) {
      return;
    }
    chord(v, left, false);
    chord(v, right, true);
    int corner = edges.leaving(first, v);
    if (hangs[last]) {
      join(corner, support[last]);
    }
    int joined = hangs[left] ? join(corner, support[left]) : corner;
    openTrapezoid(left, right, joined, true);
  }

  private void passStar(int v, int[] above, int[] below) {
    int first = above[0];
    int last = above[above.length - 1];
    int lowest = below[below.length - 1];
    boolean insideLeft = edges.isInsideLeft(first);
    boolean insideRight = edges.isInsideRight(last);
    int left = insideLeft ? leftOf[first] : status.before(first);
    int right = insideRight ? rightOf[last] : SweepStatus.NONE;
    removeAll(above);
    insertAll(left, below, v);
    if (insideLeft) {
      chord(v, left, false);
      int corner = edges.leaving(first, v);
      int joined = hangs[left] ? join(corner, support[left]) : corner;
      openTrapezoid(left, below[0], joined, false);
    }
    if (insideRight) {
      chord(v, right, true);
      int corner = edges.leaving(lowest, v);
      if (hangs[last]) {
        join(corner, support[last]);
      }
      openTrapezoid(lowest, right, corner, false);
    }
  }

  private void removeAll(int[] above) {
    for (int edge : above) {
      if (edges.isInsideRight(edge)) {
        status.remove(edge);
      }
    }
  }

  private void insertAll(int left, int[] below, int v) {
    int before = left;
    for (int edge : below) {
      if (edges.isInsideRight(edge)) {
        status.insertAfter(before, edge, v, edges.otherEnd(edge, v));
        before = edge;
      }
    }
  }

  /** A new edge between two corners; the half-edge that leaves the first. */
  private int join(int a, int b) {
    return isPolygon ? pieces.splitFace(a, b) : links.connect(links.take(), a, b);
  }

  private void openTrapezoid(int left, int right, int upperSupport, boolean cusp) {
    rightOf[left] = right;
    leftOf[right] = left;
    support[left] = upperSupport;
    hangs[left] = cusp;
  }

  /**
   * Adds the chord from v to the edge, or to a level vertex before it. One of no length, or along a
   * level edge, is left out.
   */
  private void chord(int v, int edge, boolean rightwards) {
    if (chords == null) {
      return;
    }
    double to = levelX(v, edge, rightwards);
    int w = rank[v] + (rightwards ? 1 : -1); // no other vertex can be level and nearer
    if (w >= 0 && w < n && points.y(order[w]) == points.y(v)) {
      if (areJoined(v, order[w])) {
        return;
      }
      to = nearer(to, points.x(order[w]), rightwards);
    }
    if (to != points.x(v)) {
      chords.add(new Chord(v, to, points.y(v)));
    }
  }

  private boolean areJoined(int v, int w) {
    int k = region.position(v);
    int level = region.position(w);
    boolean neighbours =
        k != Points.NONE && (level == region.before(k) || level == region.after(k));
    return neighbours || region.isFixed(v, w);
  }

  /** Where the level line from v meets the edge, rounded towards v. */
  private double levelX(int v, int edge, boolean rightwards) {
    int a = isPolygon ? vertex(edge) : edges.from(edge);
    int b = isPolygon ? vertex(after(edge)) : edges.to(edge);
    return points.y(a) == points.y(b)
        ? nearer(points.x(a), points.x(b), rightwards)
        : Crossings.levelX(points, a, b, points.y(v), rightwards);
  }

  private static double nearer(double x1, double x2, boolean rightwards) {
    return rightwards ? Math.min(x1, x2) : Math.max(x1, x2);
  }
}
