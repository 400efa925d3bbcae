package dct.core.degree.colour;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;

/**
 * What was learned where no triangulation has exactly some odd vertices: cycles in the plane, and
 * for each whether the number of those odd vertices that it goes round is odd. No set with the same
 * parities inside all of these cycles is possible either.
 *
 * <p>Proof. The conflict used the signs of some sides only ({@link Core}). Join the centres of
 * their triangles with the midpoints of their edges, and the midpoints on the hull with each other
 * outside. Black and white can be exchanged for one triangle, or on both sides of one edge, without
 * a change of what the rows say; that changes the signs of all joins there. So only the sum of the
 * signs on each cycle of joins matters, which is the number of odd vertices inside modulo 2. ∎
 */
public final class Refutation {
  private final List<BitSet> cycles; // sites inside; none is a sum of others
  private final BitSet odd; // cycles that go round an odd number
  private final BitSet support = new BitSet();

  private Refutation(List<BitSet> cycles, BitSet sites) {
    this.cycles = cycles;
    odd = parities(sites);
    cycles.forEach(support::or);
  }

  static Refutation of(Core core, SignedSides sides, BitSet odd) {
    return new Refutation(CycleBasis.of(core.sides(), sides), odd);
  }

  /** That exactly these of n sites are not possible. */
  static Refutation exactly(int n, BitSet odd) {
    List<BitSet> cycles = new ArrayList<>();
    for (int v = 0; v < n; v++) {
      BitSet one = new BitSet();
      one.set(v);
      cycles.add(one);
    }
    return new Refutation(cycles, odd);
  }

  private BitSet parities(BitSet sites) {
    BitSet parities = new BitSet();
    for (int u = sites.nextSetBit(0); u >= 0; u = sites.nextSetBit(u + 1)) {
      parities.xor(around(u));
    }
    return parities;
  }

  /** Whether this shows that no triangulation has exactly these odd vertices. */
  public boolean refutes(BitSet sites) {
    for (int k = 0; k < cycles.size(); k++) {
      BitSet cycle = cycles.get(k);
      boolean isOdd = false;
      for (int u = sites.nextSetBit(0); u >= 0; u = sites.nextSetBit(u + 1)) {
        isOdd ^= cycle.get(u);
      }
      if (isOdd != odd.get(k)) {
        return false;
      }
    }
    return true;
  }

  /** The cycles that go round a site; a set is refuted whose sites' sum to {@link #odd}. */
  public BitSet around(int site) {
    BitSet around = new BitSet();
    IntStream.range(0, cycles.size()).filter(k -> cycles.get(k).get(site)).forEach(around::set);
    return around;
  }

  /** The cycles that go round an odd number of a refuted set. */
  public BitSet odd() {
    return odd;
  }

  /** The number of cycles. */
  public int rank() {
    return cycles.size();
  }

  /** The sites inside some cycle: a set that differs in others only is refuted as well. */
  public BitSet support() {
    return support;
  }
}
