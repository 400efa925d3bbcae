package dct.core.degree.colour;

import dct.core.Progress;
import dct.core.geometry.Points;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * All empty triangles at some sites, those with no other site in them or on them, and the edges
 * between them. About 2n² triangles at all of n random sites, up to n³/6; found in time
 * proportional to the triangles at these sites, with O(n log n) for each site.
 */
public final class AllTriangles {
  private static final int[] NONE = {};

  private int[] corner = new int[256]; // by side: where it starts; three sides a triangle
  private int count; // triangles
  private int[] edge; // by side: the edge it lies on
  private int[] ends; // by edge e: its ends at 2e and 2e + 1, that with the lower number first
  private int[][] sidesOf; // by edge: the sides of triangles that lie on it
  private int[][] sidesAt; // by site: the sides that start there
  private int[][] endsAt; // by site: twice an edge, plus 1 at its end with the higher number

  /** The triangles at all sites, or empty if there are more than {@code most}. */
  public static Optional<AllTriangles> of(Points points, int most, Progress progress) {
    BitSet all = new BitSet();
    all.set(0, points.size());
    return of(points, all, most, progress);
  }

  /** The triangles at some sites, or empty if there are more than {@code most}. */
  static Optional<AllTriangles> of(Points points, BitSet at, int most, Progress progress) {
    AllTriangles all = new AllTriangles();
    int[] order = sweepOrder(points);
    BitSet done = new BitSet();
    for (int i = 0; i < order.length; i++) {
      progress.checkCancelled();
      if (at.get(order[i])) {
        if (!all.addAt(points, order, i, done, most)) {
          return Optional.empty();
        }
        done.set(order[i]);
      }
    }
    all.index(points.size());
    return Optional.of(all);
  }

  /**
   * Triangles that were found in another way.
   *
   * @param corners three vertices a triangle, counter-clockwise
   * @param n the number of vertices
   */
  static AllTriangles of(int[] corners, int n) {
    AllTriangles all = new AllTriangles();
    all.corner = corners;
    all.count = corners.length / 3;
    all.index(n);
    return all;
  }

  private static int[] sweepOrder(Points points) {
    Integer[] order = new Integer[points.size()];
    Arrays.setAll(order, v -> v);
    Arrays.sort(
        order, Comparator.<Integer>comparingDouble(points::x).thenComparingDouble(points::y));
    return Arrays.stream(order).mapToInt(v -> v).toArray();
  }

  /** Adds the triangles at a site that have no corner done before; false if that makes too many. */
  private boolean addAt(Points points, int[] order, int i, BitSet done, int most) {
    int hub = order[i];
    int[] right = EmptyFan.seen(points, hub, Arrays.stream(order, i + 1, order.length));
    if (done.cardinality() == i) { // nothing else is left of it
      return add(hub, EmptyFan.of(points, hub, right, false, most), 0, done, most);
    }
    int[] left = EmptyFan.seen(points, hub, Arrays.stream(order, 0, i));
    return add(hub, EmptyFan.of(points, hub, joined(right, left), true, most), 0, done, most)
        && add(
            hub,
            EmptyFan.of(points, hub, joined(left, right), true, most),
            left.length, // the others contain the direction straight down
            done,
            most);
  }

  private static int[] joined(int[] first, int[] second) {
    return IntStream.concat(Arrays.stream(first), Arrays.stream(second)).toArray();
  }

  /** Adds the triangles of a fan whose corners are numbered less than {@code cut}, and not. */
  private boolean add(int hub, Optional<EmptyFan> some, int cut, BitSet done, int most) {
    if (some.isEmpty()) {
      return false;
    }
    EmptyFan fan = some.get();
    for (int j = Math.max(1, cut); j < fan.size(); j++) {
      for (int place = fan.firstPartner(j); place < fan.firstPartner(j + 1); place++) {
        int i = fan.partner(place);
        boolean isCut = cut == 0 || i < cut;
        if (isCut && !done.get(fan.site(i)) && !done.get(fan.site(j))) {
          add(hub, fan.site(i), fan.site(j));
        }
      }
    }
    return count <= most;
  }

  private void add(int a, int b, int c) {
    if (3 * count + 3 > corner.length) {
      corner = Arrays.copyOf(corner, 2 * corner.length);
    }
    corner[3 * count] = a;
    corner[3 * count + 1] = b;
    corner[3 * count + 2] = c;
    count++;
  }

  private void index(int n) {
    corner = Arrays.copyOf(corner, 3 * count);
    Map<Long, Integer> number = new HashMap<>();
    edge = new int[corner.length];
    int[] end = new int[2 * corner.length];
    for (int side = 0; side < edge.length; side++) {
      int a = Math.min(corner[side], corner[after(side)]);
      int b = Math.max(corner[side], corner[after(side)]);
      int e = number.computeIfAbsent((long) a * n + b, key -> number.size());
      edge[side] = e;
      end[2 * e] = a;
      end[2 * e + 1] = b;
    }
    sidesOf = group(edge, number.size());
    sidesAt = group(corner, n);
    endsAt = group(Arrays.copyOf(end, 2 * number.size()), n);
    ends = end;
  }

  /** By key: the indices at which it stands. */
  private static int[][] group(int[] keys, int bound) {
    int[] size = new int[bound];
    for (int key : keys) {
      size[key]++;
    }
    int[][] groups = new int[bound][];
    Arrays.setAll(groups, key -> size[key] == 0 ? NONE : new int[size[key]]);
    for (int i = keys.length - 1; i >= 0; i--) {
      groups[keys[i]][--size[keys[i]]] = i;
    }
    return groups;
  }

  static int after(int side) {
    return side % 3 == 2 ? side - 2 : side + 1;
  }

  /** The number of triangles. */
  public int count() {
    return count;
  }

  /** The number of edges. */
  public int edges() {
    return sidesOf.length;
  }

  /** The site where a side starts. */
  int corner(int side) {
    return corner[side];
  }

  /** The edge that a side lies on. */
  int edge(int side) {
    return edge[side];
  }

  /** The sides of triangles that start at a site; side s belongs to triangle s / 3. */
  public int[] sidesAt(int site) {
    return sidesAt[site];
  }

  /** The ends of edges at a site: 2e or 2e + 1 for edge e. */
  public int[] endsAt(int site) {
    return endsAt[site];
  }

  /** The edge between two sites, or −1; in time proportional to the edges at the first. */
  int findEdge(int from, int to) {
    for (int end : endsAt[from]) {
      if (site(end ^ 1) == to) {
        return end >> 1;
      }
    }
    return -1;
  }

  /** The site at this end of an edge. */
  public int site(int end) {
    return ends[end];
  }

  /** The sides of triangles that lie on an edge. */
  public int[] sidesOn(int edge) {
    return sidesOf[edge];
  }

  /** Whether this side runs from the end 2e of its edge e to the end 2e + 1. */
  public boolean isForward(int side) {
    return corner[side] < corner[after(side)];
  }
}
