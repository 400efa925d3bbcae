package dct.core.degree.strip;

import dct.core.SeededRandom;
import java.util.Arrays;

/** The states that can follow those of one layer of a sweep, each once, and the best of them. */
final class SweepOffspring {
  private static final int INDEX_BITS = 24;
  private static final int TIE_BITS = 20;

  private final SeededRandom random;
  private final LongIndex keys = new LongIndex();
  private int[] parent = new int[256];
  private int[] move = new int[256];
  private int[] unmet = new int[256];
  private int[] met = new int[256];

  SweepOffspring(SeededRandom random) {
    this.random = random;
  }

  void clear() {
    keys.clear();
  }

  /** Takes a state; of those with one key it keeps that with the fewest unmet. */
  void add(int from, int by, int misses, int meets, long key) {
    int known = keys.size();
    int i = keys.number(key);
    if (i == known) {
      reserve(i);
    } else if (unmet[i] <= misses) {
      return;
    }
    parent[i] = from;
    move[i] = by;
    unmet[i] = misses;
    met[i] = meets;
  }

  private void reserve(int index) {
    if (index == parent.length) {
      parent = Arrays.copyOf(parent, 2 * index);
      move = Arrays.copyOf(move, 2 * index);
      unmet = Arrays.copyOf(unmet, 2 * index);
      met = Arrays.copyOf(met, 2 * index);
    }
  }

  /**
   * Chooses at most so many states: those which have met most wishes, ties breaking at random.
   *
   * @return their numbers
   */
  int[] best(int width) {
    long[] ranked = new long[keys.size()];
    for (int i = 0; i < ranked.length; i++) {
      int tie = random.nextInt() >>> (Integer.SIZE - TIE_BITS);
      ranked[i] = ((-(long) met[i] << TIE_BITS | tie) << INDEX_BITS) | i;
    }
    Arrays.sort(ranked);
    int[] best = new int[Math.min(width, ranked.length)];
    for (int i = 0; i < best.length; i++) {
      best[i] = (int) ranked[i] & ((1 << INDEX_BITS) - 1);
    }
    return best;
  }

  /** Adds one of the states to a layer that follows the one it came from. */
  void materialize(int i, SweepFronts from, SweepFronts to) {
    int s = to.size;
    to.add(from, parent[i], move[i]);
    to.unmet[s] = unmet[i];
    to.met[s] = met[i];
    to.key[s] = keys.key(i);
  }

  /** The state of the layer before from which one came. */
  int parent(int i) {
    return parent[i];
  }

  /** The move by which it came. */
  int move(int i) {
    return move[i];
  }
}
