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
    int[] walk = polygon.walk();
    return of(polygon.points(), triangulation.dcel(), walk, most, mostPairs, progress);
  }

  /**
   * The visibility graph of what a closed walk bounds that does not cross itself, or null if it has
   * more pairs than allowed. Vertices may be at one place, so that the walk goes to and fro along a
   * slit.
   *
   * @param dcel a triangulation of it
   * @param walk all vertices, counter-clockwise
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static VisibilityGraph of(
      Points points, Dcel dcel, int[] walk, long mostPairs, Progress progress) {
    return of(points, dcel, walk, Integer.MAX_VALUE, mostPairs, progress);
  }

  private static VisibilityGraph of(
      Points points, Dcel dcel, int[] walk, int most, long mostPairs, Progress progress) {
    int n = walk.length;
    int[] position = new int[n];
    for (int k = 0; k < n; k++) {
      position[walk[k]] = k;
    }
    int[][] seen = new int[n][];
    AtomicLong pairs = new AtomicLong();
    AtomicInteger done = new AtomicInteger();
    IntStream.rangeClosed(0, (n - 1) / VERTICES_A_TASK)
        .parallel()
        .forEach(
            task -> {
              progress.report((double) done.get() / n, "Finding what each vertex sees");
              Sight sight = new Sight(points, dcel, most);
              int first = task * VERTICES_A_TASK;
              int end = Math.min(n, first + VERTICES_A_TASK);
              for (int i = first; i < end && pairs.get() <= mostPairs; i++) {
                progress.checkCancelled();
                seen[i] = after(i, sight.from(walk[i]), position);
                pairs.addAndGet(seen[i].length);
              }
              done.addAndGet(end - first);
            });
    return pairs.get() <= mostPairs ? new VisibilityGraph(seen, pairs.intValue(), progress) : null;
  }

  /** The positions above i of these vertices. */
  private static int[] after(int i, int[] seen, int[] position) {
    int count = 0;
    for (int v : seen) {
      if (position[v] > i) {
        seen[count++] = position[v];
      }
    }
    return Arrays.copyOf(seen, count);
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
}
