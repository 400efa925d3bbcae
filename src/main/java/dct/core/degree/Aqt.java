package dct.core.degree;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.Triangulation;

/**
 * Alternate Quadrangulation-Triangulation of a convex polygon (thesis, Algorithm 3.1): all n
 * vertices even if 3 divides n, all but two otherwise (Lemmas 3.2 and 3.3), which is the most
 * possible.
 *
 * <p>v₀ is joined to each vᵢ, i = 2 … n−2, whose i is no multiple of 3; that leaves triangles and
 * quadrilaterals in turn, and each quadrilateral v₀ vᵢ vᵢ₊₁ vᵢ₊₂ is cut by vᵢ vᵢ₊₂. As printed, the
 * loop over the quadrilaterals runs while i &lt; n−3 and leaves the last one open for n = 3k+2 (n =
 * 5, 8, …); its bound must be i ≤ n−3.
 *
 * <p>v₀ is the lowest-numbered vertex of the piece. O(n).
 */
public final class Aqt {

  private Aqt() {}

  /**
   * Triangulates a strictly convex polygon.
   *
   * @throws IllegalArgumentException if the polygon has a vertex whose angle is 180° or more
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Triangulation triangulate(SimplePolygon polygon, Progress progress) {
    return ConvexPieces.triangulate(ConvexPieces.single(polygon), Aqt::cut, progress);
  }

  /**
   * Triangulates one convex face with n vertices.
   *
   * @param v0 the half-edge of the face that leaves v₀
   */
  static void cut(Dcel dcel, int v0, int n, Progress progress) {
    int hub = v0; // leaves v₀ in the part that is still whole
    int vi = dcel.next(dcel.next(v0)); // leaves vᵢ in that part
    for (int i = 2; i <= n - 2; i += 3) {
      Progress.check(progress, i / 3 + 1); // not in every small piece
      hub = dcel.splitFace(hub, vi);
      if (i <= n - 3) {
        int viPlus2 = dcel.next(dcel.next(vi));
        dcel.splitFace(vi, viPlus2);
        if (i + 2 <= n - 2) {
          hub = dcel.splitFace(hub, viPlus2);
        }
        vi = dcel.next(viPlus2);
      }
    }
  }
}
