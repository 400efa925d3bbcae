package dct.core.degree.bound;

import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.colour.HullRing;
import java.util.ArrayList;
import java.util.List;

/**
 * The bound from the sum of the degrees.
 *
 * <p>n > 3 sites, h of them on the hull, have 3n − 3 − h edges in every triangulation. A vertex has
 * degree 2 only where it is a corner of the hull that forms an empty triangle with its two
 * neighbours on the boundary (it is <i>earable</i>); two neighbours on the boundary cannot both,
 * their two triangles would be one and n would be 3. Every other degree is at least 3.
 *
 * <p>Claim: let E sites be wished even, and let X be the greatest weight of a set of earable
 * corners without neighbours on the boundary, where a corner weighs 2 if it is wished even, 1 if it
 * is free, and 0 if it is wished odd. Then at least E − X − 3n + 6 + 2h sites miss their wish.
 * Proof: start with 3 for each vertex. One that is wished even adds 1 more, unless it misses its
 * wish or has degree 2; each vertex of degree 2 takes 1 away, and misses its wish if that is odd.
 * So the sum 6n − 6 − 2h is at least 3n + E − X − u. ∎ With all wishes even: 2·(3 − interior sites
 * − corners cut off).
 *
 * <p>O(n) time: the corners are tested with the triangulation at hand, and the heaviest set on the
 * ring is found by a walk with and one without its first corner.
 */
final class DegreeSumBound {

  private DegreeSumBound() {}

  static LowerBound of(HullRing ring, ParityGoal goal) {
    int n = goal.size();
    int wishedEven = goal.count(Wish.EVEN);
    int room = 3 * n - 6 - 2 * ring.size();
    // Without corners cut off the bound is largest; most sites are far from that.
    boolean canHelp = n > 3 && wishedEven > room;
    int value = canHelp ? wishedEven - room - heaviest(weights(ring, goal)) : 0;
    return new LowerBound(value, "degree sum");
  }

  /** The positions of a heaviest set of corners that may have degree 2. */
  static List<Integer> cutOff(HullRing ring, ParityGoal goal) {
    int[] weight = weights(ring, goal);
    int last = weight.length - 1;
    boolean withoutLast = onPath(weight, 0, last - 1) >= onPath(weight, 1, last);
    return withoutLast ? chosen(weight, 0, last - 1) : chosen(weight, 1, last);
  }

  /** The positions of a heaviest set without neighbours on a path. */
  private static List<Integer> chosen(int[] weight, int from, int to) {
    int[] best = new int[to - from + 3]; // of the first k positions, at k + 1
    for (int k = from; k <= to; k++) {
      int j = k - from + 2;
      best[j] = Math.max(best[j - 1], best[j - 2] + weight[k]);
    }
    List<Integer> chosen = new ArrayList<>();
    int k = to;
    while (k >= from) {
      boolean isChosen = best[k - from + 2] > best[k - from + 1];
      if (isChosen) {
        chosen.add(k);
      }
      k -= isChosen ? 2 : 1;
    }
    return chosen;
  }

  private static int[] weights(HullRing ring, ParityGoal goal) {
    int[] weight = new int[ring.size()];
    for (int k = 0; k < weight.length; k++) {
      weight[k] = ring.isEarable(k) ? weight(goal.wish(ring.site(k))) : 0;
    }
    return weight;
  }

  private static int weight(Wish wish) {
    return switch (wish) {
      case EVEN -> 2;
      case ANY -> 1;
      case ODD -> 0;
    };
  }

  /** The greatest weight of a set without neighbours on a ring. */
  private static int heaviest(int[] weight) {
    int last = weight.length - 1;
    return Math.max(onPath(weight, 0, last - 1), onPath(weight, 1, last));
  }

  private static int onPath(int[] weight, int from, int to) {
    int best = 0; // up to the present position
    int before = 0; // up to the one before it
    for (int k = from; k <= to; k++) {
      int with = before + weight[k];
      before = best;
      best = Math.max(best, with);
    }
    return best;
  }
}
