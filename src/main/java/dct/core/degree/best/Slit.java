package dct.core.degree.best;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.dcel.HalfEdges;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import dct.core.triangulate.ConstrainedDelaunay;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import java.util.List;

/**
 * A region with one hole and nothing inside, cut open along a diagonal between its rings: one
 * closed walk of n + 2 vertices, in which the ends of the diagonal come twice. The walk begins with
 * the second copy of one end, n, and ends with that of the other, n + 1.
 */
final class Slit {
  private final Region region;
  private final int u;
  private final int w;
  private final Points points; // with those of the copies
  private final Dcel dcel; // a triangulation of what the walk bounds
  private final int[] walk;

  /**
   * Cuts a region open, in O(n log n) expected time.
   *
   * @param u a vertex of one ring
   * @param w a vertex of the other, which u sees
   */
  Slit(Region region, int u, int w, Progress progress) {
    this.region = region;
    this.u = u;
    this.w = w;
    int n = region.size();
    Points old = region.points();
    points = old.inserted(n, old.x(u), old.y(u)).inserted(n + 1, old.x(w), old.y(w));
    dcel = open(withDiagonal(progress), progress);
    walk = walked();
  }

  private Dcel withDiagonal(Progress progress) {
    Rings rings = region.rings();
    Region fixed =
        Region.of(Rings.of(region.points(), List.of(rings.ring(0), rings.ring(1)), u, w), progress);
    return ConstrainedDelaunay.triangulate(fixed, progress).dcel();
  }

  /**
   * The triangulation with the diagonal doubled. The left of u → w keeps the half-edge and both old
   * ends; the triangle to the right gets a half-edge from n + 1 to n.
   */
  private Dcel open(Dcel whole, Progress progress) {
    int n = region.size();
    int left = whole.outEdge(u);
    while (whole.target(left) != w) {
      left = whole.rotate(left);
    }
    int right = Dcel.twin(left); // from w to u; it becomes the outer side of the left edge
    int copy = 2 * whole.edgeCount();
    int[] next = new int[copy + 2];
    int[] origin = new int[copy + 2];
    for (int e = 0; e < copy; e++) {
      next[e] = whole.next(e);
      origin[e] = whole.origin(e);
    }
    int intoU = outerInto(whole, u);
    int intoW = outerInto(whole, w);
    for (int e = Dcel.twin(intoU); e != left; e = whole.rotate(e)) {
      origin[e] = n;
    }
    for (int e = whole.rotate(right); e != Dcel.twin(intoW); e = whole.rotate(e)) {
      origin[e] = n + 1;
    }
    origin[copy] = n + 1;
    origin[copy + 1] = n;
    next[copy] = whole.next(right);
    next[whole.prev(right)] = copy;
    next[copy + 1] = whole.next(intoW);
    next[right] = whole.next(intoU);
    next[intoU] = copy + 1;
    next[intoW] = right;
    return Dcel.of(n + 2, HalfEdges.of(next, origin), copy + 1, progress);
  }

  /** The half-edge of the outer face, or of the hole, that ends at this vertex. */
  private static int outerInto(Dcel whole, int v) {
    int e = whole.outEdge(v);
    while (whole.face(Dcel.twin(e)) != Dcel.OUTER) {
      e = whole.rotate(e);
    }
    return Dcel.twin(e);
  }

  /** Against the direction of the outer face, from n to n + 1. */
  private int[] walked() {
    int[] vertices = new int[points.size()];
    int e = dcel.faceEdge(Dcel.OUTER);
    while (dcel.origin(e) != points.size() - 2 || dcel.target(e) != points.size() - 1) {
      e = dcel.next(e);
    }
    for (int k = 0; k < vertices.length; k++) {
      vertices[k] = dcel.origin(e);
      e = dcel.prev(e);
    }
    return vertices;
  }

  /** The vertices with the copies behind them. */
  Points points() {
    return points;
  }

  /** A triangulation of what the walk bounds. */
  Dcel dcel() {
    return dcel;
  }

  /** The walk, counter-clockwise. */
  int[] walk() {
    return walk.clone();
  }

  /** The position of the first copy of the one end; that of the other follows. */
  int position() {
    int k = 0;
    while (walk[k] != u) {
      k++;
    }
    return k;
  }

  /**
   * The triangulation of the region that is one of the opened region, closed again.
   *
   * @param opened whose edge k runs from position k to the next one
   */
  Triangulation closed(Dcel opened, Progress progress) {
    int kept = 2 * position(); // from u to w
    int gone = 2 * (walk.length - 1); // from n + 1 to n
    int[] next = new int[2 * opened.edgeCount() - 2];
    int[] origin = new int[next.length];
    for (int e = 0; e < 2 * opened.edgeCount(); e++) {
      if (e != gone + 1 && e != kept + 1) {
        int at = renumbered(e, kept, gone);
        next[at] = renumbered(after(opened, e, kept, gone), kept, gone);
        int v = opened.origin(e);
        origin[at] = v == region.size() ? u : v == region.size() + 1 ? w : v;
      }
    }
    int[] outer = {
      renumbered(opened.next(kept + 1), kept, gone), renumbered(opened.next(gone + 1), kept, gone)
    };
    boolean isFirst = region.rings().ringOf(u) == 0;
    int[] cycles = isFirst ? outer : new int[] {outer[1], outer[0]};
    Dcel dcel = Dcel.of(region.size(), HalfEdges.of(next, origin), cycles, progress);
    return Triangulation.of(region, dcel, edge -> EdgeKind.DIAGONAL);
  }

  /** On the outside each copy of the diagonal is skipped, so that both rings close. */
  private static int after(Dcel opened, int e, int kept, int gone) {
    int next = opened.next(e);
    if (next == gone + 1) {
      return opened.next(kept + 1);
    }
    return next == kept + 1 ? opened.next(gone + 1) : next;
  }

  private static int renumbered(int e, int kept, int gone) {
    if (e == gone) {
      return kept + 1;
    }
    return e > gone ? e - 2 : e;
  }
}
