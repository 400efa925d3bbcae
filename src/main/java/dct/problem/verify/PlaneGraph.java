package dct.problem.verify;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.dcel.HalfEdges;
import dct.core.geometry.Points;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The faces of a graph drawn with straight edges, found from its list of edges alone.
 *
 * <p>Half-edge 2i leads from the first end of edge i to the second, half-edge 2i + 1 back. The
 * half-edges that leave a vertex are sorted counter-clockwise by exact predicates; the face on the
 * left of a half-edge goes on, at its end, with the last one before the way back. Nothing here
 * comes from the program's own edge lists. O(m log m).
 */
final class PlaneGraph {
  private static final int SMALL = 24;

  private final Points points;
  private final int[] origin; // by half-edge
  private final int[] first; // where the half-edges of each vertex start in `around`
  private final int[] around; // half-edges by their origin, counter-clockwise
  private final int[] next; // half-edge after this one around the face on its left

  /** A graph whose edges (from[i], to[i]) join different vertices that there are. */
  PlaneGraph(Points points, int[] from, int[] to) {
    this.points = points;
    this.origin = new int[2 * from.length];
    for (int i = 0; i < from.length; i++) {
      origin[2 * i] = from[i];
      origin[2 * i + 1] = to[i];
    }
    this.first = new int[points.size() + 1];
    this.around = new int[origin.length];
    this.next = new int[origin.length];
    collect();
    for (int v = 0; v < points.size(); v++) {
      sort(first[v], first[v + 1]);
    }
    link();
  }

  private void collect() {
    for (int v : origin) {
      first[v + 1]++;
    }
    Arrays.parallelPrefix(first, Integer::sum);
    int[] free = first.clone();
    for (int e = 0; e < origin.length; e++) {
      around[free[origin[e]]++] = e;
    }
  }

  private void sort(int from, int to) {
    if (to - from <= SMALL) {
      insertionSort(from, to);
      return;
    }
    List<Integer> sorted =
        IntStream.range(from, to)
            .mapToObj(k -> around[k])
            .sorted(Comparator.comparing(e -> e, this::compareAngles))
            .toList();
    for (int k = from; k < to; k++) {
      around[k] = sorted.get(k - from);
    }
  }

  private void insertionSort(int from, int to) {
    for (int i = from + 1; i < to; i++) {
      int e = around[i];
      int k = i;
      for (; k > from && compareAngles(around[k - 1], e) > 0; k--) {
        around[k] = around[k - 1];
      }
      around[k] = e;
    }
  }

  /** Orders half-edges of one origin by angle, from the direction of x on. */
  private int compareAngles(int e, int f) {
    boolean upper = isUpper(e);
    if (upper != isUpper(f)) {
      return upper ? -1 : 1;
    }
    return -points.orient(origin[e], target(e), target(f));
  }

  /** Whether the target of e is above its origin, or on the same height to the right of it. */
  boolean isUpper(int e) {
    return points.yxLess(origin[e], target(e));
  }

  private void link() {
    for (int v = 0; v < points.size(); v++) {
      for (int k = first[v]; k < first[v + 1]; k++) {
        int before = k == first[v] ? first[v + 1] - 1 : k - 1;
        next[around[k] ^ 1] = around[before];
      }
    }
  }

  /** A half-edge that lies on its predecessor around the same vertex, or −1. */
  int overlapping() {
    for (int v = 0; v < points.size(); v++) {
      for (int k = first[v] + 1; k < first[v + 1]; k++) {
        if (compareAngles(around[k - 1], around[k]) == 0) {
          return around[k];
        }
      }
    }
    return -1;
  }

  /** The number of half-edges that leave vertex v: its degree. */
  int degree(int v) {
    return first[v + 1] - first[v];
  }

  /**
   * A half-edge with the outer face on its left, of the part that holds the lowest vertex: all
   * edges there lead up, and beyond the last of them nothing is left.
   */
  int outer() {
    int lowest = 0;
    for (int v = 1; v < points.size(); v++) {
      lowest = points.yxLess(v, lowest) ? v : lowest;
    }
    return around[first[lowest + 1] - 1];
  }

  /** The topology of a plane triangulation, half-edges numbered as here. */
  Dcel toDcel() {
    return Dcel.of(points.size(), HalfEdges.of(next, origin), outer(), Progress.NONE);
  }

  /**
   * The same where several cycles count as the outer face.
   *
   * @param cycles a half-edge of each, the one round everything first
   */
  Dcel toDcel(int... cycles) {
    return Dcel.of(points.size(), HalfEdges.of(next, origin), cycles, Progress.NONE);
  }

  /** A half-edge from one vertex to another, or −1; in as many steps as the first has edges. */
  int halfEdge(int u, int v) {
    for (int k = first[u]; k < first[u + 1]; k++) {
      if (target(around[k]) == v) {
        return around[k];
      }
    }
    return -1;
  }

  int halfEdges() {
    return origin.length;
  }

  int next(int e) {
    return next[e];
  }

  int origin(int e) {
    return origin[e];
  }

  int target(int e) {
    return origin[e ^ 1];
  }

  /** The k-th half-edge that leaves vertex v, counter-clockwise from the direction of x on. */
  int around(int v, int k) {
    return around[first[v] + k];
  }

  /** The third corner of the triangle left of e. */
  int apex(int e) {
    return target(next[e]);
  }

  /** What messages call the edge of e. */
  String name(int e) {
    return "v" + origin[e] + "–v" + target(e);
  }

  /** Whether the face on the left of e is a triangle with its corners counter-clockwise. */
  boolean isTriangle(int e) {
    int f = next[e];
    int g = next[f];
    return next[g] == e && points.orient(origin[e], origin[f], origin[g]) > 0;
  }
}
