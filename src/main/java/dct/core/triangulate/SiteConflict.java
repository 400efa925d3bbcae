package dct.core.triangulate;

import dct.core.geometry.Points;
import dct.core.geometry.Predicates;
import java.util.Arrays;

/**
 * What a new site at some place changes in a Delaunay triangulation: the triangles in whose circles
 * it lies, and the hull edges that it sees from outside, make room for edges from the site (Bowyer
 * 1981, Watson 1981). Nothing is changed; time and space are linear in what would be, after a walk
 * to the place.
 *
 * <p>Outside each hull edge there is a triangle with a corner at infinity; its circle is the open
 * half-plane beyond the edge and the inside of the edge itself. So the site may be anywhere.
 */
final class SiteConflict {
  private final SiteHole mesh;
  private final Points points;
  private final double x;
  private final double y;
  private final HalfEdgeList suspects = new HalfEdgeList(); // with the conflict on their right
  private final HalfEdgeList removed = new HalfEdgeList();
  private final HalfEdgeList kept = new HalfEdgeList(); // round the conflict, on their right
  private final HalfEdgeList inward = new HalfEdgeList();
  private int hullFrom = -1; // the ends of what is seen of the hull, or −1
  private int hullTo = -1;
  private int occupied = -1;
  private final int place;

  /** Looks for what a site here changes, beginning at a half-edge that had better be near. */
  SiteConflict(SiteHole mesh, double x, double y, int near) {
    this.mesh = mesh;
    this.points = mesh.points();
    this.x = x;
    this.y = y;
    place = walk(near);
    if (mesh.isOuter(place)) {
      spreadOverHull(place);
    } else if (!isOccupied(place)) {
      suspects.add(place ^ 1);
      suspectBehind(place);
    }
    spread();
  }

  /** A half-edge at the place, from which to begin the next walk. */
  int place() {
    return mesh.isOuter(place) ? place ^ 1 : place;
  }

  /** The site that is at this very place already, or −1; nothing changes then. */
  int occupied() {
    return occupied;
  }

  /** Half-edges of the edges that have no place any more. */
  int[] removed() {
    return removed.toArray();
  }

  /** Half-edges of the edges that were on the hull and are inside it now. */
  int[] inward() {
    return inward.toArray();
  }

  /** The sites to which the new one has an edge, in ascending order. */
  int[] spokes() {
    int[] spokes = new int[kept.size() + (hullFrom < 0 ? 0 : 1)];
    for (int k = 0; k < kept.size(); k++) {
      spokes[k] = mesh.origin(kept.get(k));
    }
    if (hullFrom >= 0) { // the half-edges make no ring but a path from one end to the other
      spokes[kept.size()] = hullFrom;
    }
    Arrays.sort(spokes);
    return spokes;
  }

  /** Whether the edge to this site is on the hull. */
  boolean isHullSpoke(int v) {
    return v == hullFrom || v == hullTo;
  }

  // ---- the way to the place

  /**
   * A half-edge whose left triangle holds the place, or which has it on its left outside the hull.
   * Of Delaunay triangulations every such walk comes to an end.
   */
  private int walk(int near) {
    int e = mesh.isOuter(near) ? near ^ 1 : near;
    while (true) {
      int f = mesh.next(e);
      int g = mesh.prev(e);
      int across = orient(e) < 0 ? e : orient(f) < 0 ? f : orient(g) < 0 ? g : -1;
      if (across < 0) {
        return e;
      }
      e = across ^ 1;
      if (mesh.isOuter(e)) {
        return e;
      }
    }
  }

  private boolean isOccupied(int triangle) {
    int e = triangle;
    do {
      int v = mesh.origin(e);
      if (points.x(v) == x && points.y(v) == y) {
        occupied = v;
      }
      e = mesh.next(e);
    } while (e != triangle);
    return occupied >= 0;
  }

  // ---- the conflict, whose triangles form a tree: no site is inside it

  private void spread() {
    while (suspects.size() > 0) {
      look(suspects.pop());
    }
  }

  /** Looks at what is left of e, a triangle or the outside, from the conflict on its right. */
  private void look(int e) {
    boolean outside = mesh.isOuter(e);
    if (outside ? !sees(e) : !isInCircle(e)) {
      kept.add(e);
    } else {
      removed.add(e);
      if (outside) {
        spreadAlong(e);
      } else {
        suspectBehind(e);
      }
    }
  }

  private void suspectBehind(int e) {
    suspects.add(mesh.next(e) ^ 1);
    suspects.add(mesh.prev(e) ^ 1);
  }

  /** The site is outside of this hull edge, or on it. */
  private void spreadOverHull(int e) {
    lookInside(e);
    spreadAlong(e);
  }

  /** Looks at the hull edges on both sides of one that the site sees. */
  private void spreadAlong(int e) {
    int f = mesh.next(e);
    for (; sees(f); f = mesh.next(f)) {
      lookInside(f);
    }
    hullTo = mesh.origin(f);
    int g = mesh.prev(e);
    for (; sees(g); g = mesh.prev(g)) {
      lookInside(g);
    }
    hullFrom = mesh.target(g);
  }

  /** Looks at the triangle inside a hull edge, from the outside that is in conflict. */
  private void lookInside(int e) {
    if (isInCircle(e ^ 1)) {
      removed.add(e);
      suspectBehind(e ^ 1);
    } else {
      kept.add(e ^ 1);
      inward.add(e);
    }
  }

  // ---- predicates

  private int orient(int e) {
    int a = mesh.origin(e);
    int b = mesh.target(e);
    return Predicates.orient(points.x(a), points.y(a), points.x(b), points.y(b), x, y);
  }

  private boolean isInCircle(int e) {
    int a = mesh.origin(e);
    int b = mesh.target(e);
    int c = mesh.origin(mesh.prev(e));
    return Predicates.inCircle(
            points.x(a), points.y(a), points.x(b), points.y(b), points.x(c), points.y(c), x, y)
        > 0;
  }

  /** Whether the place is beyond this hull edge, or on it between its ends. */
  private boolean sees(int e) {
    int turn = orient(e);
    return turn > 0 || (turn == 0 && isBetween(mesh.origin(e), mesh.target(e)));
  }

  private boolean isBetween(int a, int b) {
    double ax = points.x(a);
    double bx = points.x(b);
    return ax == bx
        ? (points.y(a) < y) == (y < points.y(b)) && y != points.y(a) && y != points.y(b)
        : (ax < x) == (x < bx) && x != ax && x != bx;
  }
}
