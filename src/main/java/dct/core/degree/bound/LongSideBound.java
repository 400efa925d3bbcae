package dct.core.degree.bound;

import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;

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

  static LowerBound of(HullRing ring, ParityGoal goal) {
    int best = 0;
    int h = ring.size();
    int corner = 0;
    while (ring.isFlat(corner)) {
      corner++;
    }
    for (int k = corner + 1; k < corner + h; k++) {
      int m = 0;
      int even = 0;
      while (ring.isFlat(k)) {
        even += goal.wish(ring.site(k)) == Wish.EVEN ? 1 : 0;
        m++;
        k++;
      }
      int offSide = h - m - 2;
      best = Math.max(best, even - 2 * ring.interior() - offSide + 1);
    }
    return new LowerBound(best, "long side");
  }
}
