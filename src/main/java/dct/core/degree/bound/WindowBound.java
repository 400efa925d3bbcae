package dct.core.degree.bound;

import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.colour.AllTriangles;
import dct.core.degree.colour.HullRing;
import dct.core.geometry.Points;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * The bound from windows that refute all even: sets of sites in disjoint convex regions, each of
 * which has an odd site in every triangulation.
 *
 * <p>Let K be the sites in an open convex region, here a slab. For every empty triangle t with a
 * corner in K let b(t) = 1 if a triangulation has t and it is black, w(t) = 1 if it is white.
 * Claim: if all sites of K are even, some colouring of the triangles at K fulfils, on every edge
 * with an end in K: inside the hull, the b on its left sum to the w on its right, and the other way
 * round; on the hull, either the b sum to 1 and the w to 0 or the other way round, the same way for
 * two hull edges that meet in a site of K. Proof: link two triangles of the triangulation that
 * share an edge with an end in K. A cycle of links can be drawn inside the region, crossing each
 * edge near its end in K and passing from one corner in K to another along their common side; so it
 * goes round sites of K only, and crosses as many edges as their degrees sum to, less twice the
 * edges between them: an even number. Hence the linked triangles can be two-coloured. At a hull
 * site of even degree the first and the last triangle have the same colour. ∎
 *
 * <p>So if no 0 and 1 fulfil these rows, K has an odd site; disjoint windows add up. Windows are
 * found greedily in four sweeps, by x and by y, forwards and backwards: each time the shortest run
 * of sites that {@link ColourRows} refutes with a few branchings.
 *
 * <p>Only for all wishes even. The number of triangles and of steps is limited; what is found
 * within these is the bound.
 */
final class WindowBound {
  private static final int MOST_SITES = 2000;
  private static final int MOST_TRIANGLES = 60_000;
  private static final long MOST_STEPS = 60_000_000; // of the rows, in one sweep
  private static final int BRANCHINGS = 50;
  private static final int UNNAMED = -1;
  private static final int SHORTEST = 6; // sites of the first window tried

  private final HullRing ring;
  private final AllTriangles triangles;
  private final Handshake handshake;
  private final int enough;
  private final Progress progress;
  private final boolean[] inside; // by site: it is in the window
  private final int[] name; // by triangle: its number in the window, or UNNAMED
  private final boolean[] isOnHull; // by edge
  private long steps;

  private WindowBound(
      HullRing ring, AllTriangles triangles, Handshake handshake, int enough, Progress progress) {
    this.ring = ring;
    this.triangles = triangles;
    this.handshake = handshake;
    this.enough = enough;
    this.progress = progress;
    inside = new boolean[ring.points().size()];
    name = new int[triangles.count()];
    Arrays.fill(name, UNNAMED);
    isOnHull = new boolean[triangles.edges()];
    for (int k = 0; k < ring.size(); k++) {
      isOnHull[hullEdge(k)] = true;
    }
  }

  /** The edge from the hull site at position k to the next one. */
  private int hullEdge(int k) {
    return triangles.edgeBetween(ring.site(k), ring.site(k + 1));
  }

  /**
   * The bound, not rounded up.
   *
   * @param enough a number of odd sites that is known to be possible
   * @return empty if it does not apply or is too much to compute
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static Optional<LowerBound> of(HullRing ring, ParityGoal goal, int enough, Progress progress) {
    Points points = ring.points();
    if (!goal.isAll(Wish.EVEN) || points.size() > MOST_SITES) {
      return Optional.empty();
    }
    return AllTriangles.of(points, MOST_TRIANGLES, progress)
        .map(all -> new WindowBound(ring, all, new Handshake(goal), enough, progress).best())
        .map(best -> new LowerBound(best.windows.size(), "windows that cannot be all even"));
  }

  /**
   * The windows that prove the bound.
   *
   * @param windows the sites of each, in the order of the sweep
   * @param byX whether they lie between lines upright, rather than level
   */
  record Windows(List<int[]> windows, boolean byX) {}

  /**
   * The same, with the windows that were refuted; only for all wishes even.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static Optional<Windows> windows(HullRing ring, int enough, Progress progress) {
    Points points = ring.points();
    ParityGoal goal = ParityGoal.allEven(points.size());
    return points.size() > MOST_SITES
        ? Optional.empty()
        : AllTriangles.of(points, MOST_TRIANGLES, progress)
            .map(all -> new WindowBound(ring, all, new Handshake(goal), enough, progress).best());
  }

  private Windows best() {
    Points points = ring.points();
    Comparator<Integer> byX = Comparator.comparingDouble(points::x);
    Comparator<Integer> byY = Comparator.comparingDouble(points::y);
    List<Comparator<Integer>> orders =
        Arrays.asList(
            byX.thenComparing(byY),
            byY.thenComparing(byX),
            byX.thenComparing(byY).reversed(),
            byY.thenComparing(byX).reversed());
    Windows best = new Windows(List.of(), true);
    for (int k = 0; k < orders.size() && handshake.roundUp(best.windows.size()) < enough; k++) {
      List<int[]> found = sweep(orders.get(k));
      best = found.size() > best.windows.size() ? new Windows(found, k % 2 == 0) : best;
    }
    return best;
  }

  /** The disjoint windows that one sweep refutes. */
  private List<int[]> sweep(Comparator<Integer> direction) {
    Integer[] order = new Integer[inside.length];
    Arrays.setAll(order, v -> v);
    Arrays.sort(order, direction);
    List<int[]> windows = new ArrayList<>();
    steps = 0;
    int from = 0;
    while (from < order.length && handshake.roundUp(windows.size()) < enough) {
      int end = shortest(order, from);
      if (end < 0) {
        return windows;
      }
      windows.add(Arrays.stream(order, from, end).mapToInt(v -> v).toArray());
      from = end;
    }
    return windows;
  }

