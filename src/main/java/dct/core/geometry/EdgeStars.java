package dct.core.geometry;

import java.util.Arrays;

/**
 * The edges at the sites and at the ends of fixed edges, for a sweep from high to low y: those that
 * come from above and those that go down, each from left to right.
 *
 * <p>Vertices with two edges of a ring and no other have no star; a closed chain has none at all.
 */
public final class EdgeStars {
  private static final int[] NOTHING = new int[0];

  private final Rings rings;
  private final Points points;
  private final int[] rank;
  private final boolean[] star; // by vertex; null if there is none
  private final int[] first; // by vertex: where its fixed edges start in `fixed`; null as above
  private final int[] fixed; // null as above

  /**
   * The stars of these rings.
   *
   * @param rank the place of each vertex in the order from low to high
   */
  public EdgeStars(Rings rings, int[] rank) {
    this.rings = rings;
    this.points = rings.points();
    this.rank = rank;
    int n = points.size();
    boolean none = rings.isChain();
    star = none ? null : new boolean[n];
    first = none ? null : new int[n + 1];
    fixed = none ? null : new int[2 * rings.fixedCount()];
    if (!none) {
      collect(n);
    }
  }

  private void collect(int n) {
    for (int v = 0; v < n; v++) {
      star[v] = !rings.isOnRing(v);
    }
    for (int v : rings.fixed()) {
      star[v] = true;
      first[v + 1]++;
    }
    Arrays.parallelPrefix(first, Integer::sum);
    int[] free = first.clone();
    for (int j = 0; j < rings.fixedCount(); j++) {
      fixed[free[rings.fixedFrom(j)]++] = n + j;
      fixed[free[rings.fixedTo(j)]++] = n + j;
    }
  }

  /** Whether this vertex is a site or an end of a fixed edge. */
  public boolean has(int v) {
    return star != null && star[v];
  }

  /** The edges that reach v from above, from left to right. */
  public int[] above(int v) {
    return sorted(v, true);
  }

  /** The edges that leave v downwards, from left to right. */
  public int[] below(int v) {
    return sorted(v, false);
  }

  private int[] sorted(int v, boolean up) {
    int most = first[v + 1] - first[v] + (rings.isOnRing(v) ? 2 : 0);
    int[] fan = most == 0 ? NOTHING : new int[most];
    int count = 0;
    if (rings.isOnRing(v)) {
      count = insert(fan, count, v, v, up);
      count = insert(fan, count, rings.before(v), v, up);
    }
    for (int k = first[v]; k < first[v + 1]; k++) {
      count = insert(fan, count, fixed[k], v, up);
    }
    return count == most ? fan : Arrays.copyOf(fan, count);
  }

  /** Inserts an edge of v into the fan, if it is on this side of v; returns how many there are. */
  private int insert(int[] fan, int count, int edge, int v, boolean up) {
    int end = otherEnd(edge, v);
    if (rank[end] > rank[v] != up) {
      return count;
    }
    int k = count;
    while (k > 0 && isLeft(end, otherEnd(fan[k - 1], v), v, up)) {
      fan[k] = fan[k - 1];
      k--;
    }
    fan[k] = edge;
    return count + 1;
  }

  private boolean isLeft(int end, int other, int v, boolean up) {
    int turn = points.orient(v, end, other);
    return up ? turn < 0 : turn > 0;
  }

  /** The end of an edge of v that is not v. */
  public int otherEnd(int edge, int v) {
    int from = rings.from(edge);
    return from == v ? rings.to(edge) : from;
  }

  /** Whether these two edges of one vertex lead into the same direction. */
  boolean areAligned(int e, int f) {
    int a = rings.from(e);
    int b = rings.to(e);
    return points.orient(a, b, rings.from(f)) == 0 && points.orient(a, b, rings.to(f)) == 0;
  }
}
