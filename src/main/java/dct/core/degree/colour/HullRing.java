package dct.core.degree.colour;

import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.triangulate.Triangulation;
import java.util.stream.IntStream;

/**
 * The boundary of the hull of sites that do not all lie on one line: h sites, those inside its
 * edges included, counter-clockwise. Positions are taken modulo h.
 */
public final class HullRing {
  private final Triangulation triangulation;
  private final int[]
      outward; // by position: the half-edge that leaves the site along the outer face
  private final boolean[] onHull; // by site

  private HullRing(Triangulation triangulation, int[] outward) {
    this.triangulation = triangulation;
    this.outward = outward;
    onHull = new boolean[triangulation.vertexCount()];
    for (int k = 0; k < outward.length; k++) {
      onHull[site(k)] = true;
    }
  }

  /** The boundary of any triangulation of the sites that has a triangle, in O(h) steps. */
  public static HullRing of(Triangulation triangulation) {
    Dcel dcel = triangulation.dcel();
    int first = dcel.faceEdge(Dcel.OUTER);
    IntStream.Builder outward = IntStream.builder();
    int e = first;
    do {
      outward.add(e);
      e = dcel.prev(e); // the outer face is walked clockwise, so its inverse is counter-clockwise
    } while (e != first);
    return new HullRing(triangulation, outward.build().toArray());
  }

  /** The triangulation that the ring was read from. */
  public Triangulation triangulation() {
    return triangulation;
  }

  /** The sites. */
  public Points points() {
    return triangulation.points();
  }

  /** The number of sites on the boundary, h. */
  public int size() {
    return outward.length;
  }

  /** The number of sites inside the hull. */
  public int interior() {
    return onHull.length - outward.length;
  }

  /** The site at position k, which may be any number. */
  public int site(int k) {
    return triangulation.dcel().origin(outward[Math.floorMod(k, outward.length)]);
  }

  /** Whether site v is on the boundary. */
  public boolean contains(int v) {
    return onHull[v];
  }

  /** Whether the site at position k lies inside an edge of the hull. */
  public boolean isFlat(int k) {
    return points().orient(site(k - 1), site(k), site(k + 1)) == 0;
  }

  /**
   * Whether the site at position k and its two neighbours on the boundary form a triangle with no
   * other site in it or on it, in time proportional to its degree.
   *
   * <p>It is enough to look at the neighbours of v in the triangulation. If all of them lie
   * strictly beyond the line through its two neighbours on the hull, then so do the edges between
   * them, the triangles at v cover the triangle in question, and these have no site inside.
   */
  public boolean isEarable(int k) {
    Dcel dcel = triangulation.dcel();
    int before = site(k - 1);
    int after = site(k + 1);
    int e = outward[Math.floorMod(k, outward.length)]; // leaves v, towards the site before it
    for (int f = dcel.rotate(e); dcel.target(f) != before; f = dcel.rotate(f)) {
      boolean isBeyond = points().orient(before, after, dcel.target(f)) > 0;
      if (dcel.target(f) != after && !isBeyond) {
        return false;
      }
    }
    return !isFlat(k);
  }
}
