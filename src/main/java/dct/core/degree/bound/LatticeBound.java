package dct.core.degree.bound;

import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;

/**
 * The bound for sites that are all the lattice points of a lattice polygon, for any lattice in the
 * plane.
 *
 * <p>Choose a basis of the lattice; an edge between neighbouring lattice points has a vector that
 * is (1, 0), (0, 1) or (1, 1) modulo 2, its class. Every triangle of a triangulation that uses all
 * the points has the least possible area, so two of its sides are a basis and its three sides have
 * the three classes, one each.
 *
 * <p>Claim: let all wishes hold, and be even inside the hull. Colour the triangles as in {@link
 * BoundaryColouring}; then black less white boundary edges is the same number for each class.
 * Proof: each inner edge of a class has a black and a white side, so that in each class the
 * difference on the boundary is the number of black triangles less that of white ones. ∎ With all
 * wishes even the boundary is black: where its edges are not of the three classes in equal numbers,
 * at least one wish, and by the handshake lemma two, are missed. A rectangle along the axes has no
 * boundary edge of class (1, 1).
 *
 * <p>The lattice is recognised exactly: coordinates are whole multiples of one power of two, less
 * than 2³⁰ of it apart; all triangles have one area; and every site is a whole combination of two
 * sides of one triangle. Lattices of finer coordinates are not looked for. O(n) time, much less
 * where the sites are no lattice.
 */
final class LatticeBound {
  private final HullRing ring;
  private final WholeCoordinates sites;
  private final int[] corners; // of all triangles
  private final long area; // twice that of every triangle, in the unit of the coordinates

  private LatticeBound(HullRing ring, WholeCoordinates sites) {
    this.ring = ring;
    this.sites = sites;
    corners = ring.triangulation().triangles();
    area = sites.cross(corners[0], corners[1], corners[2]);
  }

  static LowerBound of(HullRing ring, ParityGoal goal) {
    return new LowerBound(isObstructed(ring, goal) ? 1 : 0, "full lattice polygon");
  }

  private static boolean isObstructed(HullRing ring, ParityGoal goal) {
    if (!BoundaryColouring.areInnerEven(ring, goal) || hasFreeSite(ring, goal)) {
      return false;
    }
    return WholeCoordinates.of(ring.points())
        .map(sites -> new LatticeBound(ring, sites))
        .filter(LatticeBound::isFullLattice)
        .map(lattice -> !lattice.isBalanced(goal))
        .orElse(false);
  }

  private static boolean hasFreeSite(HullRing ring, ParityGoal goal) {
    for (int k = 0; k < ring.size(); k++) {
      if (goal.wish(ring.site(k)) == Wish.ANY) {
        return true;
      }
    }
    return false;
  }

  private boolean isFullLattice() {
    return haveOneArea() && isEverySiteOnLattice();
  }

  private boolean haveOneArea() {
    for (int k = 0; k < corners.length; k += 3) {
      if (sites.cross(corners[k], corners[k + 1], corners[k + 2]) != area) {
        return false;
      }
    }
    return true;
  }

  private boolean isEverySiteOnLattice() {
    for (int v = 0; v < ring.points().size(); v++) {
      if (first(v) % area != 0 || second(v) % area != 0) {
        return false;
      }
    }
    return true;
  }

  /** The first lattice coordinate of v times the area, by Cramer's rule. */
  private long first(int v) {
    return sites.cross(corners[0], v, corners[2]);
  }

  private long second(int v) {
    return sites.cross(corners[0], corners[1], v);
  }

  /** Whether the coloured boundary edges have the same sum in each class. */
  private boolean isBalanced(ParityGoal goal) {
    int[] sum = new int[4]; // by class
    int colour = 1;
    for (int k = 0; k < ring.size(); k++) {
      colour = goal.wish(ring.site(k)) == Wish.ODD ? -colour : colour;
      sum[parities(ring.site(k)) ^ parities(ring.site(k + 1))] += colour;
    }
    return sum[1] == sum[2] && sum[2] == sum[3];
  }

  private int parities(int v) {
    long first = Math.floorDiv(first(v), area) & 1;
    long second = Math.floorDiv(second(v), area) & 1;
    return (int) (first + 2 * second);
  }
}
