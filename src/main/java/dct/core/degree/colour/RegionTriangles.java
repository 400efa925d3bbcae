package dct.core.degree.colour;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import java.util.Arrays;
import java.util.Optional;

/**
 * All triangles of a region that some triangulation of it may have: their corners see each other,
 * no other vertex is in them or on them, and no boundary and no fixed edge crosses them.
 *
 * <p>What a vertex sees is found by triangular expansion (Bungiu et al. 2014): cones of sight are
 * followed through a triangulation and narrowed at each vertex that they meet; they end at boundary
 * and fixed edges. A triangle at v with corners a and b, which v sees in this order, is one of them
 * if b is seen from a nearer to v than all that v sees between the two: then none of these is in
 * the triangle, and if any vertex were in it, v would see one. Around v this goes from one boundary
 * or fixed edge to the next. Exact. In proportion to the pairs that v sees, at each v.
 */
final class RegionTriangles {
  private final Points points;
  private final Triangulation any;
  private final Dcel dcel;
  private final int most;
  private int[] corners = new int[256];
  private int count; // corners
  private int[] seen = new int[64]; // from one vertex, counter-clockwise
  private boolean[] isBarrier = new boolean[64]; // by place: the end of an edge that stays
  private int size;

  private RegionTriangles(Triangulation any, int most) {
    this.any = any;
    this.most = most;
    points = any.points();
    dcel = any.dcel();
  }

  /**
   * The triangles, or empty if there are more than {@code most}.
   *
   * @param any any triangulation of the region
   */
  static Optional<AllTriangles> of(Triangulation any, int most, Progress progress) {
    RegionTriangles run = new RegionTriangles(any, most);
    for (int v = 0; v < any.vertexCount(); v++) {
      progress.checkCancelled();
      run.look(v);
      run.addTriangles(v);
      if (run.count > 3 * most) {
        return Optional.empty();
      }
    }
    return Optional.of(AllTriangles.of(Arrays.copyOf(run.corners, run.count), any.vertexCount()));
  }

  // ---- sight

  private void look(int v) {
    size = 0;
    int first = firstEdge(v);
    int e = first;
    see(dcel.target(e), isBarrier(e));
    while (dcel.face(e) != Dcel.OUTER) {
      int through = dcel.next(e);
      lookThrough(v, through, dcel.origin(through), dcel.target(through));
      e = dcel.rotate(e);
      see(dcel.target(e), isBarrier(e)); // at a site the first one comes again at the end
      if (e == first) {
        break;
      }
    }
  }

  /** Along the boundary with the inside on its left, or of a fixed edge, or any. */
  private int firstEdge(int v) {
    int start = dcel.outEdge(v);
    int fixed = start;
    int e = start;
    do {
      if (dcel.face(e ^ 1) == Dcel.OUTER) {
        return e;
      }
      fixed = isBarrier(e) ? e : fixed;
      e = dcel.rotate(e);
    } while (e != start);
    return fixed;
  }

  private boolean isBarrier(int e) {
    return dcel.isBoundary(e >> 1) || any.kind(e >> 1) == EdgeKind.FIXED;
  }

  private void see(int w, boolean barrier) {
    if (size == seen.length) {
      seen = Arrays.copyOf(seen, 2 * size);
      isBarrier = Arrays.copyOf(isBarrier, 2 * size);
    }
    seen[size] = w;
    isBarrier[size++] = barrier;
  }

  /** Looks through the edge of e from its left side, between two directions. */
  private void lookThrough(int v, int e, int right, int left) {
    if (isBarrier(e)) {
      return;
    }
    int beyond = e ^ 1;
    int far = dcel.target(dcel.next(beyond));
    if (points.orient(v, right, far) <= 0) {
      lookThrough(v, dcel.prev(beyond), right, left);
    } else if (points.orient(v, far, left) <= 0) {
      lookThrough(v, dcel.next(beyond), right, left);
    } else {
      lookThrough(v, dcel.next(beyond), right, far);
      see(far, false);
      lookThrough(v, dcel.prev(beyond), far, left);
    }
  }

  // ---- triangles

  /** Adds the triangles of which v is the corner with the lowest number. */
  private void addTriangles(int v) {
    boolean isRound = seen[0] == seen[size - 1] && size > 1; // at a site
    boolean isClosed = isRound && !isBarrier[0];
    int last = isRound ? size - 1 : size; // different ones
    for (int i = 0; i < last; i++) {
      int a = seen[i];
      int nearest = -1;
      for (int j = i + 1; j < (isClosed ? i + last : size); j++) {
        int place = isClosed ? j % last : j;
        int b = seen[place];
        if (points.orient(v, a, b) <= 0) {
          break;
        }
        if (nearest < 0 || points.orient(a, nearest, b) > 0) {
          nearest = b;
          add(v, a, b);
        }
        if (isBarrier[place]) {
          break;
        }
      }
    }
  }

  private void add(int v, int a, int b) {
    if (v < a && v < b && count <= 3 * most) {
      if (count + 3 > corners.length) {
        corners = Arrays.copyOf(corners, 2 * corners.length);
      }
      corners[count++] = v;
      corners[count++] = a;
      corners[count++] = b;
    }
  }
}
