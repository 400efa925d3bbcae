package dct.core.degree.exact;

import dct.core.degree.colour.Refutation;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;

/**
 * Refutations, and which of them refute a set that changes by one site at a time: a few operations
 * for each refutation and change.
 */
final class LearnedSets {
  private final BitSet set; // the present set of odd sites
  private final List<Refutation> all = new ArrayList<>();
  private final long[][] around; // by site and refutation: the cycles round the site, folded
  private long[] rest = new long[64]; // by refutation: 0 if it may refute the present set

  /** Nothing learned yet, for some sites of which these are odd. */
  LearnedSets(BitSet sites, BitSet odd) {
    set = odd;
    around = new long[sites.length()][];
    sites.stream().forEach(v -> around[v] = new long[rest.length]);
  }

  /** The present set; not to be changed. */
  BitSet set() {
    return set;
  }

  int size() {
    return all.size();
  }

  Refutation get(int j) {
    return all.get(j);
  }

  void add(Refutation refutation) {
    int j = all.size();
    all.add(refutation);
    if (j == rest.length) {
      rest = Arrays.copyOf(rest, 2 * j);
      Arrays.setAll(around, v -> around[v] == null ? null : Arrays.copyOf(around[v], rest.length));
    }
    rest[j] = fold(refutation.odd());
    for (int v = 0; v < around.length; v++) {
      if (around[v] != null) {
        around[v][j] = fold(refutation.around(v));
        rest[j] ^= set.get(v) ? around[v][j] : 0;
      }
    }
  }

  /** Up to 64 cycles as they are; of more, every 64th together: different sets may look alike. */
  private static long fold(BitSet cycles) {
    long bits = 0;
    for (int k = cycles.nextSetBit(0); k >= 0; k = cycles.nextSetBit(k + 1)) {
      bits ^= 1L << k; // modulo 64
    }
    return bits;
  }

  /** Puts a site into the present set, or takes it out. */
  void flip(int site) {
    set.flip(site);
    long[] change = around[site];
    for (int j = 0; j < all.size(); j++) {
      rest[j] ^= change[j];
    }
  }

  /** Whether the refutation with this number refutes the present set. */
  boolean refutes(int j) {
    return rest[j] == 0 && (all.get(j).rank() <= Long.SIZE || all.get(j).refutes(set));
  }
}
