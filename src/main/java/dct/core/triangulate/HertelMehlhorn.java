package dct.core.triangulate;

import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import java.util.BitSet;

/**
 * Cuts a simple polygon into convex pieces: removes from a triangulation the diagonals that no
 * vertex needs (Hertel and Mehlhorn 1983; thesis, Section 3.2.2).
 *
 * <p>Takes any triangulation of the polygon. Returns pieces that are <em>strictly</em> convex, no
 * vertex of a piece has an angle of 180°, so that each can be triangulated from any of its vertices
 * without a flat triangle. A diagonal is removed if at both its ends the angle that then opens is
 * less than 180°; diagonals are tried once, in the order of their numbers.
 *
 * <p>Each vertex keeps at most two diagonals, and only if its inner angle is 180° or more. With r
 * such vertices there are at most 2r + 1 pieces, and at least ⌈r/2⌉ + 1 in any partition into
 * strictly convex pieces by diagonals: never more than four times the fewest. O(n) time and space.
 */
public final class HertelMehlhorn {
  private final Points points;
  private final Dcel dcel;
  private final int[] following; // of the half-edges kept: the next one counter-clockwise at origin
  private final int[] preceding; // the next one clockwise
  private final BitSet removed = new BitSet();

  private HertelMehlhorn(Triangulation triangulation) {
    points = triangulation.points();
    dcel = triangulation.dcel();
    following = new int[2 * dcel.edgeCount()];
    preceding = new int[2 * dcel.edgeCount()];
    for (int e = 0; e < following.length; e++) {
      following[e] = dcel.rotate(e);
      preceding[e] = dcel.rotateBack(e);
    }
  }

  /** The convex pieces into which the triangulation of the polygon can be merged. */
  public static Partition partition(SimplePolygon polygon, Triangulation triangulation) {
    HertelMehlhorn run = new HertelMehlhorn(triangulation);
    for (int edge = 0; edge < triangulation.edgeCount(); edge++) {
      if (triangulation.kind(edge) != EdgeKind.BOUNDARY && run.isInessential(2 * edge)) {
        run.remove(2 * edge);
      }
    }
    return new Partition(polygon, run.dcel.without(run.removed));
  }

  private boolean isInessential(int e) {
    return opensConvex(e) && opensConvex(e ^ 1);
  }

  /** Whether the angle at the origin of e between its neighbours is less than 180°. */
  private boolean opensConvex(int e) {
    int v = dcel.origin(e);
    int clockwise = dcel.target(preceding[e]);
    int counterClockwise = dcel.target(following[e]);
    return points.orient(clockwise, v, counterClockwise) < 0;
  }

  private void remove(int e) {
    removed.set(e >> 1);
    unlink(e);
    unlink(e ^ 1);
  }

  private void unlink(int e) {
    following[preceding[e]] = following[e];
    preceding[following[e]] = preceding[e];
  }
}
