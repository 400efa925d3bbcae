package dct.core.degree.strip;

import java.util.Arrays;

/** Numbers the distinct keys that it is given: 0, 1, 2 … in the order in which they come. */
final class LongIndex {
  private static final long GOLDEN = 0x9E3779B97F4A7C15L; // 2^64 over the golden ratio

  private int[] slot = new int[1 << 8]; // number + 1, by hash; twice as many as keys or more
  private long[] keys = new long[1 << 7]; // by number
  private int shift = Long.SIZE - 8; // leaves as many high bits as slots have
  private int size;

  /** The number of keys. */
  int size() {
    return size;
  }

  /** The key with this number. */
  long key(int number) {
    return keys[number];
  }

  /** The number of a key; if it is new, it gets the next one, {@link #size} as it was before. */
  int number(long key) {
    int mask = slot.length - 1;
    int s = (int) ((key * GOLDEN) >>> shift);
    while (slot[s] != 0 && keys[slot[s] - 1] != key) {
      s = (s + 1) & mask;
    }
    if (slot[s] != 0) {
      return slot[s] - 1;
    }
    keys[size++] = key;
    slot[s] = size;
    if (size == keys.length) {
      grow();
    }
    return size - 1;
  }

  private void grow() {
    long[] old = keys;
    int count = size;
    keys = new long[2 * old.length];
    slot = new int[4 * old.length];
    shift--;
    size = 0;
    for (int i = 0; i < count; i++) {
      number(old[i]);
    }
  }

  /** Forgets all keys. */
  void clear() {
    Arrays.fill(slot, 0);
    size = 0;
  }
}
