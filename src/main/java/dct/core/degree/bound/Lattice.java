package dct.core.degree.bound;

import dct.core.Progress;
import dct.core.dcel.Dcel;
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
  private final Dcel dcel; // of a triangulation
  private final int a; // the corners of its first triangle
  private final int b;
  private final int c;
  private final long area; // twice that of every triangle, in the unit of the coordinates

  private Lattice(WholeCoordinates sites, Dcel dcel) {
    this.sites = sites;
    this.dcel = dcel;
    int e = dcel.faceEdge(1);
    a = dcel.origin(e);
    b = dcel.target(e);
    c = dcel.origin(dcel.prev(e));
    area = area(1);
  }

  /**
   * The lattice of these sites, if they are one; from any triangulation that has a triangle.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Optional<Lattice> of(Triangulation triangulation, Progress progress) {
    return WholeCoordinates.of(triangulation.points(), progress)
        .map(sites -> new Lattice(sites, triangulation.dcel()))
        .filter(lattice -> lattice.haveOneArea(progress))
        .filter(lattice -> lattice.isEverySiteOnIt(triangulation.vertexCount(), progress));
  }

  private boolean haveOneArea(Progress progress) {
    for (int f = 1; f < dcel.faceBound(); f++) {
      Progress.check(progress, f);
      if (area(f) != area) {
        return false;
      }
    }
    return true;
  }

  private long area(int f) {
    int e = dcel.faceEdge(f);
    return sites.cross(dcel.origin(e), dcel.target(e), dcel.origin(dcel.prev(e)));
  }

  private boolean isEverySiteOnIt(int n, Progress progress) {
    for (int v = 0; v < n; v++) {
      Progress.check(progress, v);
      if (sites.cross(a, v, c) % area != 0 || sites.cross(a, b, v) % area != 0) {
        return false;
      }
    }
    return true;
  }

  /** The first coordinate of v, by Cramer's rule. */
  public long first(int v) {
    return sites.cross(a, v, c) / area;
  }

  /** The second coordinate of v: counter-clockwise of the first one. */
  public long second(int v) {
    return sites.cross(a, b, v) / area;
  }
}
