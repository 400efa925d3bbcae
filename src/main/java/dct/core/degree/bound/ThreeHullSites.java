package dct.core.degree.bound;

import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.colour.HullRing;

/**
 * The bound for three sites on the hull and four to seven in all.
 *
 * <p>A triangulation whose boundary is a triangle is a triangulation of the sphere, with 3n − 6
 * edges and all degrees at least 3 (n > 3). How many vertices can be odd?
 *
 * <ul>
 *   <li>n = 4: all four; every pair is joined.
 *   <li>n = 5: two; the degrees are at most 4, sum to 18, and 3, 3, 4, 4, 4 is the only way.
 *   <li>n = 6: none or four. Without a vertex of degree 3 all have degree 4, for they sum to 24. A
 *       vertex of degree 3 can be taken out, which leaves the case n = 5: two vertices of degree 3
 *       over the ring of the other three. Each of its triangles has one of the former and two of
 *       the latter; put back into it, the vertex makes 4, 5, 5 of them, and 3, 3, 4 are the others.
 *   <li>n = 7: at least two. If all were even, the degrees would sum to 30 without a 2: one 6 and
 *       six 4s. The vertex of degree 6 is joined to all, which form a ring; its other side is a
 *       hexagon cut by three diagonals, one end at each corner, but two corners of a triangulated
 *       hexagon are cut off by a diagonal and have none.
 * </ul>
 *
 * <p>If k vertices are odd and the wishes are a odd, b free, at least max(0, a − k, k − a − b) miss
 * theirs. O(1) once these are counted.
 */
final class ThreeHullSites {
  private static final int[][] POSSIBLE_ODD = {{4}, {2}, {0, 4}, {2, 4, 6}}; // by n − 4

  private ThreeHullSites() {}

  /**
   * The bound, zero where it does not apply.
   *
   * @param known for all even: a number of odd vertices that is known to be the least
   */
  static LowerBound of(HullRing ring, ParityGoal goal, int known) {
    int row = goal.size() - 4;
    int value = 0;
    if (ring.size() == 3 && row >= 0 && row < POSSIBLE_ODD.length) {
      int from = goal.isAll(Wish.EVEN) ? known : 0;
      value = least(POSSIBLE_ODD[row], from, goal);
    }
    return new LowerBound(value, "three hull sites");
  }

  private static int least(int[] possible, int from, ParityGoal goal) {
    int odd = goal.count(Wish.ODD);
    int free = goal.count(Wish.ANY);
    int least = Integer.MAX_VALUE;
    for (int k : possible) {
      if (k >= from) {
        least = Math.min(least, Math.max(0, Math.max(odd - k, k - odd - free)));
      }
    }
    return least;
  }
}
