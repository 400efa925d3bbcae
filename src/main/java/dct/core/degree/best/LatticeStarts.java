package dct.core.degree.best;

import dct.core.Progress;
import dct.core.degree.bound.Lattice;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;

/**
 * Triangulations of a full lattice polygon whose edges inside have three directions: a, b and b − a
 * for some basis a, b of the lattice.
 *
 * <p>Such a triangulation gives every vertex inside degree 6. Whether the boundary is even as well
 * depends on the three directions, and not on how the lattice lies in the plane; so several are
 * tried: those of the triangles at hand, those next to them, and those that follow from two
 * directions of the hull. The linear map that takes a and b to two sides of a triangle with three
 * acute angles makes this the Delaunay triangulation, which also fills what the three directions
 * leave along the hull. O(n log n) time each.
 */
final class LatticeStarts {
  private static final int MOST_SIDES = 6; // directions of the hull that are paired

  private final Triangulation start;
  private final Lattice lattice;

  /**
   * Two lattice vectors that span a parallelogram of area 1, the second on the left of the first.
   */
  private record Basis(Vector a, Vector b) {}

  /** A lattice vector. */
  private record Vector(long x, long y) {
    Vector plus(Vector that) {
      return new Vector(x + that.x, y + that.y);
    }

    Vector minus(Vector that) {
      return new Vector(x - that.x, y - that.y);
    }

    long cross(Vector that) {
      return x * that.y - y * that.x;
    }

    /** This vector or its opposite: that which goes to the right, or straight up. */
    Vector upright() {
      return x < 0 || (x == 0 && y < 0) ? new Vector(-x, -y) : this;
    }
  }

  private LatticeStarts(Triangulation start, Lattice lattice) {
    this.start = start;
    this.lattice = lattice;
  }

  /**
   * These triangulations, each made when it is asked for; none if the sites are no full lattice
   * polygon.
   *
   * @param start any triangulation of the sites
   * @param progress cancels this and the making of one
   */
  static List<Supplier<Triangulation>> of(Triangulation start, Progress progress) {
    return Lattice.of(start, progress)
        .map(lattice -> new LatticeStarts(start, lattice).all(progress))
        .orElse(List.of());
  }

  private List<Supplier<Triangulation>> all(Progress progress) {
    List<Supplier<Triangulation>> all = new ArrayList<>();
    for (Basis basis : bases()) {
      all.add(() -> triangulation(basis, progress));
    }
    return all;
  }

  private Set<Basis> bases() {
    Vector x = new Vector(1, 0);
    Vector y = new Vector(0, 1);
    Set<Basis> bases = new LinkedHashSet<>();
    bases.add(new Basis(x, y));
    bases.add(new Basis(x, x.plus(y)));
    bases.add(new Basis(x, y.minus(x)));
    bases.add(new Basis(y, y.plus(y).minus(x)));
    List<Vector> sides = sides();
    for (Vector a : sides) {
      for (Vector b : sides) {
        if (a.cross(b) == 1) {
          bases.add(new Basis(a, b));
          bases.add(new Basis(a, a.plus(b)));
        }
      }
    }
    return bases;
  }

  /** The directions of the hull, those first that come first along it. */
  private List<Vector> sides() {
    Set<Vector> sides = new LinkedHashSet<>();
    for (int edge = 0; edge < start.edgeCount() && sides.size() < MOST_SIDES; edge++) {
      if (start.kind(edge) == EdgeKind.BOUNDARY) {
        sides.add(place(start.to(edge)).minus(place(start.from(edge))).upright());
      }
    }
    return new ArrayList<>(sides);
  }

  private Vector place(int v) {
    return new Vector(lattice.first(v), lattice.second(v));
  }

  /** Maps a to (30, 0) and b to (15, 26). */
  private Triangulation triangulation(Basis basis, Progress progress) {
    double[] pairs = new double[2 * start.vertexCount()];
    for (int v = 0; v < start.vertexCount(); v++) {
      Vector place = place(v);
      double alongA = place.cross(basis.b);
      double alongB = basis.a.cross(place);
      pairs[2 * v] = 30 * alongA + 15 * alongB;
      pairs[2 * v + 1] = 26 * alongB;
    }
    Triangulation mapped =
        Delaunay.triangulate(Sites.of(Points.ofPairs(pairs), progress), progress);
    return new Triangulation(
        start.domain(), start.points(), mapped.dcel(), edge -> EdgeKind.DIAGONAL);
  }
}
