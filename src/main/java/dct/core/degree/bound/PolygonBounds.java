package dct.core.degree.bound;

import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;

/**
 * A lower bound for the number of vertices of a simple polygon that miss their wished parity, from
 * the wishes alone: it holds for every polygon with these vertices in this order.
 *
 * <p>The larger of two. Boundary colouring: {@link BoundaryColouring}, for all even 0 if 3 divides
 * n and else 2. Ears: a triangulation of n ≥ 4 vertices has two triangles with two boundary edges
 * each, because n boundary edges lie on n − 2 triangles and none has three; their vertices of
 * degree 2 are even, so that at most n − 2 vertices can be odd. Rounded up by the handshake lemma.
 * O(n).
 */
public final class PolygonBounds {

  private PolygonBounds() {}

  /**
   * The bound for a simple polygon with n vertices.
   *
   * @param goal the wish of each vertex, in the polygon's order
   * @throws IllegalArgumentException if there are not n wishes, or n is less than 3
   */
  public static LowerBound of(int n, ParityGoal goal) {
    if (n < 3 || goal.size() != n) {
      throw new IllegalArgumentException(goal.size() + " wishes for " + n + " vertices");
    }
    if (goal.isAll(Wish.EVEN)) {
      return BoundaryColouring.allEven(n, "vertices");
    }
    int colouring = BoundaryColouring.leastUnmet(n, goal::wish);
    Handshake handshake = new Handshake(goal);
    return handshake
        .bound()
        .max(handshake.roundUp(new LowerBound(colouring, "boundary edges two-coloured, mod 3")))
        .max(handshake.roundUp(ears(n, goal)));
  }

  private static LowerBound ears(int n, ParityGoal goal) {
    int notWishedOdd = n - goal.count(Wish.ODD);
    return new LowerBound(n > 3 ? 2 - notWishedOdd : 0, "two ears have degree 2");
  }
}
