package dct.core.degree.bound;

import dct.core.triangulate.Triangulation;
import java.util.Optional;

/**
 * Sites that are all the lattice points of a lattice polygon, in coordinates of that lattice: whole
 * numbers in a basis of two sides of one triangle.
 *
 * <p>Recognised exactly, for any lattice in the plane: coordinates are whole multiples of one power
 * of two, less than 2³⁰ of it apart; all triangles have one area; and every site is a whole
 * combination of two sides of the first triangle. Lattices of finer coordinates are not looked for.
 * O(n) time, much less where the sites are no lattice.
 */
public final class Lattice {
  private final WholeCoordinates sites;
  private final int[] corners; // of all triangles
  private final long area; // twice that of every triangle, in the unit of the coordinates

  private Lattice(WholeCoordinates sites, int[] corners) {
    this.sites = sites;
    this.corners = corners;
    area = sites.cross(corners[0], corners[1], corners[2]);
  }

  /** The lattice of these sites, if they are one; from any triangulation that has a triangle. */
  public static Optional<Lattice> of(Triangulation triangulation) {
    return WholeCoordinates.of(triangulation.points())
        .map(sites -> new Lattice(sites, triangulation.triangles()))
        .filter(lattice -> lattice.haveOneArea())
        .filter(lattice -> lattice.isEverySiteOnIt(triangulation.vertexCount()));
  }

  private boolean haveOneArea() {
    for (int k = 0; k < corners.length; k += 3) {
      if (sites.cross(corners[k], corners[k + 1], corners[k + 2]) != area) {
        return false;
      }
    }
    return true;
  }

  private boolean isEverySiteOnIt(int n) {
    for (int v = 0; v < n; v++) {
      if (sites.cross(corners[0], v, corners[2]) % area != 0
          || sites.cross(corners[0], corners[1], v) % area != 0) {
        return false;
      }
    }
    return true;
  }

  /** The first coordinate of v, by Cramer's rule. */
  public long first(int v) {
    return sites.cross(corners[0], v, corners[2]) / area;
  }

  /** The second coordinate of v: counter-clockwise of the first one. */
  public long second(int v) {
    return sites.cross(corners[0], corners[1], v) / area;
  }
}
