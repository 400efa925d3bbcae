package dct.core.degree.bound;

import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;

/**
 * What the handshake lemma says of the number of vertices that miss a wish.
 *
 * <p>Claim: if every wish is even or odd, the number u of unmet vertices has the parity of the
 * number w of vertices wished odd. Proof: turn the wished parities of the u vertices round and they
 * become the true parities, of which an even number are odd; each turn changes the number of odd
 * ones by one, so w + u is even. Where a vertex is left free nothing follows: it can absorb the
 * difference.
 */
final class Handshake {
  private final boolean applies;
  private final int wishedOdd;

  /** Counts the wishes, in linear time. */
  Handshake(ParityGoal goal) {
    wishedOdd = goal.count(Wish.ODD);
    applies = goal.count(Wish.ANY) == 0;
  }

  /** The least possible number of unmet vertices that is not below this one. */
  int roundUp(int unmet) {
    boolean fits = !applies || ((unmet + wishedOdd) & 1) == 0;
    return fits ? unmet : unmet + 1;
  }

  /** A bound whose value is rounded up and not negative. */
  LowerBound roundUp(LowerBound bound) {
    return new LowerBound(roundUp(Math.max(0, bound.value())), bound.reason(), bound.windows());
  }

  /** One if an odd number of vertices are wished odd and none is free, or else zero. */
  LowerBound bound() {
    return new LowerBound(roundUp(0), "handshake lemma");
  }
}
