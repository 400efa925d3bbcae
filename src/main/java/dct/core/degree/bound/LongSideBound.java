package dct.core.degree.bound;

import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.colour.HullRing;

/**
 * The bound from one long straight side of the hull with few sites off it.
 *
 * <p>Let m sites lie inside one side, r hull sites off that side, i inside the hull, and let E of
 * the m be wished even. Claim: at least E − 2i − r + 1 of them are odd. Proof: the m + 1 edges of
 * the side lie on different triangles, which leaves 2i + r − 1 of all 2i + m + r. A site inside the
 * side has two triangles on the side; to be even it needs an odd number of triangles, so at least
 * one of those that are left. None of these serves two: sites of one side are joined only along it.
 * ∎
 *
 * <p>O(h) time. Weaker than the walk along the side, but it costs nothing at any size.
 */
final class LongSideBound {

  private LongSideBound() {}

  /**
   * A side of the hull.
   *
   * @param corner the position where it begins
   * @param inside how many sites lie inside it, from the next position on
   * @param wishedEven how many of these are wished even
   */
  record Side(int corner, int inside, int wishedEven) {
    /** How many hull sites lie off it. */
    int others(HullRing ring) {
      return ring.size() - inside - 2;
    }

    /**
     * So many of its sites that are wished even are odd at least; negative if that says nothing.
     */
    int odd(HullRing ring) {
      return wishedEven - 2 * ring.interior() - others(ring) + 1;
    }
  }

  static LowerBound of(HullRing ring, ParityGoal goal) {
    return new LowerBound(Math.max(0, best(ring, goal).odd(ring)), "long side");
  }

  /** The side that gives the largest bound. */
  static Side best(HullRing ring, ParityGoal goal) {
    int first = 0;
    while (ring.isFlat(first)) {
      first++;
    }
    Side best = side(ring, first, goal);
    int corner = first + best.inside + 1;
    while (corner < first + ring.size()) {
      Side side = side(ring, corner, goal);
      best = side.odd(ring) > best.odd(ring) ? side : best;
      corner += side.inside + 1;
    }
    return best;
  }

  private static Side side(HullRing ring, int corner, ParityGoal goal) {
    int even = 0;
    int k = corner + 1;
    while (ring.isFlat(k)) {
      even += goal.wish(ring.site(k)) == Wish.EVEN ? 1 : 0;
      k++;
    }
    return new Side(corner, k - corner - 1, even);
  }
}
