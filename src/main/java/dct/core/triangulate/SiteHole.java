package dct.core.triangulate;

import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import java.util.Arrays;

/**
 * The Delaunay triangulation of all sites but one, laid over that of all sites, which stays as it
 * is: only the half-edges round the hole that the site leaves, and those that fill it, are linked
 * here.
 *
 * <p>Made in O(k²) time and O(k) space for a site with k edges, however many sites there are. A
 * half-edge is linked here if one of its neighbours is an edge of the site that is gone.
 */
final class SiteHole {
  private final Dcel below;
  private final Points points;
  private final int site;
  private final int bound; // half-edges from here on are new
  private final int[] rim; // half-edges of below that have other neighbours here; ascending
  private final int[] next; // by slot: first those of the rim, then the new ones
  private final int[] prev;
  private final boolean[] outer;
  private final int[] origin; // of the new ones
  private int made; // new half-edges
  private int filled; // triangles in the hole

  /** Takes the site out of a triangulation in which it is not the only corner of any triangle. */
  SiteHole(Triangulation all, int site) {
    below = all.dcel();
    points = all.points();
    this.site = site;
    bound = 2 * below.edgeBound();
    int k = below.degree(site);
    int gap = outerEdge();
    int[] border = border(gap);
    rim = gap == Dcel.NONE ? border.clone() : withOuterNeighbours(border, gap);
    Arrays.sort(rim);
    int slots = rim.length + 2 * k;
    next = new int[slots];
    prev = new int[slots];
    outer = new boolean[slots];
    origin = new int[2 * k];
    for (int slot = 0; slot < rim.length; slot++) {
      next[slot] = below.next(rim[slot]);
      prev[slot] = below.prev(rim[slot]);
      outer[slot] = below.face(rim[slot]) == Dcel.OUTER;
    }
    if (gap == Dcel.NONE) {
      fill(border);
    } else {
      fillToHull(border, below.prev(below.prev(gap)), below.next(gap));
    }
  }

  // ---- reading

  /** The sites, that which is gone included. */
  Points points() {
    return points;
  }

  /** Half-edges below this are those of the triangulation with the site. */
  int bound() {
    return bound;
  }

  /** Whether the others have no triangle: they lie on one line. */
  boolean isFlat() {
    int gone = outerEdge() == Dcel.NONE ? below.degree(site) : below.degree(site) - 1;
    return below.faceCount() - 1 - gone + filled == 0;
  }

  /** The half-edges round the hole and on the hull beside it, as numbered below. */
  int[] rim() {
    return rim.clone();
  }

  /** Half-edges are numbered below this; those of the site that is gone have their old numbers. */
  int halfEdgeBound() {
    return bound + made;
  }

  int next(int e) {
    int slot = slot(e);
    return slot < 0 ? below.next(e) : next[slot];
  }

  int prev(int e) {
    int slot = slot(e);
    return slot < 0 ? below.prev(e) : prev[slot];
  }

  int origin(int e) {
    return e < bound ? below.origin(e) : origin[e - bound];
  }

  int target(int e) {
    return origin(e ^ 1);
  }

  /** Whether the outer face is on the left of e. */
  boolean isOuter(int e) {
    int slot = slot(e);
    return slot < 0 ? below.face(e) == Dcel.OUTER : outer[slot];
  }

  private int slot(int e) {
    if (e >= bound) {
      return rim.length + e - bound;
    }
    boolean besideHole = below.origin(below.prev(e)) == site || below.target(below.next(e)) == site;
    return besideHole ? Arrays.binarySearch(rim, e) : Dcel.NONE;
  }

  // ---- the border of the hole

  /** The half-edge that leaves the site along the hull, the outer face on its left, or none. */
  private int outerEdge() {
    int start = below.outEdge(site);
    int e = start;
    do {
      if (below.face(e) == Dcel.OUTER) {
        return e;
      }
      e = below.rotate(e);
    } while (e != start);
    return Dcel.NONE;
  }

  /** The half-edges opposite the site, counter-clockwise; of a site on the hull, along its gap. */
  private int[] border(int gap) {
    int[] border = new int[below.degree(site) - (gap == Dcel.NONE ? 0 : 1)];
    int e = gap == Dcel.NONE ? below.outEdge(site) : below.rotate(gap);
    for (int k = 0; k < border.length; k++) {
      border[k] = below.next(e);
      e = below.rotate(e);
    }
    return border;
  }

  private int[] withOuterNeighbours(int[] border, int gap) {
    int before = below.prev(below.prev(gap));
    int after = below.next(gap);
    int[] both = Arrays.copyOf(border, border.length + (before == after ? 1 : 2));
    both[border.length] = before;
    both[both.length - 1] = after;
    return both;
  }

  // ---- filling

  /** Fills a closed polygon, given by its half-edges counter-clockwise. */
  private void fill(int[] polygon) {
    int apex = apex(polygon, polygon.length - 1);
    triangle(polygon[0], side(polygon, 1, apex), side(polygon, apex, polygon.length));
  }

  /** The half-edge from the start of a run of sides to its end, what it cuts off being filled. */
  private int side(int[] polygon, int from, int to) {
    if (to - from == 1) {
      return polygon[from];
    }
    int chord = newEdge(origin(polygon[from]), target(polygon[to - 1]));
    int[] rest = new int[to - from + 1];
    rest[0] = chord ^ 1;
    System.arraycopy(polygon, from, rest, 1, to - from);
    fill(rest);
    return chord;
  }

  /** Fills what is inside the hull on the left of a path, between two half-edges of the hull. */
  private void fillToHull(int[] border, int before, int after) {
    int[] path = border;
    int last = before;
    while (path.length > 0) {
      int apex = apex(path, path.length);
      if (apex < 0) {
        outer[slot(path[0])] = true;
        link(last, path[0]);
        last = path[0];
        path = Arrays.copyOfRange(path, 1, path.length);
      } else {
        int chord = newEdge(vertex(path, apex), origin(path[0]));
        triangle(path[0], side(path, 1, apex), chord);
        path = Arrays.copyOfRange(path, apex - 1, path.length);
        path[0] = chord ^ 1;
      }
    }
    link(last, after);
  }

  /**
   * Which of the corners 2 … last of a path is that of the Delaunay triangle on its first
   * half-edge: the one on the left in whose circle there is no other; none if none is on the left.
   */
  private int apex(int[] path, int last) {
    int a = origin(path[0]);
    int b = target(path[0]);
    int best = Dcel.NONE;
    for (int k = 2; k <= last; k++) {
      int c = vertex(path, k);
      boolean better =
          points.orient(a, b, c) > 0
              && (best < 0 || points.inCircle(a, b, vertex(path, best), c) > 0);
      best = better ? k : best;
    }
    return best;
  }

  private int vertex(int[] path, int k) {
    return k == path.length ? target(path[k - 1]) : origin(path[k]);
  }

  private int newEdge(int from, int to) {
    int e = made;
    origin[e] = from;
    origin[e + 1] = to;
    made += 2;
    return bound + e;
  }

  private void triangle(int e, int f, int g) {
    link(e, f);
    link(f, g);
    link(g, e);
    filled++;
  }

  private void link(int e, int following) {
    next[slot(e)] = following;
    prev[slot(following)] = e;
  }
}
