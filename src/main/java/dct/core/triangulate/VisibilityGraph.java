package dct.core.triangulate;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import java.util.Arrays;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;

/**
 * The pairs of vertices of a simple polygon that see each other: its edges and all its diagonals.
 *
 * <p>Two vertices see each other if the open segment between them lies inside the polygon; one that
 * passes through a third vertex does not count. Vertices are known by their position on the
 * counter-clockwise walk ({@link SimplePolygon#vertex}); a pair by a number, 0 … {@link #pairs} −
 * 1, in the order of its lower and then of its higher position.
 *
 * <p>Triangular expansion (Bungiu et al. 2014): from each vertex a cone of sight is followed
 * through a triangulation and narrowed at each vertex that it meets. O(n) time a vertex at worst,
 * in practice the number of triangles that it sees; all cores are used. Exact. Since the vertices
 * seen come up in boundary order, nothing is sorted.
 */
public final class VisibilityGraph {
  private static final int VERTICES_A_TASK = 64;

  private final int[]
      upStart; // by position i: where its pairs (i, j), i < j, start; one more at end
  private final int[] upEnd; // by pair: the higher position j
  private final int[] downStart; // by position j: where its pairs (i, j), i < j, start
  private final int[] downEnd; // by slot: the lower positions i, ascending within one j

  private VisibilityGraph(int[][] seen, int pairs, Progress progress) {
    int n = seen.length;
    upStart = new int[n + 1];
    upEnd = new int[pairs];
    downStart = new int[n + 1];
    downEnd = new int[pairs];
    for (int i = 0; i < n; i++) {
      checkCancelled(i, progress);
      System.arraycopy(seen[i], 0, upEnd, upStart[i], seen[i].length);
      upStart[i + 1] = upStart[i] + seen[i].length;
      for (int j : seen[i]) {
        downStart[j + 1]++;
      }
    }
    Arrays.parallelPrefix(downStart, Integer::sum);
    int[] free = downStart.clone();
    for (int i = 0; i < n; i++) {
      checkCancelled(i, progress);
      for (int pair = upStart[i]; pair < upStart[i + 1]; pair++) {
        downEnd[free[upEnd[pair]]++] = i;
      }
    }
  }

  /**
   * The visibility graph, or null if it has more pairs than allowed.
   *
   * @param triangulation any triangulation of the polygon
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static VisibilityGraph of(
      SimplePolygon polygon, Triangulation triangulation, long mostPairs, Progress progress) {
    return within(polygon, triangulation, Integer.MAX_VALUE, mostPairs, progress);
  }

  /**
   * Of the visibility graph, the pairs whose segment crosses few edges of a triangulation, those
   * edges themselves included; or null if there are more than allowed. O(3n · 2^most) time.
   *
   * @param most so many edges may be crossed
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static VisibilityGraph within(
      SimplePolygon polygon,
      Triangulation triangulation,
      int most,
      long mostPairs,
      Progress progress) {
    int n = polygon.size();
    int[][] seen = new int[n][];
    AtomicLong pairs = new AtomicLong();
    AtomicInteger done = new AtomicInteger();
    IntStream.rangeClosed(0, (n - 1) / VERTICES_A_TASK)
        .parallel()
        .forEach(
            task -> {
              progress.report((double) done.get() / n, "Finding what each vertex sees");
              Cone cone = new Cone(polygon, triangulation, most);
              int first = task * VERTICES_A_TASK;
              int end = Math.min(n, first + VERTICES_A_TASK);
              for (int i = first; i < end && pairs.get() <= mostPairs; i++) {
                progress.checkCancelled();
                seen[i] = cone.seenAfter(i);
                pairs.addAndGet(seen[i].length);
              }
              done.addAndGet(end - first);
            });
    return pairs.get() <= mostPairs ? new VisibilityGraph(seen, pairs.intValue(), progress) : null;
  }

  private static void checkCancelled(int i, Progress progress) {
    if (i % VERTICES_A_TASK == 0) {
      progress.checkCancelled();
    }
  }

  /** The number of vertices. */
  public int vertices() {
    return upStart.length - 1;
  }

  /** The number of pairs, the n edges of the polygon included. */
  public int pairs() {
    return upEnd.length;
  }

  /** The first pair whose lower position is i; those up to {@code firstUp(i + 1)} follow. */
  public int firstUp(int i) {
    return upStart[i];
  }

  /** The higher position of a pair. */
  public int high(int pair) {
    return upEnd[pair];
  }

