package dct.core.geometry;

import dct.core.Progress;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Where the vertices of rings and fixed edges coincide, and where one lies on an edge that is not
 * its own: what touches, of rings that need not bound a region.
 *
 * <p>Places are known by the lowest number of the vertices there. O(n) expected time and space for
 * edges that are short beside the whole; each edge is compared with those nearby in a grid.
 */
final class Meetings {
  private final Rings rings;
  private final Points points;
  private final Progress progress;
  private final int[] place; // by vertex: the lowest number of those at its place
  private final List<int[]> groups = new ArrayList<>();
  private final Map<Integer, List<Integer>> inside = new TreeMap<>(); // by edge, along it
  private final Map<Long, Integer> fixed = new HashMap<>(); // the numbers of the fixed edges
  private final EdgeGrid grid;

  private Meetings(Rings rings, Progress progress) {
    this.rings = rings;
    this.progress = progress;
    points = rings.points();
    place = new int[points.size()];
    grid = new EdgeGrid(points, EdgeGrid.cellsFor(rings));
  }

  /**
   * Finds all of them.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static Meetings of(Rings rings, Progress progress) {
    Meetings meetings = new Meetings(rings, progress);
    meetings.findGroups();
    meetings.fillGrid();
    meetings.findInside();
    return meetings;
  }

  private void findGroups() {
    int[] order = PlaneOrder.byYThenX(points, progress);
    for (int from = 0; from < order.length; ) {
      int to = from + 1;
      while (to < order.length && points.same(order[from], order[to])) {
        to++;
      }
      for (int k = from; k < to; k++) {
        place[order[k]] = order[from]; // equal points keep the order of their numbers
      }
      if (to - from > 1) {
        groups.add(Arrays.copyOfRange(order, from, to));
      }
      from = to;
    }
  }

  private void fillGrid() {
    for (int v = 0; v < place.length; v++) {
      Progress.check(progress, v);
      if (rings.isOnRing(v)) {
        grid.add(v, rings.after(v));
      }
    }
    for (int j = 0; j < rings.fixedCount(); j++) {
      grid.add(rings.fixedFrom(j), rings.fixedTo(j));
      fixed.put(Rings.key(rings.fixedFrom(j), rings.fixedTo(j)), place.length + j);
    }
  }

  private void findInside() {
    for (int v = 0; v < place.length; v++) {
      Progress.check(progress, v);
      int at = v;
      if (place[v] == v) {
        grid.anyNear(v, v, Meetings::isThere, (a, b) -> noteInside(at, a, b));
      }
    }
    inside.forEach((edge, all) -> all.sort(along(edge)));
  }

  private static boolean isThere(int a, int b) {
    return a != b;
  }

  private boolean noteInside(int v, int a, int b) {
    if (isInside(v, a, b)) {
      inside.computeIfAbsent(edge(a, b), none -> new ArrayList<>()).add(v);
    }
    return false;
  }

  /** Whether v lies on the segment from a to b, and at none of its ends. */
  private boolean isInside(int v, int a, int b) {
    return isBetween(points.x(v), points.x(a), points.x(b))
        && isBetween(points.y(v), points.y(a), points.y(b))
        && !points.same(v, a)
        && !points.same(v, b)
        && points.orient(a, b, v) == 0;
  }

  private static boolean isBetween(double c, double a, double b) {
    return Math.min(a, b) <= c && c <= Math.max(a, b);
  }

  private int edge(int a, int b) {
    boolean isOfRing = rings.isOnRing(a) && rings.after(a) == b;
    return isOfRing ? a : fixed.get(Rings.key(a, b));
  }

  private Comparator<Integer> along(int edge) {
    boolean up = points.yxLess(rings.from(edge), rings.to(edge));
    Comparator<Integer> upwards = (u, v) -> points.yxLess(u, v) ? -1 : 1;
    return up ? upwards : upwards.reversed();
  }

  /** Whether nothing touches. */
  boolean isEmpty() {
    return groups.isEmpty() && inside.isEmpty();
  }

  /** The lowest number of the vertices at the place of this one. */
  int place(int v) {
    return place[v];
  }

  /** The vertices of each place with several, the lowest number first. */
  List<int[]> groups() {
    return groups;
  }

  /** The edges that vertices lie on, and these places in the order along the edge. */
  Map<Integer, List<Integer>> inside() {
    return inside;
  }

  /** The start of this edge, the places on it, and its end. */
  int[] along(int edge, int from, int to) {
    List<Integer> between = inside.getOrDefault(edge, List.of());
    int[] all = new int[between.size() + 2];
    all[0] = from;
    for (int k = 0; k < between.size(); k++) {
      all[k + 1] = between.get(k);
    }
    all[all.length - 1] = to;
    return all;
  }

  /** Whether two edges cross in their interiors. */
  boolean areCrossing() {
    int n = points.size();
    for (int e = 0; e < n + rings.fixedCount(); e++) {
      Progress.check(progress, e);
      if (e >= n || rings.isOnRing(e)) {
        int a = rings.from(e);
        int b = rings.to(e);
        if (grid.anyNear(a, b, Meetings::isThere, (c, d) -> areCrossing(a, b, c, d))) {
          return true;
        }
      }
    }
    return false;
  }

  private boolean areCrossing(int a, int b, int c, int d) {
    return points.orient(a, b, c) * points.orient(a, b, d) < 0
        && points.orient(c, d, a) * points.orient(c, d, b) < 0;
  }
}
