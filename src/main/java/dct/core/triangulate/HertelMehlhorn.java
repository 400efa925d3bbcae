package dct.core.triangulate;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.dcel.HalfEdges;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.SimplePolygon;

/**
 * Cuts a simple polygon or a region into convex pieces: removes from a triangulation the diagonals
 * that no vertex needs (Hertel and Mehlhorn 1983; thesis, Section 3.2.2).
 *
 * <p>Takes any triangulation of it; fixed edges stay. Returns pieces that are <em>strictly</em>
 * convex, no vertex of a piece has an angle of 180°, so that each can be triangulated from any of
 * its vertices without a flat triangle. A diagonal is removed if at both its ends the angle that
 * then opens is less than 180°; diagonals are tried once, in the order of their numbers.
 *
 * <p>Each vertex keeps at most two diagonals, and only if its inner angle is 180° or more. With r
 * such vertices there are at most 2r + 1 pieces, and at least ⌈r/2⌉ + 1 in any partition into
 * strictly convex pieces by diagonals: never more than four times the fewest, where there are no
 * sites, whose angle of 360° takes three diagonals, and no fixed edges. O(n) time and space.
 */
public final class HertelMehlhorn {
  private final Points points;
  private final HalfEdges links; // of the diagonals that are left
  private final int[] next;
  private final int[] prev;
  private final int[] origin;

  private HertelMehlhorn(Triangulation triangulation) {
    points = triangulation.points();
    links = triangulation.dcel().links();
    next = links.next();
    prev = links.prev();
    origin = links.origin();
  }

  /**
   * The convex pieces into which the triangulation of the polygon can be merged.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Partition partition(
      SimplePolygon polygon, Triangulation triangulation, Progress progress) {
    return partition(Region.of(polygon), triangulation, progress);
  }

  /**
   * The convex pieces into which the triangulation of the region can be merged.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Partition partition(Region region, Triangulation triangulation, Progress progress) {
    HertelMehlhorn run = new HertelMehlhorn(triangulation);
    for (int edge = 0; edge < triangulation.edgeCount(); edge++) {
      Progress.tick(progress, edge, triangulation.edgeCount(), "Merging convex pieces");
      EdgeKind kind = triangulation.kind(edge);
      boolean kept = kind == EdgeKind.BOUNDARY || kind == EdgeKind.FIXED;
      if (!kept && run.isInessential(2 * edge)) {
        run.links.remove(2 * edge); // the faces are found at the end
      }
    }
    int[] outside = triangulation.dcel().outerCycles();
    return new Partition(region, Dcel.of(region.size(), run.links, outside, progress));
  }

  private boolean isInessential(int e) {
    return opensConvex(e) && opensConvex(e ^ 1);
  }

  /** Whether the angle at the origin of e between its neighbours is less than 180°. */
  private boolean opensConvex(int e) {
    int clockwise = origin[next[e ^ 1] ^ 1];
    int counterClockwise = origin[prev[e]];
    return points.orient(clockwise, origin[e], counterClockwise) < 0;
  }
}