  /**
   * The first slot of position j; the slots of its pairs (i, j) go up to {@code firstDown(j + 1)}.
   */
  public int firstDown(int j) {
    return downStart[j];
  }

  /** The lower position of the pair in this slot, ascending within those of one j. */
  public int low(int slot) {
    return downEnd[slot];
  }

  /** The first pair (i, j) with j at or after {@code from}. */
  public int pairFrom(int i, int from) {
    int lo = upStart[i];
    int hi = upStart[i + 1];
    while (lo < hi) {
      int middle = (lo + hi) >>> 1;
      if (upEnd[middle] < from) {
        lo = middle + 1;
      } else {
        hi = middle;
      }
    }
    return lo;
  }

  /** The first slot (k, j) with k above i. */
  public int slotAfter(int j, int i) {
    int lo = downStart[j];
    int hi = downStart[j + 1];
    while (lo < hi) {
      int middle = (lo + hi) >>> 1;
      if (downEnd[middle] <= i) {
        lo = middle + 1;
      } else {
        hi = middle;
      }
    }
    return lo;
  }

  /** The lowest k above {@code after} that both i and j see, i &lt; k &lt; j, or j if none. */
  public int commonAfter(int after, int i, int j) {
    for (int slot = slotAfter(j, after); slot < downStart[j + 1]; slot++) {
      int apex = downEnd[slot];
      int left = slotAfter(apex, i) - 1;
      if (left >= downStart[apex] && downEnd[left] == i) {
        return apex;
      }
    }
    return j;
  }

  /** What one vertex sees; used again for the next one. */
  private static final class Cone {
    private final SimplePolygon polygon;
    private final Points points;
    private final Dcel dcel;
    private final int most;
    private int[] waiting =
        new int[128]; // of four: half-edge to look through, right, left limit, edges crossed before
    private int waitingCount;
    private int[] found = new int[64];
    private int foundCount;

    Cone(SimplePolygon polygon, Triangulation triangulation, int most) {
      this.polygon = polygon;
      this.most = most;
      points = polygon.points();
      dcel = triangulation.dcel();
    }

    /** The positions above i that the vertex there sees, ascending. */
    int[] seenAfter(int i) {
      foundCount = 0;
      int v = polygon.vertex(i);
      int e = boundaryEdge(v);
      see(i, dcel.target(e));
      while (dcel.face(e) != Dcel.OUTER) {
        int through = dcel.next(e);
        await(through, dcel.origin(through), dcel.target(through), 0);
        lookThroughAll(i, v);
        e = dcel.rotate(e);
        see(i, dcel.target(e));
      }
      return Arrays.copyOf(found, foundCount);
    }

    private int boundaryEdge(int v) {
      int e = dcel.outEdge(v);
      while (dcel.face(e ^ 1) != Dcel.OUTER) {
        e = dcel.rotate(e);
      }
      return e;
    }

    private void see(int i, int v) {
      int j = polygon.vertex(v); // its own inverse
      if (j > i) {
        if (foundCount == found.length) {
          found = Arrays.copyOf(found, 2 * foundCount);
        }
        found[foundCount++] = j;
      }
    }

    private void await(int through, int right, int left, int crossed) {
      if (waitingCount + 4 > waiting.length) {
        waiting = Arrays.copyOf(waiting, 2 * waiting.length);
      }
      waiting[waitingCount++] = through;
      waiting[waitingCount++] = right;
      waiting[waitingCount++] = left;
      waiting[waitingCount++] = crossed;
    }

    private void lookThroughAll(int i, int v) {
      while (waitingCount > 0) {
        int crossed = waiting[--waitingCount];
        int left = waiting[--waitingCount];
        int right = waiting[--waitingCount];
        int through = waiting[--waitingCount];
        if (through == Dcel.NONE) {
          see(i, right);
        } else if (crossed < most && dcel.face(through ^ 1) != Dcel.OUTER) {
          lookThrough(v, through ^ 1, right, left, crossed + 1);
        }
      }
    }

    /** The side of the triangle of e that is turned to v is e; its far corner narrows the cone. */
    private void lookThrough(int v, int e, int right, int left, int crossed) {
      int far = dcel.target(dcel.next(e));
      if (points.orient(v, right, far) <= 0) {
        await(dcel.prev(e), right, left, crossed);
      } else if (points.orient(v, far, left) <= 0) {
        await(dcel.next(e), right, left, crossed);
      } else {
        await(dcel.prev(e), far, left, crossed);
        await(Dcel.NONE, far, far, crossed);
        await(dcel.next(e), right, far, crossed);
      }
    }
  }
}
