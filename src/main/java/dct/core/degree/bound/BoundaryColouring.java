package dct.core.degree.bound;

import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.colour.HullRing;
import java.util.Arrays;
import java.util.function.IntFunction;

/**
 * The bound from the length of the boundary modulo 3.
 *
 * <p>Claim: let every inner vertex be even. Then the triangles can be coloured black and white so
 * that neighbours differ, and the black boundary edges less the white ones are a multiple of 3.
 * Proof: the dual graph is connected and every cycle in it encloses vertices whose triangles come
 * in even numbers, so it is bipartite. Every inner edge has a black and a white side; counting
 * sides, 3·black triangles − 3·white triangles = black − white boundary edges. ∎
 *
 * <p>A boundary vertex of even degree has an odd number of triangles: its two boundary edges have
 * one colour. At a vertex of odd degree the colour changes. So with all vertices even 3 divides the
 * number h of boundary edges, and in general the wishes that hold on the boundary fix its colours.
 *
 * <p>A simple polygon has no inner vertex: the fewest changes against the wishes that make the
 * difference a multiple of 3 are a bound for every goal. Sites have: where all inner ones are
 * wished even the same holds, or else at least one of those misses its wish.
 *
 * <p>Each step of the walk keeps the least cost for each colour and each difference modulo 3. O(h).
 */
public final class BoundaryColouring {
  private static final int STATES = 6; // colour (0 black, 1 white) times 3, plus the difference
  private static final int UNREACHED = Integer.MAX_VALUE / 2;

  private BoundaryColouring() {}

  /**
   * The least number of boundary vertices that miss their wish while all inner ones are even.
   *
   * @param wish the wish of the k-th vertex along the boundary
   */
  static int leastUnmet(int h, IntFunction<Wish> wish) {
    return costs(h, wish)[0];
  }

  /**
   * The least number of boundary vertices that miss their wish, for each way in which the colours
   * of their edges can come out.
   *
   * @param wish the wish of the k-th vertex along the boundary
   * @return at d, for black less white edges ≡ d mod 3, the edge before vertex 0 being black; at 3
   *     + d the same if that edge is found to be white when the walk returns to it
   */
  static int[] costs(int h, IntFunction<Wish> wish) {
    int[] cost = new int[STATES];
    Arrays.fill(cost, UNREACHED);
    cost[0] = 0; // the edge before vertex 0 is black; it is counted when the walk returns to it
    for (int k = 0; k < h; k++) {
      cost = step(cost, wish.apply(k));
    }
    return cost;
  }

  /**
   * A way to let the colour change or not at each boundary vertex that misses {@link #leastUnmet}
   * wishes.
   *
   * @param wish the wish of the k-th vertex along the boundary
   */
  static boolean[] cheapest(int h, IntFunction<Wish> wish) {
    int[][] cost = new int[h + 1][];
    cost[0] = new int[STATES];
    Arrays.fill(cost[0], UNREACHED);
    cost[0][0] = 0;
    for (int k = 0; k < h; k++) {
      cost[k + 1] = step(cost[k], wish.apply(k));
    }
    boolean[] changes = new boolean[h];
    int state = 0;
    for (int k = h - 1; k >= 0; k--) {
      int before = 0; // twice the state before, plus 1 where the colour changes
      while (next(before / 2, (before & 1) == 1) != state
          || cost[k][before / 2] + wish.apply(k).penalty(before & 1) != cost[k + 1][state]) {
        before++;
      }
      changes[k] = (before & 1) == 1;
      state = before / 2;
    }
    return changes;
  }

  private static int[] step(int[] cost, Wish wish) {
    int[] after = new int[STATES];
    Arrays.fill(after, UNREACHED);
    for (int state = 0; state < STATES; state++) {
      int even = next(state, false);
      int odd = next(state, true);
      after[even] = Math.min(after[even], cost[state] + wish.penalty(0));
      after[odd] = Math.min(after[odd], cost[state] + wish.penalty(1));
    }
    return after;
  }

  /** The state on the next boundary edge, after a vertex where the colour changes or does not. */
  static int next(int state, boolean changes) {
    int colour = changes ? 1 - Math.floorDiv(state, 3) : Math.floorDiv(state, 3);
    int difference = (state % 3 + (colour == 0 ? 1 : 2)) % 3;
    return 3 * colour + difference;
  }

  /** The bound for sites. */
  static LowerBound ofSites(HullRing ring, ParityGoal goal) {
    int h = ring.size();
    if (goal.isAll(Wish.EVEN)) {
      return allEven(h, "hull sites");
    }
    if (!areInnerEven(ring, goal)) {
      return new LowerBound(0, "handshake lemma");
    }
    int onBoundary = leastUnmet(h, k -> goal.wish(ring.site(k)));
    int value = ring.interior() == 0 ? onBoundary : Math.min(1, onBoundary);
    return new LowerBound(value, "boundary edges two-coloured, mod 3");
  }

  /** Whether even is wished of every site inside the hull. */
  static boolean areInnerEven(HullRing ring, ParityGoal goal) {
    for (int v = 0; v < goal.size(); v++) {
      if (!ring.contains(v) && goal.wish(v) != Wish.EVEN) {
        return false;
      }
    }
    return true;
  }

  /** The bound for all vertices even: 0 if 3 divides h, or else 2. */
  public static LowerBound allEven(int h, String what) {
    return h % 3 == 0
        ? new LowerBound(0, h + " " + what + ", " + h + " ≡ 0 mod 3")
        : new LowerBound(2, h + " " + what + ", 3 does not divide " + h);
  }
}
