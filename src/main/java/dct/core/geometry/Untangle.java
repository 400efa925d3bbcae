package dct.core.geometry;

import dct.core.Progress;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.Optional;

/**
 * Another order of a polygon's vertices in which its boundary is simple, found by exchanging edges
 * that meet.
 *
 * <p>Takes any points of which no two coincide and not all lie on one line; the vertices stay what
 * they are, only their order changes, and not at all if the boundary is simple already.
 *
 * <p>2-opt (Flood 1956; Croes 1958): of two edges ab and cd that meet, in this order along the
 * boundary, the part from b to c is turned round, which puts ac and bd in their places. Where the
 * edges lie on one line, a vertex of the one that lies inside the other is moved into it. Both make
 * the boundary shorter, so that it ends; whether edges meet is decided exactly. After van Leeuwen
 * and Schoone (1981) there are at most O(n³) exchanges, on random points about n are seen. Each
 * takes O(n) time and a look at the edges nearby in a grid.
 */
public final class Untangle {
  private final Points points;
  private final Progress progress;
  private final int n;
  private final int[] order; // the vertex at each place of the boundary
  private final int[] place; // of each vertex
  private final Deque<Integer> waiting = new ArrayDeque<>(); // vertices whose edges may meet others
  private final boolean[] isWaiting; // by vertex
  private EdgeGrid grid;
  private int exchanges;

  private Untangle(Points points, Progress progress) {
    this.points = points;
    this.progress = progress;
    n = points.size();
    order = new int[n];
    Arrays.setAll(order, i -> i);
    place = order.clone();
    isWaiting = new boolean[n];
  }

  /**
   * The vertices in an order in which the boundary is simple.
   *
   * @throws InvalidGeometryException if there is none: for want of a third vertex, since two
   *     coincide or all lie on one line
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static int[] order(Points points, Progress progress) {
    Optional<Defect> defect = SimplicityCheck.firstDefect(points, progress);
    if (defect.filter(Untangle::cannotBeMended).isPresent()) {
      throw new InvalidGeometryException(defect.get());
    }
    Untangle untangle = new Untangle(points, progress);
    if (defect.isPresent()) {
      untangle.run(EdgeGrid.cellsFor(points));
    }
    return untangle.order;
  }

  private static boolean cannotBeMended(Defect defect) {
    return switch (defect.kind()) {
      case TOO_FEW, COLLINEAR, DUPLICATE -> true;
      default -> false;
    };
  }

  /**
   * The cells of a grid are rounded; where an edge has slipped through, all pairs are looked at.
   */
  private void run(int cells) {
    grid = new EdgeGrid(points, cells);
    for (int i = 0; i < n; i++) {
      grid.add(order[i], at(i + 1));
      enqueue(order[i]);
    }
    while (!waiting.isEmpty()) {
      progress.checkCancelled();
      int v = waiting.poll();
      isWaiting[v] = false;
      if (mend(v, next(v)) || mend(previous(v), v)) {
        enqueue(v);
      }
    }
    if (cells > 1 && SimplicityCheck.firstDefect(ordered(), progress).isPresent()) {
      run(1);
    }
  }

  private Points ordered() {
    double[] x = new double[n];
    double[] y = new double[n];
    for (int i = 0; i < n; i++) {
      x[i] = points.x(order[i]);
      y[i] = points.y(order[i]);
    }
    return Points.of(x, y);
  }

  private void enqueue(int v) {
    if (!isWaiting[v]) {
      isWaiting[v] = true;
      waiting.add(v);
    }
  }

  private int at(int i) {
    return order[i >= n ? i - n : i < 0 ? i + n : i];
  }

  private int next(int v) {
    return at(place[v] + 1);
  }

  private int previous(int v) {
    return at(place[v] - 1);
  }

  private boolean isEdge(int u, int v) {
    return next(u) == v || next(v) == u;
  }

  /** Mends one meeting of the edge from a to the next vertex b; false if there is none. */
  private boolean mend(int a, int b) {
    return grid.anyNear(
        a, b, this::isEdge, (u, v) -> next(u) == v ? mend(a, b, u, v) : mend(a, b, v, u));
  }

  private boolean mend(int a, int b, int c, int d) {
    if (a == c) {
      return false; // the edge itself
    }
    if (points.orient(a, b, c) == 0 && points.orient(a, b, d) == 0) {
      return moveAway(a, c, d) || moveAway(b, c, d) || moveAway(c, a, b) || moveAway(d, a, b);
    }
    if (b == c || d == a || !meet(a, b, c, d)) {
      return false;
    }
    exchange(a, c);
    return true;
  }

  /** Whether two edges that are not on one line have a point in common. */
  private boolean meet(int a, int b, int c, int d) {
    return points.orient(a, b, c) * points.orient(a, b, d) <= 0
        && points.orient(c, d, a) * points.orient(c, d, b) <= 0;
  }

  /**
   * Puts the edges from a to c and between their next vertices in the place of those that leave.
   */
  private void exchange(int a, int c) {
    int b = next(a);
    int d = next(c);
    reverse(Math.min(place[a], place[c]) + 1, Math.max(place[a], place[c]));
    link(a, c);
    link(b, d);
    count();
  }

  /**
   * Moves vertex w into the edge from c to the next vertex d, on one line with it, if it lies there
   * and the boundary becomes shorter by that.
   */
  private boolean moveAway(int w, int c, int d) {
    int before = previous(w);
    int after = next(w);
    boolean shortens = isInside(w, c, d) && !isInside(w, before, after);
    if (shortens) {
      move(place[w], place[c]);
      link(before, after);
      link(previous(w), w);
      link(w, next(w));
      count();
    }
    return shortens;
  }

  /** Whether w lies on the segment from c to d, and is none of its ends. */
  private boolean isInside(int w, int c, int d) {
    return points.orient(c, w, d) == 0
        && w != c
        && w != d
        && (points.yxLess(c, w) ? points.yxLess(w, d) : points.yxLess(d, w));
  }

  /** Moves the vertex at place k to where it follows the one at place j. */
  private void move(int k, int j) {
    if (k < j) {
      reverse(k, j);
      reverse(k, j - 1);
    } else {
      reverse(j + 1, k);
      reverse(j + 2, k);
    }
  }

  private void reverse(int from, int to) {
    for (int i = from, j = to; i < j; i++, j--) {
      put(order[i], order[j], i, j);
    }
  }

  private void put(int u, int v, int i, int j) {
    order[i] = v;
    order[j] = u;
    place[v] = i;
    place[u] = j;
  }

  private void link(int u, int v) {
    grid.add(u, v);
    enqueue(u);
    enqueue(v);
  }

  private void count() {
    exchanges++;
    Progress.check(progress, exchanges);
    // How many there will be is not known; about n come before the last few.
    progress.report(1 - n / (n + (double) exchanges), exchanges + " edges exchanged");
  }
}
