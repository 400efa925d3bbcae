package dct.core.degree;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Region;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.Triangulation;

/**
 * Many odd vertices: a fan in each convex piece. The thesis names this button (Table 4.3, "Convex
 * Polygon Odd Triangulation") and gives no algorithm.
 *
 * <p>In a convex polygon with n &gt; 3 vertices, the fan from v₀ gives v₀ the degree n−1, its two
 * neighbours 2, and the n−3 others 3. So n−2 vertices are odd if n is even, n−3 if n is odd.
 *
 * <p>No triangulation has more. By Meisters' theorem it has two ears, whose tips have degree 2: at
 * most n−2 are odd. The number of odd vertices of a graph is even (handshake), so for odd n at most
 * n−3 are.
 *
 * <p>Takes any simple polygon or region; v₀ is the lowest-numbered vertex of each piece. O(n log n)
 * for the pieces, O(n) for the fans.
 */
public final class OddFan {

  private OddFan() {}

  /**
   * A triangulation of a simple polygon; the diagonals between convex pieces are of kind {@link
   * dct.core.triangulate.EdgeKind#PARTITION}.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Triangulation triangulate(SimplePolygon polygon, Progress progress) {
    return triangulate(Region.of(polygon), progress);
  }

  /**
   * A triangulation of a region, in the same way.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Triangulation triangulate(Region region, Progress progress) {
    return ConvexPieces.triangulate(ConvexPieces.of(region, progress), OddFan::cut, progress);
  }

  private static void cut(Dcel dcel, int v0, int n, Progress progress) {
    int hub = v0;
    int vi = dcel.next(dcel.next(v0));
    for (int i = 2; i <= n - 2; i++) {
      Progress.check(progress, i); // not in every small piece
      hub = dcel.splitFace(hub, vi);
      vi = dcel.next(vi);
    }
  }
}
