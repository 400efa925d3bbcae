package dct.core.triangulate;

import dct.core.dcel.HalfEdges;
import dct.core.geometry.EdgeStars;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;

/**
 * The half-edges of a region's rings and fixed edges, and where they lie for a sweep from high to
 * low y.
 *
 * <p>With m positions on rings, edge k &lt; m leads from position k to the next one, half-edge 2k
 * with the region on its left; edge m + j is the j-th fixed one.
 */
final class RegionLinks {
  private final Region region;
  private final Rings rings;
  private final int m;
  private final int[] rank; // by vertex: its place in the order from low to high
  private final EdgeStars stars;
  private final HalfEdges links;

  /**
   * The links, with room for a triangulation.
   *
   * @param rank by vertex: its place in the order from low to high
   */
  RegionLinks(Region region, int[] rank) {
    this.region = region;
    this.rank = rank;
    rings = region.rings();
    m = region.positions();
    stars = new EdgeStars(rings, rank);
    int edges = m + rings.fixedCount();
    links = new HalfEdges(edges, Math.max(edges, 3 * region.size() + 3 * region.holes() - 3));
    for (int k = 0; k < m; k++) {
      links.origin()[2 * k] = region.vertex(k);
      links.origin()[2 * k + 1] = region.vertex(region.after(k));
      if (!stars.has(region.vertex(k))) {
        int before = region.before(k);
        links.link(2 * before, 2 * k);
        links.link(2 * k + 1, 2 * before + 1);
      }
    }
    for (int j = 0; j < rings.fixedCount(); j++) {
      links.origin()[2 * (m + j)] = rings.fixedFrom(j);
      links.origin()[2 * (m + j) + 1] = rings.fixedTo(j);
    }
    for (int v = 0; v < region.size(); v++) {
      if (stars.has(v)) {
        linkStar(v);
      }
    }
  }

  /** Counter-clockwise, the edges below come from left to right, and then those above. */
  private void linkStar(int v) {
    int[] below = below(v);
    int[] above = above(v);
    int count = below.length + above.length;
    int[] leaving = new int[count];
    for (int i = 0; i < count; i++) {
      leaving[i] = leaving(i < below.length ? below[i] : above[count - 1 - i], v);
    }
    for (int i = 0; i < count; i++) {
      links.link(leaving[i] ^ 1, leaving[i == 0 ? count - 1 : i - 1]);
    }
  }

  /** The half-edges, which the caller may change. */
  HalfEdges links() {
    return links;
  }

  /** Whether this vertex is a site or an end of a fixed edge. */
  boolean hasStar(int v) {
    return stars.has(v);
  }

  /** The edges that reach a site or an end of a fixed edge from above, from left to right. */
  int[] above(int v) {
    return numbers(stars.above(v));
  }

  /** The edges that leave such a vertex downwards, from left to right. */
  int[] below(int v) {
    return numbers(stars.below(v));
  }

  private int[] numbers(int[] edges) {
    for (int i = 0; i < edges.length; i++) {
      edges[i] = number(edges[i]);
    }
    return edges;
  }

  /** The number here of an edge of the rings, which may run the other way. */
  private int number(int edge) {
    if (edge >= region.size()) {
      return m + edge - region.size();
    }
    int k = region.position(edge);
    int after = rings.after(edge);
    return region.vertex(region.after(k)) == after ? k : region.position(after);
  }

  /** One end of this edge: that which half-edge {@code 2 * edge} leaves. */
  int from(int edge) {
    return edge < m ? region.vertex(edge) : rings.fixedFrom(edge - m);
  }

  /** The other end of this edge. */
  int to(int edge) {
    return edge < m ? region.vertex(region.after(edge)) : rings.fixedTo(edge - m);
  }

  /** The half-edge of this edge that leaves v. */
  int leaving(int edge, int v) {
    return 2 * edge + (from(edge) == v ? 0 : 1);
  }

  /** The end of an edge of v that is not v. */
  int otherEnd(int edge, int v) {
    int from = from(edge);
    return from == v ? to(edge) : from;
  }

  /** Whether the region is on the right of this edge. */
  boolean isInsideRight(int edge) {
    return edge >= m || rank[from(edge)] > rank[to(edge)];
  }

  /** Whether the region is on the left of this edge. */
  boolean isInsideLeft(int edge) {
    return edge >= m || rank[from(edge)] < rank[to(edge)];
  }

  /** A half-edge of each ring with the outside on its left, the outer ring first. */
  int[] outside() {
    int[] first = new int[rings.count()];
    int k = 0;
    for (int r = 0; r < first.length; r++) {
      first[r] = 2 * k + 1;
      k += rings.size(r);
    }
    return first;
  }
}
