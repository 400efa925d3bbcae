package dct.testing;

import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import dct.core.triangulate.Triangulation;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Whether a triangulation is constrained Delaunay, by the definition: no vertex that is visible
 * from inside a triangle lies inside its circle. Looks at every triangle, every vertex in its
 * circle, every direction in which that vertex may see the triangle, and every edge in between: in
 * O(n⁴) steps, exact.
 */
public final class ConstrainedDelaunayOracle {
  private final Points points;
  private final BigInteger[] x; // of one common scale
  private final BigInteger[] y;
  private final List<int[]> opaque = new ArrayList<>(); // ring edges and fixed edges

  private ConstrainedDelaunayOracle(Region region) {
    points = region.points();
    int n = points.size();
    double[] all = Arrays.copyOf(points.xs(), 2 * n);
    System.arraycopy(points.ys(), 0, all, n, n);
    BigInteger[] scaled = Exact.scaled(all);
    x = Arrays.copyOf(scaled, n);
    y = Arrays.copyOfRange(scaled, n, 2 * n);
    Rings rings = region.rings();
    for (int edge = 0; edge < n + rings.fixedCount(); edge++) {
      if (edge >= n || rings.isOnRing(edge)) {
        opaque.add(new int[] {rings.from(edge), rings.to(edge)});
      }
    }
  }

  /** The first vertex found where it must not be, or nothing. */
  public static Optional<String> problem(Triangulation t, Region region) {
    ConstrainedDelaunayOracle oracle = new ConstrainedDelaunayOracle(region);
    int[] corners = t.triangles();
    for (int k = 0; k < corners.length; k += 3) {
      int[] triangle = Arrays.copyOfRange(corners, k, k + 3);
      for (int d = 0; d < region.size(); d++) {
        if (Exact.inCircle(oracle.points, triangle[0], triangle[1], triangle[2], d) > 0
            && oracle.sees(d, triangle)) {
          return Optional.of(
              "v%d is visible in the circle of %s".formatted(d, Arrays.toString(triangle)));
        }
      }
    }
    return Optional.empty();
  }

  /** Whether d, which is not in the triangle, sees a point inside of it. */
  private boolean sees(int d, int[] triangle) {
    int right = triangle[0]; // the outermost corners, as d sees them
    int left = triangle[0];
    for (int corner : triangle) {
      right = turn(d, right, corner) < 0 ? corner : right;
      left = turn(d, left, corner) > 0 ? corner : left;
    }
    int p = right;
    while (turn(d, p, left) > 0) {
      int q = left; // the next direction in which there is a vertex
      for (int v = 0; v < x.length; v++) {
        q = turn(d, p, v) > 0 && turn(d, v, q) > 0 ? v : q;
      }
      if (seesBetween(d, p, q, triangle)) {
        return true;
      }
      p = q;
    }
    return false;
  }

  private int turn(int a, int b, int c) {
    return Exact.orient(points, a, b, c);
  }

  /** Whether the ray from d through the middle of p and q meets the triangle before an edge. */
  private boolean seesBetween(int d, int p, int q, int[] triangle) {
    BigInteger rx = x[p].add(x[q]).subtract(x[d].shiftLeft(1));
    BigInteger ry = y[p].add(y[q]).subtract(y[d].shiftLeft(1));
    BigInteger[] entry = null;
    for (int k = 0; k < 3; k++) {
      BigInteger[] hit = hit(d, rx, ry, triangle[k], triangle[(k + 1) % 3]);
      entry = hit != null && (entry == null || isBefore(hit, entry)) ? hit : entry;
    }
    for (int[] edge : opaque) {
      BigInteger[] hit = hit(d, rx, ry, edge[0], edge[1]);
      if (hit != null && !isBefore(entry, hit)) {
        return false;
      }
    }
    return true;
  }

  /** How far along the ray it crosses uw, as a fraction with positive denominator; or null. */
  private BigInteger[] hit(int d, BigInteger rx, BigInteger ry, int u, int w) {
    int sideOfU = Exact.cross(rx, ry, x[u].subtract(x[d]), y[u].subtract(y[d])).signum();
    int sideOfW = Exact.cross(rx, ry, x[w].subtract(x[d]), y[w].subtract(y[d])).signum();
    if (sideOfU * sideOfW >= 0) {
      return null;
    }
    BigInteger ex = x[w].subtract(x[u]);
    BigInteger ey = y[w].subtract(y[u]);
    BigInteger numerator = Exact.cross(x[u].subtract(x[d]), y[u].subtract(y[d]), ex, ey);
    BigInteger denominator = Exact.cross(rx, ry, ex, ey);
    if (numerator.signum() * denominator.signum() <= 0) {
      return null;
    }
    return new BigInteger[] {numerator.abs(), denominator.abs()};
  }

  private static boolean isBefore(BigInteger[] a, BigInteger[] b) {
    return a[0].multiply(b[1]).compareTo(b[0].multiply(a[1])) < 0;
  }
}
