package dct.core.triangulate;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Crossings;
import dct.core.geometry.PlaneOrder;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.SweepStatus;
import java.util.ArrayList;
import java.util.List;

/**
 * Cuts a simple polygon into y-monotone pieces by trapezoidalization (thesis, Algorithm 2.2).
 *
 * <p>Takes any simple polygon, straight vertices and level edges included: "above" means higher in
 * the order by y, then x. Returns the pieces, or the trapezoid chords of Figure 2.4.
 *
 * <p>Plane sweep after Garey, Johnson, Preparata and Tarjan (1978): the sweep line passes over
 * trapezoids, each known by its left edge; the supporting vertex on its upper side is kept. Where
 * an interior cusp appears on a trapezoid's lower side, or one was on its upper side, the two
 * supporting vertices are joined. O(n log n) expected time, O(n) space, exact. At most one diagonal
 * a cusp; ties cannot occur, since no two vertices are level.
 */
public final class MonotonePartition {
  private final SimplePolygon polygon;
  private final Points points;
  private final int n;
  private final int[] order; // vertices, lowest first
  private final int[] rank; // place of each position's vertex in that order
  private final Dcel dcel;
  private final SweepStatus status; // the left edges of the trapezoids; edge k leaves position k
  private final int[] opposite; // by edge of a trapezoid, left or right: its edge on the other side
  private final int[]
      support; // by left edge: the half-edge that leaves the upper supporting vertex
  private final boolean[] hangs; // by left edge: that vertex is a cusp above the trapezoid
  private final List<Chord> chords; // null unless wanted

  private MonotonePartition(SimplePolygon polygon, boolean withChords, Progress progress) {
    this.polygon = polygon;
    points = polygon.points();
    n = polygon.size();
    order = PlaneOrder.byYThenX(points, progress);
    rank = new int[n];
    for (int k = 0; k < n; k++) {
      Progress.check(progress, k);
      rank[position(order[k])] = k;
    }
    dcel = Dcel.cycle(polygon.walk());
    status = new SweepStatus(points, n);
    opposite = new int[n];
    support = new int[n];
    hangs = new boolean[n];
    chords = withChords ? new ArrayList<>() : null;
  }

  /**
   * The monotone pieces of a simple polygon.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Partition partition(SimplePolygon polygon, Progress progress) {
    MonotonePartition run = new MonotonePartition(polygon, false, progress);
    run.sweep(progress);
    return new Partition(polygon, run.dcel);
  }

  /**
   * The trapezoid chords of a simple polygon: from each vertex, level, to the first point of the
   * boundary, where the inside is between. They are the lines of Figure 2.4, for pictures of how
   * the partition comes about: each end is rounded towards its vertex, so that no chord leaves the
   * polygon, whatever the scale.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static List<Chord> chords(SimplePolygon polygon, Progress progress) {
    MonotonePartition run = new MonotonePartition(polygon, true, progress);
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

  /** The position of a vertex on the counter-clockwise walk; its own inverse. */
  private int position(int v) {
    return polygon.vertex(v);
  }

  private int after(int k) {
    return k + 1 == n ? 0 : k + 1;
  }

  private int before(int k) {
    return k == 0 ? n - 1 : k - 1;
  }

  private void sweep(Progress progress) {
    for (int i = n - 1; i >= 0; i--) {
      Progress.tick(progress, n - 1 - i, n, "Cutting into monotone pieces");
      visit(position(order[i]));
    }
  }

  private void visit(int k) {
    boolean arrivesFromAbove = rank[before(k)] > rank[k];
    boolean leavesUpwards = rank[after(k)] > rank[k];
    if (arrivesFromAbove && !leavesUpwards) {
      passLeft(k);
    } else if (!arrivesFromAbove && leavesUpwards) {
      passRight(k);
    } else {
      boolean convex = turn(k) > 0;
      if (arrivesFromAbove) {
        meet(k, convex);
      } else {
        part(k, convex);
      }
    }
  }

  private int turn(int k) {
    return points.orient(polygon.vertex(before(k)), polygon.vertex(k), polygon.vertex(after(k)));
  }

  /** The boundary goes down through k, the inside is on its right. */
  private void passLeft(int k) {
    int old = before(k);
    chord(k, opposite[old], true);
    if (hangs[old]) {
      dcel.splitFace(2 * k, support[old]);
    }
    status.replace(old, k, polygon.vertex(k), polygon.vertex(after(k)));
    openTrapezoid(k, opposite[old], 2 * k, false);
  }

  /** The boundary goes up through k, the inside is on its left. */
  private void passRight(int k) {
    int left = opposite[k];
    chord(k, left, false);
    int corner = hangs[left] ? dcel.splitFace(2 * k, support[left]) : 2 * k;
    openTrapezoid(left, before(k), corner, false);
  }

  /** Both edges of k go down: the inside starts here, or is parted by a cusp. */
  private void part(int k, boolean convex) {
    int left = status.search(polygon.vertex(k));
    status.insertAfter(left, k, polygon.vertex(k), polygon.vertex(after(k)));
    if (convex) {
      openTrapezoid(k, before(k), 2 * k, false);
      return;
    }
    chord(k, left, false);
    chord(k, opposite[left], true);
    int corner = dcel.splitFace(2 * k, support[left]);
    openTrapezoid(k, opposite[left], 2 * k, false);
    openTrapezoid(left, before(k), corner, false);
  }

  /** Both edges of k go up: the inside ends here, or two parts of it meet at a cusp. */
  private void meet(int k, boolean convex) {
    int right = before(k); // the left edge of the trapezoid that ends, or is right of the cusp
    if (hangs[right]) {
      dcel.splitFace(2 * k, support[right]);
    }
    int left = status.before(right);
    status.remove(right);
    if (convex) {
      return;
    }
    chord(k, left, false);
    chord(k, opposite[right], true);
    int corner = hangs[left] ? dcel.splitFace(2 * k, support[left]) : 2 * k;
    openTrapezoid(left, opposite[right], corner, true);
  }

  private void openTrapezoid(int left, int right, int upperSupport, boolean cusp) {
    opposite[left] = right;
    opposite[right] = left;
    support[left] = upperSupport;
    hangs[left] = cusp;
  }

  /**
   * Adds the chord from k to the edge, or to a level vertex before it. One of no length, or along a
   * level edge, is left out.
   */
  private void chord(int k, int edge, boolean rightwards) {
    if (chords == null) {
      return;
    }
    int v = polygon.vertex(k);
    double to = levelX(v, edge, rightwards);
    int w = rank[k] + (rightwards ? 1 : -1); // no other vertex can be level and nearer
    if (w >= 0 && w < n && points.y(order[w]) == points.y(v)) {
      int level = position(order[w]);
      if (level == before(k) || level == after(k)) {
        return;
      }
      to = nearer(to, points.x(order[w]), rightwards);
    }
    if (to != points.x(v)) {
      chords.add(new Chord(v, to, points.y(v)));
    }
  }

  /** Where the level line from v meets the edge, rounded towards v. */
  private double levelX(int v, int edge, boolean rightwards) {
    int a = polygon.vertex(edge);
    int b = polygon.vertex(after(edge));
    return points.y(a) == points.y(b)
        ? nearer(points.x(a), points.x(b), rightwards)
        : Crossings.levelX(points, a, b, points.y(v), rightwards);
  }

  private static double nearer(double x1, double x2, boolean rightwards) {
    return rightwards ? Math.min(x1, x2) : Math.max(x1, x2);
  }
}
