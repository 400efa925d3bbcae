package dct.core.degree.colour;

import dct.core.Progress;
import dct.core.geometry.Points;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * All empty triangles of some sites, those with no other site in them or on them, and the edges
 * between them. About 2n² triangles of random sites, up to n³/6; found in time proportional to
 * their number, with O(n log n) for each site.
 */
public final class AllTriangles {
  private int[] corner = new int[256]; // by side: where it starts; three sides a triangle
  private int count; // triangles
  private int[] edge; // by side: the edge it lies on
  private int[] ends; // by edge e: its ends at 2e and 2e + 1, that with the lower number first
  private int[][] sidesOf; // by edge: the sides of triangles that lie on it
  private int[][] sidesAt; // by site: the sides that start there
  private int[][] endsAt; // by site: twice an edge, plus 1 at its end with the higher number

  /** The triangles, or empty if there are more than {@code most}. */
  public static Optional<AllTriangles> of(Points points, int most, Progress progress) {
    AllTriangles all = new AllTriangles();
    int[] order = sweepOrder(points);
    for (int i = 0; i + 2 < order.length; i++) {
      progress.checkCancelled();
      int[] later = Arrays.copyOfRange(order, i + 1, order.length);
      Optional<EmptyFan> fan = EmptyFan.of(points, order[i], later, most - all.count);
      if (fan.isEmpty()) {
        return Optional.empty();
      }
      all.add(order[i], fan.get());
    }
    all.index(points.size());
    return Optional.of(all);
  }

  private static int[] sweepOrder(Points points) {
    Integer[] order = new Integer[points.size()];
    Arrays.setAll(order, v -> v);
    Arrays.sort(
        order, Comparator.<Integer>comparingDouble(points::x).thenComparingDouble(points::y));
    return Arrays.stream(order).mapToInt(v -> v).toArray();
  }

  private void add(int hub, EmptyFan fan) {
    for (int j = 1; j < fan.size(); j++) {
      for (int place = fan.firstPartner(j); place < fan.firstPartner(j + 1); place++) {
        if (3 * count + 3 > corner.length) {
          corner = Arrays.copyOf(corner, 2 * corner.length);
        }
        corner[3 * count] = hub;
        corner[3 * count + 1] = fan.site(fan.partner(place));
        corner[3 * count + 2] = fan.site(j);
        count++;
      }
    }
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
    Arrays.setAll(groups, key -> new int[size[key]]);
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

  /**
   * The edge between two sites, in time proportional to the edges at the first.
   *
   * @throws IllegalStateException if no triangle has such an edge
   */
  public int edgeBetween(int from, int to) {
    for (int end : endsAt[from]) {
      if (site(end ^ 1) == to) {
        return end >> 1;
      }
    }
    throw new IllegalStateException("no triangle on the edge from " + from + " to " + to);
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
