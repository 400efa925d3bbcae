package dct.experiment.generate;

import java.util.Arrays;
import java.util.BitSet;

/** A set of places of a grid: a bit for each place, or a hash table where those would be many. */
final class PlaceSet {
  private static final long EMPTY = -1;
  private static final long MOST_BITS = 1L << 31;

  private final long columns;
  private final BitSet bits; // null if there is a table
  private final long[] table; // open addressing, at most half full

  /** The empty set, to which no more than {@code most} places will be added. */
  PlaceSet(Grid grid, int most) {
    columns = grid.columns();
    boolean few = grid.places() < Math.min(MOST_BITS, 64L * (most + 16L));
    bits = few ? new BitSet((int) grid.places()) : null;
    table = few ? null : new long[4 * Integer.highestOneBit(most + 1)];
    if (!few) {
      Arrays.fill(table, EMPTY);
    }
  }

  /** Adds a place; false if it was there. */
  boolean add(long x, long y) {
    long place = y * columns + x;
    if (bits == null) {
      return addToTable(place);
    }
    boolean isNew = !bits.get((int) place);
    bits.set((int) place);
    return isNew;
  }

  private boolean addToTable(long place) {
    int mask = table.length - 1;
    int slot = (int) ((place * 0x9E3779B97F4A7C15L) >>> 33) & mask;
    while (table[slot] != EMPTY) {
      if (table[slot] == place) {
        return false;
      }
      slot = (slot + 1) & mask;
    }
    table[slot] = place;
    return true;
  }
}
