package dct.core.degree;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Region;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.HertelMehlhorn;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Partition;
import dct.core.triangulate.Triangulation;

/** What {@link PartitioningAqt} and {@link OddFan} share: convex pieces, each cut by one rule. */
public final class ConvexPieces {
  private ConvexPieces() {}

  /** How to triangulate one strictly convex face with n vertices, from its lowest-numbered one. */
  interface Cutter {
    void cut(Dcel dcel, int v0, int n, Progress progress);
  }

  /**
   * The convex pieces of a simple polygon, merged from its monotone triangulation.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Partition of(SimplePolygon polygon, Progress progress) {
    return of(Region.of(polygon), progress);
  }

  /**
   * The convex pieces of a region, merged from its monotone triangulation.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Partition of(Region region, Progress progress) {
    return HertelMehlhorn.partition(
        region, MonotoneTriangulation.triangulate(region, progress), progress);
  }

  /** Whether every angle of the polygon is less than 180°. */
  public static boolean isConvex(SimplePolygon polygon) {
    int n = polygon.size();
    for (int k = 0; k < n; k++) {
      int before = polygon.vertex((k + n - 1) % n);
      if (polygon.points().orient(before, polygon.vertex(k), polygon.vertex((k + 1) % n)) <= 0) {
        return false;
      }
    }
    return true;
  }

  /** A strictly convex polygon as its own only piece. */
  static Partition single(SimplePolygon polygon) {
    if (!isConvex(polygon)) {
      throw new IllegalArgumentException("a vertex has an angle of 180° or more");
    }
    return new Partition(Region.of(polygon), Dcel.cycle(polygon.walk()));
  }

  /** Cuts every piece; the diagonals between pieces become {@link EdgeKind#PARTITION}. */
  static Triangulation triangulate(Partition partition, Cutter cutter, Progress progress) {
    Dcel dcel = partition.dcel().copy();
    int partitionEdges = dcel.edgeCount();
    int pieces = dcel.faceBound();
    for (int f = 1; f < pieces; f++) {
      Progress.tick(progress, f - 1, pieces, "Triangulating the convex pieces");
      cutFace(dcel, f, cutter, progress);
    }
    return Triangulation.of(
        partition.region(),
        dcel,
        edge -> edge < partitionEdges ? EdgeKind.PARTITION : EdgeKind.DIAGONAL);
  }

  private static void cutFace(Dcel dcel, int face, Cutter cutter, Progress progress) {
    int start = dcel.faceEdge(face);
    int lowest = start;
    int n = 1;
    for (int e = dcel.next(start); e != start; e = dcel.next(e)) {
      n++;
      if (dcel.origin(e) < dcel.origin(lowest)) {
        lowest = e;
      }
    }
    cutter.cut(dcel, lowest, n, progress);
  }
}