  /** The end of the shortest window found that begins there, or −1. */
  private int shortest(Integer[] order, int from) {
    int held = from; // the longest known not to be refuted ends there
    int length = SHORTEST;
    int end = Math.min(order.length, from + length);
    while (!isRefuted(order, from, end)) {
      if (end == order.length || steps > MOST_STEPS) {
        return -1;
      }
      held = end;
      length += length / 2;
      end = Math.min(order.length, from + length);
    }
    while (end - held > 1 && steps <= MOST_STEPS) {
      int middle = (held + end) >>> 1;
      if (isRefuted(order, from, middle)) {
        end = middle;
      } else {
        held = middle;
      }
    }
    return end;
  }

  // ---- one window

  private boolean isRefuted(Integer[] order, int from, int end) {
    progress.checkCancelled();
    for (int i = from; i < end; i++) {
      inside[order[i]] = true;
    }
    Window window = new Window();
    for (int i = from; i < end; i++) {
      window.nameTriangles(order[i]);
    }
    window.hullEdges();
    for (int i = from; i < end; i++) {
      window.innerEdges(order[i]);
    }
    boolean refuted = window.isRefuted();
    for (int i = from; i < end; i++) {
      inside[order[i]] = false;
      for (int side : triangles.sidesAt(order[i])) {
        name[side / 3] = UNNAMED;
      }
    }
    return refuted;
  }

  /** The rows of one window; b(t) is unknown 2k and w(t) 2k + 1 for the triangle with number k. */
  private final class Window {
    private final ColourRows rows = new ColourRows();
    private int named; // triangles
    private int unknowns;
    private int[] zeros = new int[64];
    private int zeroCount;

    void nameTriangles(int v) {
      for (int side : triangles.sidesAt(v)) {
        if (name[side / 3] == UNNAMED) {
          name[side / 3] = named++;
        }
      }
      unknowns = 2 * named;
    }

    private boolean isTouched(int k) {
      return inside[ring.site(k)] || inside[ring.site(k + 1)];
    }

    /** Each run of hull edges that meet in K has an unknown of its own, its colour. */
    void hullEdges() {
      int h = ring.size();
      int first = 0;
      while (first < h && !(isTouched(first) && !inside[ring.site(first)])) {
        first++;
      }
      first %= h; // all of the hull is in K, or none
      boolean isFirst = true;
      for (int k = first; k < first + h; k++) {
        if (isTouched(k)) {
          if (isFirst || !inside[ring.site(k)]) {
            unknowns++;
          }
          if (isFirst) {
            zero(unknowns - 1);
          }
          isFirst = false;
          addHullEdge(hullEdge(k), unknowns - 1);
        }
      }
    }

    private void addHullEdge(int edge, int colour) {
      rows.begin(1);
      for (int side : triangles.sidesOn(edge)) {
        rows.plus(2 * name[side / 3]);
      }
      rows.plus(colour);
      rows.begin(0);
      for (int side : triangles.sidesOn(edge)) {
        rows.plus(2 * name[side / 3] + 1);
      }
      rows.minus(colour);
    }

    /** The edges at v, but for those that its other end brings. */
    void innerEdges(int v) {
      for (int end : triangles.endsAt(v)) {
        int other = triangles.site(end ^ 1);
        if (!inside[other] || v < other) {
          innerEdge(end >> 1);
        }
      }
    }

    private void innerEdge(int edge) {
      int forward = 0;
      int[] sides = triangles.sidesOn(edge);
      for (int side : sides) {
        forward += triangles.isForward(side) ? 1 : 0;
      }
      if (forward > 0 && forward < sides.length) {
        rowOn(sides, 0);
        rowOn(sides, 1);
      } else if (!isOnHull[edge]) {
        for (int side : sides) {
          zero(2 * name[side / 3]);
          zero(2 * name[side / 3] + 1);
        }
      }
    }

    /** One colour on the left is the other on the right. */
    private void rowOn(int[] sides, int colour) {
      rows.begin(0);
      for (int side : sides) {
        if (triangles.isForward(side)) {
          rows.plus(2 * name[side / 3] + colour);
        }
      }
      for (int side : sides) {
        if (!triangles.isForward(side)) {
          rows.minus(2 * name[side / 3] + 1 - colour);
        }
      }
    }

    private void zero(int x) {
      if (zeroCount == zeros.length) {
        zeros = Arrays.copyOf(zeros, 2 * zeroCount);
      }
      zeros[zeroCount++] = x;
    }

    boolean isRefuted() {
      boolean refuted = rows.isRefuted(unknowns, Arrays.copyOf(zeros, zeroCount), BRANCHINGS);
      steps += rows.steps();
      return refuted;
    }
  }
}
