package dct.io.format.mesh;

import dct.core.Progress;
import dct.core.geometry.PlaneOrder;
import dct.core.geometry.Points;
import dct.core.geometry.SweepStatus;
import java.util.Arrays;
import java.util.List;

/**
 * Which of some rings is the innermost one round each of some places. The rings are simple and do
 * not cross; of others it finds some ring, or none.
 *
 * <p>A line sweeps down over all rings and places; the edge to the left of a place tells. O(n log
 * n) expected.
 */
final class Nest {
  private static final int NONE = -1;
  private static final int UNMET = -2; // of a ring that the line has not reached

  private final Points points; // the corners of all rings, a ring after the other, then the places
  private final int[] rank; // of each point in the sweep
  private final int[] ring; // of each corner
  private final int[] next; // the corner behind each in its ring
  private final int[] before;
  private final SweepStatus status; // edge c goes from corner c to the next one
  private final int[] around; // the innermost ring round each ring
  private final boolean[] isLeftTurning;
  private final int[] found; // the ring round each place

  private Nest(Points vertices, List<int[]> rings, Points places) {
    int[] corners = rings.stream().flatMapToInt(Arrays::stream).toArray();
    int n = corners.length;
    double[] x = new double[n + places.size()];
    double[] y = new double[x.length];
    Arrays.setAll(x, i -> i < n ? vertices.x(corners[i]) : places.x(i - n));
    Arrays.setAll(y, i -> i < n ? vertices.y(corners[i]) : places.y(i - n));
    points = Points.of(x, y);
    rank = new int[x.length];
    ring = new int[n];
    next = new int[n];
    before = new int[n];
    status = new SweepStatus(points, n);
    around = new int[rings.size()];
    isLeftTurning = new boolean[rings.size()];
    found = new int[places.size()];
    Arrays.fill(around, UNMET);
    link(rings);
  }

  private void link(List<int[]> rings) {
    int first = 0;
    for (int r = 0; r < rings.size(); r++) {
      int end = first + rings.get(r).length;
      for (int c = first; c < end; c++) {
        ring[c] = r;
        next[c] = c + 1 == end ? first : c + 1;
        before[next[c]] = c;
      }
      first = end;
    }
  }

  /**
   * The number of the innermost ring round each place, -1 where there is none.
   *
   * @param rings each a list of vertices, at least three
   */
  static int[] innermost(Points vertices, List<int[]> rings, Points places) {
    Nest nest = new Nest(vertices, rings, places);
    nest.sweep();
    return nest.found;
  }

  private void sweep() {
    int[] order = PlaneOrder.byYThenX(points, Progress.NONE);
    for (int k = 0; k < order.length; k++) {
      rank[order[k]] = k;
    }
    for (int k = order.length - 1; k >= 0; k--) {
      int c = order[k];
      if (c >= ring.length) {
        found[c - ring.length] = ringAt(c);
      } else {
        meet(c);
      }
    }
  }

  private void meet(int c) {
    boolean arrivesFromAbove = rank[before[c]] > rank[c];
    boolean leavesUpwards = rank[next[c]] > rank[c];
    if (arrivesFromAbove && leavesUpwards) {
      status.remove(c);
      status.remove(before[c]);
    } else if (arrivesFromAbove) {
      status.replace(before[c], c, c, next[c]);
    } else if (leavesUpwards) {
      status.replace(c, before[c], c, before[c]);
    } else {
      start(c);
    }
  }

  private void start(int c) {
    int outside = ringAt(c);
    int left = status.search(c);
    boolean nextIsLeft = points.orient(before[c], c, next[c]) > 0;
    int leftEdge = nextIsLeft ? c : before[c];
    status.insertAfter(left, leftEdge, c, nextIsLeft ? next[c] : before[c]);
    status.insertAfter(leftEdge, nextIsLeft ? before[c] : c, c, nextIsLeft ? before[c] : next[c]);
    if (around[ring[c]] == UNMET) {
      around[ring[c]] = outside;
      isLeftTurning[ring[c]] = nextIsLeft;
    }
  }

  /** The innermost ring round a point that the line is at. */
  private int ringAt(int point) {
    int left = status.search(point);
    if (left == SweepStatus.NONE) {
      return NONE;
    }
    boolean goesDown = rank[next[left]] < rank[left];
    return goesDown == isLeftTurning[ring[left]] ? ring[left] : around[ring[left]];
  }
}
