package dct.core.degree;

import dct.core.Progress;
import dct.core.geometry.Region;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.HertelMehlhorn;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Partition;
import dct.core.triangulate.Triangulation;

/**
 * Many even vertices in a simple polygon: convex pieces ({@link
 * dct.core.triangulate.HertelMehlhorn}), and {@link Aqt} in each (thesis, Algorithm 3.3).
 *
 * <p>Takes any simple polygon or region. Good where few convex pieces do, poor for long reflex
 * chains (thesis, Figure 3.11). O(n log n) for the triangulation from which the pieces are merged,
 * O(n) for the rest.
 */
public final class PartitioningAqt {

  private PartitioningAqt() {}

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
    return triangulate(region, MonotoneTriangulation.triangulate(region, progress), progress);
  }

  /**
   * The same from a triangulation of the region, of whose diagonals the pieces are merged.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Triangulation triangulate(Region region, Triangulation start, Progress progress) {
    Partition pieces = HertelMehlhorn.partition(region, start, progress);
    return ConvexPieces.triangulate(pieces, Aqt::cut, progress);
  }
}
