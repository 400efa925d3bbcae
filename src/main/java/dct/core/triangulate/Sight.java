package dct.core.triangulate;

import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import java.util.Arrays;

/**
 * What the vertices of a triangulated polygon or region see: those to which the open segment lies
 * inside and passes through no third vertex, and their neighbours on the boundary.
 *
 * <p>Triangular expansion (Bungiu et al. 2014): a cone of sight is followed through the
 * triangulation and narrowed at each vertex that it meets; it ends at the boundary, that of holes
 * too. Exact. Not for several threads at once.
 */
public final class Sight {
  private final Points points;
  private final Dcel dcel;
  private final int most;
  private int[] waiting =
      new int[128]; // of four: half-edge to look through, right, left limit, edges crossed before
  private int waitingCount;
  private int[] found = new int[64];
  private int foundCount;

  /**
   * The sight in a triangulation.
   *
   * @param most so many of its edges are looked through
   */
  Sight(Points points, Dcel dcel, int most) {
    this.points = points;
    this.dcel = dcel;
    this.most = most;
  }

  /** The sight in a triangulation. */
  public static Sight in(Triangulation triangulation) {
    return new Sight(triangulation.points(), triangulation.dcel(), Integer.MAX_VALUE);
  }

  /**
   * What a vertex on the boundary sees, counter-clockwise, from its neighbour after it on the
   * boundary to the one before it.
   */
  public int[] from(int v) {
    foundCount = 0;
    int e = boundaryEdge(v);
    see(dcel.target(e));
    while (dcel.face(e) != Dcel.OUTER) {
      int through = dcel.next(e);
      await(through, dcel.origin(through), dcel.target(through), 0);
      lookThroughAll(v);
      e = dcel.rotate(e);
      see(dcel.target(e));
    }
    return Arrays.copyOf(found, foundCount);
  }

  private int boundaryEdge(int v) {
    int e = dcel.outEdge(v);
    while (dcel.face(e ^ 1) != Dcel.OUTER) {
      e = dcel.rotate(e);
    }
    return e;
  }

  private void see(int v) {
    if (foundCount == found.length) {
      found = Arrays.copyOf(found, 2 * foundCount);
    }
    found[foundCount++] = v;
  }

  private void await(int through, int right, int left, int crossed) {
    if (waitingCount + 4 > waiting.length) {
      waiting = Arrays.copyOf(waiting, 2 * waiting.length);
    }
    waiting[waitingCount++] = through;
    waiting[waitingCount++] = right;
    waiting[waitingCount++] = left;
    waiting[waitingCount++] = crossed;
  }

  private void lookThroughAll(int v) {
    while (waitingCount > 0) {
      int crossed = waiting[--waitingCount];
      int left = waiting[--waitingCount];
      int right = waiting[--waitingCount];
      int through = waiting[--waitingCount];
      if (through == Dcel.NONE) {
        see(right);
      } else if (crossed < most && dcel.face(through ^ 1) != Dcel.OUTER) {
        lookThrough(v, through ^ 1, right, left, crossed + 1);
      }
    }
  }

  /** The side of the triangle of e that is turned to v is e; its far corner narrows the cone. */
  private void lookThrough(int v, int e, int right, int left, int crossed) {
    int far = dcel.target(dcel.next(e));
    if (points.orient(v, right, far) <= 0) {
      await(dcel.prev(e), right, left, crossed);
    } else if (points.orient(v, far, left) <= 0) {
      await(dcel.next(e), right, left, crossed);
    } else {
      await(dcel.prev(e), far, left, crossed);
      await(Dcel.NONE, far, far, crossed);
      await(dcel.next(e), right, far, crossed);
    }
  }
}
