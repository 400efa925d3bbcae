package dct.core.geometry;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * Closed chains of vertices, fixed edges, and vertices on no chain: what the boundary and the
 * inside of a region are drawn with, whether or not it is one; immutable.
 *
 * <p>The first ring is the outer one, the others are holes; each may run either way. A vertex is on
 * one ring at most; those on none are sites. {@link SimplicityCheck} tells whether all this bounds
 * a region, {@link Region} is one.
 *
 * <p>Edge v &lt; n is that of a ring from vertex v to {@link #after}; edge n + j is the j-th fixed
 * one. Where a fixed edge is an edge of a ring, or the same as an earlier one, it is left out.
 */
public final class Rings {
  private final Points points;
  private final int ringCount;
  private final int[] start; // by ring: where its vertices start in `members`; one more at the end
  private final int[] members; // null for a single ring of all vertices in their order
  private final int[] ring; // by vertex: its ring, or NONE; null as above
  private final int[] place; // by vertex: its place in `members`; null as above
  private final int[] fixed; // the ends of the fixed edges, two an edge
  private final Set<Long> fixedKeys; // the keys of the fixed edges

  private Rings(Points points, int[] start, int[] members, int[] fixed) {
    this.points = points;
    this.start = start;
    this.members = members;
    ringCount = start.length - 1;
    int n = points.size();
    ring = members == null ? null : new int[n];
    place = members == null ? null : new int[n];
    if (members != null) {
      Arrays.fill(ring, Points.NONE);
      for (int r = 0; r < ringCount; r++) {
        for (int k = start[r]; k < start[r + 1]; k++) {
          claim(r, k);
        }
      }
    }
    fixedKeys = new HashSet<>();
    this.fixed = without(fixed);
  }

  private void claim(int r, int k) {
    int v = members[k];
    if (ring[v] != Points.NONE) {
      throw new IllegalArgumentException("vertex " + v + " is on two rings, or twice on one");
    }
    ring[v] = r;
    place[v] = k;
  }

  /** The closed chain through all points in their order, without fixed edges. */
  public static Rings ofChain(Points points) {
    return new Rings(points, new int[] {0, points.size()}, null, new int[0]);
  }

  /**
   * Rings through some of the points.
   *
   * @param rings the vertices of each ring in order, the outer one first
   * @param fixed the ends of the fixed edges, two vertices an edge
   * @throws IllegalArgumentException if a vertex is on two rings or there is none of this number
   */
  public static Rings of(Points points, List<int[]> rings, int... fixed) {
    int[] start = new int[rings.size() + 1];
    for (int r = 0; r < rings.size(); r++) {
      start[r + 1] = start[r] + rings.get(r).length;
    }
    int[] members = rings.stream().flatMapToInt(Arrays::stream).toArray();
    for (int v : members) {
      check(v, points);
    }
    for (int v : fixed) {
      check(v, points);
    }
    return new Rings(points, start, members, fixed);
  }

  private static void check(int v, Points points) {
    if (v < 0 || v >= points.size()) {
      throw new IllegalArgumentException("there is no vertex " + v);
    }
  }

  /** Fixed edges that are no edges of rings, each once. */
  private int[] without(int[] given) {
    int[] kept = new int[given.length];
    int count = 0;
    for (int j = 0; j + 1 < given.length; j += 2) {
      int u = given[j];
      int v = given[j + 1];
      if (u != v && !areNeighbours(u, v) && fixedKeys.add(key(u, v))) {
        kept[count++] = u;
        kept[count++] = v;
      }
    }
    return Arrays.copyOf(kept, count);
  }

  /** A number for the pair of two vertices, whatever their order. */
  public static long key(int u, int v) {
    return ((long) Math.min(u, v) << 32) | Math.max(u, v);
  }

  private boolean areNeighbours(int u, int v) {
    return isOnRing(u) && (after(u) == v || before(u) == v);
  }

  /** All vertices, those of rings and the sites. */
  public Points points() {
    return points;
  }

  /** The number of rings: 1 and the holes. */
  public int count() {
    return ringCount;
  }

  /** The number of vertices on this ring. */
  public int size(int r) {
    return start[r + 1] - start[r];
  }

  /** The number of vertices on all rings. */
  public int ringVertices() {
    return start[ringCount];
  }

  /** The k-th vertex of this ring. */
  public int vertex(int r, int k) {
    return members == null ? k : members[start[r] + k];
  }

  /** The vertices of this ring in order. */
  public int[] ring(int r) {
    int[] vertices = new int[size(r)];
    Arrays.setAll(vertices, k -> vertex(r, k));
    return vertices;
  }

  /** Whether it is one ring of all vertices in their order, and nothing else. */
  public boolean isChain() {
    return members == null;
  }

  /** Whether this vertex is on a ring; otherwise it is a site. */
  public boolean isOnRing(int v) {
    return ring == null || ring[v] != Points.NONE;
  }

  /** The ring of this vertex, or {@link Points#NONE}. */
  public int ringOf(int v) {
    return ring == null ? 0 : ring[v];
  }

  /** The vertex after this one on its ring. */
  public int after(int v) {
    if (members == null) {
      return v + 1 == points.size() ? 0 : v + 1;
    }
    int k = place[v] + 1;
    return members[k == start[ring[v] + 1] ? start[ring[v]] : k];
  }

  /** The vertex before this one on its ring. */
  public int before(int v) {
    if (members == null) {
      return v == 0 ? points.size() - 1 : v - 1;
    }
    int k = place[v];
    return members[(k == start[ring[v]] ? start[ring[v] + 1] : k) - 1];
  }

  /** The number of fixed edges. */
  public int fixedCount() {
    return fixed.length / 2;
  }

  /** Whether these vertices are the ends of a fixed edge. */
  public boolean isFixed(int u, int v) {
    return !fixedKeys.isEmpty() && fixedKeys.contains(key(u, v));
  }

  /** Whether these vertices are the ends of an edge of a ring or of a fixed one. */
  public boolean isEdge(int u, int v) {
    return areNeighbours(u, v) || isFixed(u, v);
  }

  /**
   * Whether other rings have the same edges and fixed edges, whichever way they run, and from
   * whichever vertex on. In linear time.
   */
  public boolean hasEdgesOf(Rings other) {
    return points.equals(other.points)
        && fixedKeys.equals(other.fixedKeys)
        && ringVertices() == other.ringVertices()
        && IntStream.range(0, points.size()).allMatch(v -> isLike(other, v));
  }

  private boolean isLike(Rings other, int v) {
    return isOnRing(v)
        ? other.isOnRing(v) && other.areNeighbours(v, after(v)) && other.areNeighbours(v, before(v))
        : !other.isOnRing(v);
  }

  /** One end of the j-th fixed edge. */
  public int fixedFrom(int j) {
    return fixed[2 * j];
  }

  /** The other end of the j-th fixed edge. */
  public int fixedTo(int j) {
    return fixed[2 * j + 1];
  }

  /** The end of this edge that its number names: vertex v of edge v of a ring. */
  public int from(int edge) {
    return edge < points.size() ? edge : fixed[2 * (edge - points.size())];
  }

  /** The other end of this edge. */
  public int to(int edge) {
    return edge < points.size() ? after(edge) : fixed[2 * (edge - points.size()) + 1];
  }

  /** The ends of the fixed edges, two vertices an edge. */
  public int[] fixed() {
    return fixed.clone();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Rings that
        && points.equals(that.points)
        && Arrays.equals(start, that.start)
        && Arrays.equals(members, that.members)
        && Arrays.equals(fixed, that.fixed);
  }

  @Override
  public int hashCode() {
    return 31 * points.hashCode() + Arrays.hashCode(start);
  }

  @Override
  public String toString() {
    return ringCount + " rings, " + fixedCount() + " fixed edges, " + points;
  }
}
