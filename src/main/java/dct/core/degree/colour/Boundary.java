package dct.core.degree.colour;

import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * The rings of a boundary, the outer one first, each walked with the triangles on its left; and
 * where a way just outside of them crosses rays.
 *
 * <p>From each vertex a ray runs to the right, a hair upwards; vertices are compared by height
 * across the rays: by y, those with the same y from right to left. So no two have the same height,
 * and orientation decides the rest. Exact.
 *
 * <p>A <em>position</em>, 0 … m − 1, is a place on the rings, one after the other, and the edge
 * from there to the next place. The way outside leads from the midpoint of each edge, just below
 * its upper end, to that of the next edge.
 */
final class Boundary {
  private final Triangulation triangulation;
  private final Points points;
  private final int[] vertex; // by position
  private final int[] after; // by position: the next one on its ring
  private final int[] before; // by position
  private final int[] ring; // by position
  private final int[] first; // by ring: its first position
  private final int[] rising; // of a hull: positions from its lowest site to the one below its top

  /** The boundary of any triangulation with a triangle, in linear time. */
  Boundary(Triangulation triangulation) {
    this.triangulation = triangulation;
    points = triangulation.points();
    Dcel dcel = triangulation.dcel();
    boolean isHull = triangulation.domain() == Domain.SITES; // one cycle, and perhaps many sites
    int[] starts = isHull ? new int[] {dcel.faceEdge(Dcel.OUTER)} : dcel.outerCycles();
    vertex = new int[Arrays.stream(starts).map(e -> length(dcel, e)).sum()];
    after = new int[vertex.length];
    before = new int[vertex.length];
    ring = new int[vertex.length];
    first = new int[starts.length];
    int size = 0;
    for (int r = 0; r < starts.length; r++) {
      first[r] = size;
      size = walk(starts[r], size, r);
    }
    rising = isHull ? rising() : null;
  }

  private static int length(Dcel dcel, int start) {
    int length = 1;
    for (int e = dcel.next(start); e != start; e = dcel.next(e)) {
      length++;
    }
    return length;
  }

  private int walk(int start, int from, int number) {
    Dcel dcel = triangulation.dcel();
    int size = from;
    int e = start;
    do {
      vertex[size] = dcel.origin(e);
      ring[size] = number;
      after[size] = size + 1;
      before[size] = size - 1;
      size++;
      e = dcel.prev(e); // the outer face is on its left, so its inverse has triangles there
    } while (e != start);
    after[size - 1] = from;
    before[from] = size - 1;
    return size;
  }

  private int[] rising() {
    return IntStream.range(0, size())
        .filter(k -> isBelow(vertex[k], vertex[after[k]]))
        .boxed()
        .sorted((k, l) -> isBelow(vertex[k], vertex[l]) ? -1 : 1)
        .mapToInt(Integer::intValue)
        .toArray();
  }

  /** The triangulation that it was read from. */
  Triangulation triangulation() {
    return triangulation;
  }

  /** All vertices. */
  Points points() {
    return points;
  }

  /** The number of positions. */
  int size() {
    return vertex.length;
  }

  /** The number of rings. */
  int rings() {
    return first.length;
  }

  /** The first position of a ring. */
  int first(int number) {
    return first[number];
  }

  /** The vertex at a position. */
  int vertex(int k) {
    return vertex[k];
  }

  /** The next position on the same ring. */
  int after(int k) {
    return after[k];
  }

  /** The ring on which a position is. */
  int ring(int k) {
    return ring[k];
  }

  /** Whether a vertex is below another one. */
  boolean isBelow(int u, int v) {
    return points.y(u) < points.y(v) || (points.y(u) == points.y(v) && points.x(u) > points.x(v));
  }

  /**
   * The positions of the edges just before the way outside, from one edge to the next, crosses the
   * ray of a vertex.
   */
  int[] exits(int u) {
    return rising == null ? everyExit(u) : new int[] {exit(u)};
  }

  /**
   * The only one of a hull: before the last edge that begins below the site or in it, but for rays
   * from the top.
   */
  private int exit(int u) {
    int low = 0;
    int high = rising.length;
    while (high - low > 1) {
      int middle = (low + high) >>> 1;
      if (isBelow(u, vertex[rising[middle]])) {
        high = middle;
      } else {
        low = middle;
      }
    }
    boolean isTop = u == vertex[after[rising[low]]];
    return isTop ? rising[low] : before[rising[low]];
  }

  private int[] everyExit(int u) {
    int[] exits = new int[4];
    int count = 0;
    for (int k = 0; k < size(); k++) {
      int p = vertex[k];
      int q = vertex[after[k]];
      boolean isCrossed = q == u ? leaves(p, u, vertex[after[after[k]]]) : isCrossed(p, q, u);
      if (isCrossed) {
        exits = count < exits.length ? exits : Arrays.copyOf(exits, 2 * count);
        exits[count++] = q == u || isBelow(q, p) ? k : before[k];
      }
    }
    return Arrays.copyOf(exits, count);
  }

  /** Whether the ray of u, which is not q, crosses the edge from p to q inside. */
  private boolean isCrossed(int p, int q, int u) {
    int low = isBelow(p, q) ? p : q;
    int top = low == p ? q : p;
    return u != p && isBelow(low, u) && isBelow(u, top) && points.orient(low, top, u) > 0;
  }

  /** Whether the ray of v, between its neighbours a and b on the ring, leaves to the outside. */
  private boolean leaves(int a, int v, int b) {
    boolean aUp = isBelow(v, a); // on the left of the ray
    boolean bUp = isBelow(v, b);
    if (aUp != bUp) {
      return bUp; // counter-clockwise from a, which is below, by the ray to b
    }
    return points.orient(a, v, b) > 0; // the angle outside is the one of more than 180°
  }
}
