package dct.core.degree.colour;

import dct.core.geometry.Points;
import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * The sides of all empty triangles, and which of them change the colour when a site is to be odd.
 *
 * <p>From each odd site a ray runs to the right, a hair upwards. Each triangle has a centre just
 * below its top corner, each edge a midpoint just below its upper end. The sign of a side is the
 * parity of the rays that are crossed on the way, inside the triangle, from the centre to the
 * midpoint of the edge. So only the side opposite the top corner T, its bottom side, can have the
 * sign 1: the way there crosses the rays that cross the edge from T to the middle corner M, and
 * that of M where it runs into the triangle. Outside of the boundary, too, the way from the
 * midpoint of one edge to that of the next crosses rays.
 *
 * <p>Sites are compared by height across the rays ({@link Boundary}). Exact.
 */
final class SignedSides {
  static final int NONE = -1;
  private static final int MOST_KEPT = 1 << 23; // numbers of crossing edges

  private final AllTriangles triangles;
  private final Boundary boundary;
  private final Points points;
  private final int[] bottom; // by triangle: its bottom side
  private final int[] flank; // by triangle: the edge from its top corner to the middle one
  private final int[] outerEdge; // by position; NONE where no triangle is known
  private final int[] outerPosition; // by edge, or NONE
  private final int[][] crossed; // by site: the sides that its ray crosses, or null
  private final int[][] crossing; // by edge: the edges that cross it, or null
  private int kept; // numbers in crossing
  private final long[] noRay;
  private final long[][] raysAcross; // by triangle, or null
  private final long[][] raysOutside; // by position, or null
  private int[][] exits; // by site: where its ray is crossed outside, or null

  SignedSides(AllTriangles triangles, Boundary boundary) {
    this.triangles = triangles;
    this.boundary = boundary;
    points = boundary.points();
    bottom = new int[triangles.count()];
    flank = new int[triangles.count()];
    for (int t = 0; t < bottom.length; t++) {
      orderCorners(t);
    }
    outerPosition = new int[triangles.edges()];
    Arrays.fill(outerPosition, NONE);
    outerEdge = new int[boundary.size()];
    for (int k = 0; k < outerEdge.length; k++) {
      outerEdge[k] = triangles.findEdge(boundary.vertex(k), boundary.vertex(boundary.after(k)));
      if (outerEdge[k] != NONE) {
        outerPosition[outerEdge[k]] = k;
      }
    }
    crossed = new int[points.size()][];
    crossing = new int[triangles.edges()][];
    noRay = new long[(points.size() + Long.SIZE - 1) / Long.SIZE];
    raysAcross = new long[triangles.count()][];
    raysOutside = new long[boundary.size()][];
  }

  private void orderCorners(int t) {
    int top = 3 * t;
    for (int side = 3 * t + 1; side < 3 * t + 3; side++) {
      top = isBelow(triangles.corner(top), triangles.corner(side)) ? side : top;
    }
    int next = AllTriangles.after(top);
    int last = AllTriangles.after(next);
    boolean isNextLowest = isBelow(triangles.corner(next), triangles.corner(last));
    bottom[t] = next;
    flank[t] = triangles.edge(isNextLowest ? last : top);
  }

  /** The triangles. */
  AllTriangles triangles() {
    return triangles;
  }

  /** The boundary of the hull or the region. */
  Boundary boundary() {
    return boundary;
  }

  /** The edge from the vertex at position k of the boundary to the next one. */
  int outerEdge(int k) {
    return outerEdge[k];
  }

  /** Whether an edge is on the boundary. */
  boolean isOuter(int edge) {
    return outerPosition[edge] != NONE;
  }

  /** The position of an edge on the boundary, or NONE. */
  int outerPosition(int edge) {
    return outerPosition[edge];
  }

  /** Whether the triangles at an edge of the boundary are those on its forward sides. */
  boolean isForward(int k) {
    return boundary.vertex(k) < boundary.vertex(boundary.after(k));
  }

  private boolean isBelow(int u, int v) {
    return boundary.isBelow(u, v);
  }

  // ---- rays

  /** The bottom sides that the ray of a site crosses; found when first asked for. */
  int[] crossed(int u) {
    if (crossed[u] == null) {
      crossed[u] = Arrays.stream(bottom).filter(side -> isCrossed(side, u)).toArray();
    }
    return crossed[u];
  }

  private boolean isCrossed(int bottomSide, int u) {
    int edge = flank[bottomSide / 3];
    int p = triangles.site(2 * edge);
    int q = triangles.site(2 * edge + 1);
    int top = isBelow(p, q) ? q : p;
    int middle = top == p ? q : p;
    if (u == middle) {
      int from = triangles.corner(bottomSide);
      int low = from == middle ? triangles.corner(AllTriangles.after(bottomSide)) : from;
      return points.orient(low, top, middle) > 0;
    }
    return isBelow(middle, u) && isBelow(u, top) && points.orient(middle, top, u) > 0;
  }

  /** The sites whose rays are crossed on the way to a side, a bit each. */
  long[] raysAcross(int side) {
    int t = side / 3;
    if (side != bottom[t]) {
      return noRay;
    }
    if (raysAcross[t] == null) {
      raysAcross[t] = new long[noRay.length];
      for (int u = 0; u < points.size(); u++) {
        raysAcross[t][u / Long.SIZE] |= isCrossed(side, u) ? 1L << u : 0;
      }
    }
    return raysAcross[t];
  }

  /** The sites whose rays are crossed outside from the first edge of a ring to that at k. */
  long[] raysOutside(int k) {
    if (exits == null) {
      exits = IntStream.range(0, points.size()).mapToObj(boundary::exits).toArray(int[][]::new);
    }
    if (raysOutside[k] == null) {
      raysOutside[k] = new long[noRay.length];
      int first = boundary.first(boundary.ring(k));
      for (int u = 0; u < exits.length; u++) {
        for (int exit : exits[u]) {
          raysOutside[k][u / Long.SIZE] ^= exit >= first && exit < k ? 1L << u : 0;
        }
      }
    }
    return raysOutside[k];
  }

  // ---- crossing edges

  /** The edges that cross an edge inside both; found when asked for, and kept for a while. */
  int[] crossing(int edge) {
    if (crossing[edge] == null) {
      int[] found = findCrossing(edge);
      if (kept + found.length > MOST_KEPT) {
        Arrays.fill(crossing, null);
        kept = 0;
      }
      kept += found.length;
      crossing[edge] = found;
    }
    return crossing[edge];
  }

  private int[] findCrossing(int edge) {
    int a = triangles.site(2 * edge);
    int b = triangles.site(2 * edge + 1);
    int[] turn = new int[points.size()];
    for (int v = 0; v < turn.length; v++) {
      turn[v] = v == a || v == b ? 0 : points.orient(a, b, v);
    }
    int[] found = new int[16];
    int size = 0;
    for (int f = 0; f < crossing.length; f++) {
      int c = triangles.site(2 * f);
      int d = triangles.site(2 * f + 1);
      if (turn[c] * turn[d] < 0 && points.orient(c, d, a) * points.orient(c, d, b) < 0) {
        found = size < found.length ? found : Arrays.copyOf(found, 2 * size);
        found[size++] = f;
      }
    }
    return Arrays.copyOf(found, size);
  }
}
