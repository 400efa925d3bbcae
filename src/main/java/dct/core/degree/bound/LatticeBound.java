package dct.core.degree.bound;

import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.colour.HullRing;

/**
 * The bound for sites that are all the lattice points of a lattice polygon ({@link Lattice}).
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
 * boundary edge of class (1, 1). O(n) time.
 */
final class LatticeBound {

  private LatticeBound() {}

  static LowerBound of(HullRing ring, ParityGoal goal, Progress progress) {
    return new LowerBound(isObstructed(ring, goal, progress) ? 1 : 0, "full lattice polygon");
  }

  private static boolean isObstructed(HullRing ring, ParityGoal goal, Progress progress) {
    return BoundaryColouring.areInnerEven(ring, goal)
        && !hasFreeSite(ring, goal)
        && Lattice.of(ring.triangulation(), progress)
            .filter(l -> !isBalanced(l, ring, goal))
            .isPresent();
  }

  private static boolean hasFreeSite(HullRing ring, ParityGoal goal) {
    for (int k = 0; k < ring.size(); k++) {
      if (goal.wish(ring.site(k)) == Wish.ANY) {
        return true;
      }
    }
    return false;
  }

  /** Whether the coloured boundary edges have the same sum in each class. */
  private static boolean isBalanced(Lattice lattice, HullRing ring, ParityGoal goal) {
    int[] sum = sums(lattice, ring, goal);
    return sum[1] == sum[2] && sum[2] == sum[3];
  }

  /** Black less white boundary edges of each class, 1 to 3, if all wishes are granted. */
  static int[] sums(Lattice lattice, HullRing ring, ParityGoal goal) {
    int[] sum = new int[4];
    int colour = 1;
    for (int k = 0; k < ring.size(); k++) {
      colour = goal.wish(ring.site(k)) == Wish.ODD ? -colour : colour;
      sum[edgeClass(lattice, ring, k)] += colour;
    }
    return sum;
  }

  /** The class of the boundary edge after position k: 1, 2 or 3. */
  static int edgeClass(Lattice lattice, HullRing ring, int k) {
    return parities(lattice, ring.site(k)) ^ parities(lattice, ring.site(k + 1));
  }

  private static int parities(Lattice lattice, int v) {
    return (int) ((lattice.first(v) & 1) + 2 * (lattice.second(v) & 1));
  }
}
