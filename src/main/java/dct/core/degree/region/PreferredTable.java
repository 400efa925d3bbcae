package dct.core.degree.region;

import java.util.Arrays;

/**
 * The {@link ChordTable} whose costs are pairs, compared lexicographically: the number of unmet
 * vertices, and what is preferred where that is equal. So the triangulation is the most preferred
 * of all those that leave the fewest vertices unmet.
 *
 * <p>A pair is one long, the count in the high bits and the {@link SecondCost} in the low ones. Two
 * pairs are added, or, where only the largest second cost matters, their counts are added and of
 * the second costs the larger is kept. Both keep the order, so that the best of a part is always
 * part of the best.
 *
 * <p>Where several apexes are equally good because the worst triangle is elsewhere, the one is
 * taken whose triangle and parts are the best otherwise; then the lowest.
 *
 * <p>Which chords there are is left to the kinds of table, as in {@link UnmetTable}: {@link
 * PreferredRegionTable} for few vertices, {@link PreferredPolygonTable} for many.
 */
abstract class PreferredTable extends ChordTable {
  static final long INFINITE = 1L << 61; // three of these still add up without overflow

  private final int[] costs; // by position and parity of triangles, as in UnmetTable
  final SecondCost second;
  private final boolean isLargest;
  private final long one; // a count of 1
  private final long high; // the bits of the count
  // Four entries a chord each, as in UnmetTable.
  private final long[] best;
  private final long[] closed;

  /**
   * An empty table.
   *
   * @param costs of positions, as in {@link UnmetTable}; all of them together at most their number
   * @param chords the number of chords at most
   */
  PreferredTable(int[] costs, SecondCost second, int chords) {
    this.costs = costs;
    this.second = second;
    isLargest = second.isLargest();
    one = 1L << second.bits();
    high = -one;
    best = new long[4 * chords];
    closed = new long[4 * chords];
  }

  // ---- filling

  /** Stores the entries of an edge of the polygon that ends at j. */
  final void storeSide(int j, int at, int closedAt) {
    store(j, at, closedAt, 0, INFINITE, INFINITE, INFINITE);
  }

  /** The apexes of one chord after the other, and the best of them; memory of one thread. */
  final class Apexes {
    final int[] apex;
    final int[] left; // by apex: where the entries of (i, k) are in closed
    final int[] right; // by apex: where those of (k, j) are in best
    int count;

    /** Room for so many apexes of a chord, and one more. */
    Apexes(int most) {
      apex = new int[most + 1];
      left = new int[most + 1];
      right = new int[most + 1];
    }

    /**
     * Stores the entries of the chord (i, j) with these apexes.
     *
     * @return whether there is a triangulation of its part
     */
    boolean storeBest(int i, int j, int at, int closedAt) {
      return isLargest ? storeLargest(i, j, at, closedAt) : storeSum(i, j, at, closedAt);
    }

    /** Long because it is the kernel. */
    private boolean storeSum(int i, int j, int at, int closedAt) {
      long m00 = INFINITE;
      long m01 = INFINITE;
      long m10 = INFINITE;
      long m11 = INFINITE;
      for (int c = 0; c < count; c++) {
        int g = left[c];
        int f = right[c];
        long g00 = closed[g];
        long g01 = closed[g + 1];
        long g10 = closed[g + 2];
        long g11 = closed[g + 3];
        long f00 = best[f];
        long f01 = best[f + 1];
        long f10 = best[f + 2];
        long f11 = best[f + 3];
        m00 = Math.min(m00, Math.min(g00 + f00, g01 + f10));
        m01 = Math.min(m01, Math.min(g00 + f01, g01 + f11));
        m10 = Math.min(m10, Math.min(g10 + f00, g11 + f10));
        m11 = Math.min(m11, Math.min(g10 + f01, g11 + f11));
      }
      long own = second.ofChord(i, j);
      return store(j, at, closedAt, m11 + own, m10 + own, m01 + own, m00 + own);
    }

    /**
     * Long because it is the kernel. A triangle is looked at only where its parts alone would be
     * better than the best so far.
     */
    private boolean storeLargest(int i, int j, int at, int closedAt) {
      long m00 = INFINITE;
      long m01 = INFINITE;
      long m10 = INFINITE;
      long m11 = INFINITE;
      for (int c = 0; c < count; c++) {
        int g = left[c];
        int f = right[c];
        long g00 = closed[g];
        long g01 = closed[g + 1];
        long g10 = closed[g + 2];
        long g11 = closed[g + 3];
        long f00 = best[f];
        long f01 = best[f + 1];
        long f10 = best[f + 2];
        long f11 = best[f + 3];
        long s00 = Math.min(joined(g00, f00), joined(g01, f10));
        long s01 = Math.min(joined(g00, f01), joined(g01, f11));
        long s10 = Math.min(joined(g10, f00), joined(g11, f10));
        long s11 = Math.min(joined(g10, f01), joined(g11, f11));
        if (s00 < m00 || s01 < m01 || s10 < m10 || s11 < m11) {
          long triangle = second.ofTriangle(i, apex[c], j);
          m00 = Math.min(m00, raised(s00, triangle));
          m01 = Math.min(m01, raised(s01, triangle));
          m10 = Math.min(m10, raised(s10, triangle));
          m11 = Math.min(m11, raised(s11, triangle));
        }
      }
      return store(j, at, closedAt, m11, m10, m01, m00);
    }
  }

  /** The counts added, and the larger of the second costs. */
  private long joined(long g, long f) {
    return Math.max(g + (f & high), f + (g & high));
  }

  /** The same count, and the larger of the second costs. */
  private long raised(long cost, long triangle) {
    return Math.max(cost, (cost & high) + triangle);
  }

  /** Stores the entries of a chord that ends at j; whether one of them is finite. */
  private boolean store(int j, int at, int closedAt, long f00, long f01, long f10, long f11) {
    best[at] = Math.min(INFINITE, f00);
    best[at + 1] = Math.min(INFINITE, f01);
    best[at + 2] = Math.min(INFINITE, f10);
    best[at + 3] = Math.min(INFINITE, f11);
    long even = costs[2 * j] * one;
    long odd = costs[2 * j + 1] * one;
    closed[closedAt] = Math.min(INFINITE, Math.min(f00 + odd, f01 + even));
    closed[closedAt + 1] = Math.min(INFINITE, Math.min(f00 + even, f01 + odd));
    closed[closedAt + 2] = Math.min(INFINITE, Math.min(f10 + odd, f11 + even));
    closed[closedAt + 3] = Math.min(INFINITE, Math.min(f10 + even, f11 + odd));
    return Math.min(Math.min(f00, f01), Math.min(f10, f11)) < INFINITE;
  }

  // ---- reading

  /** The fewest unmet vertices. */
  final int fewest() {
    return (int) (least() / one);
  }

  /** Where the entries of the chord (i, j) are in {@link #best}. */
  abstract int at(int i, int j);

  /** The lowest apex above {@code k} of a triangle on the chord (i, j), or j if there is none. */
  abstract int apexAfter(int k, int i, int j);

  @Override
  final int ends() {
    int ends = 0;
    for (int other = 1; other < 4; other++) {
      ends = total(other) < total(ends) ? other : ends;
    }
    return ends;
  }

  /** The cost of the whole polygon. */
  final long least() {
    return total(ends());
  }

  private long total(int ends) {
    int last = size() - 1;
    return best[at(0, last) + ends] + (costs[ends >> 1] + costs[2 * last + (ends & 1)]) * one;
  }

  @Override
  final int triangle(int i, int j, int ends) {
    long wanted = best[at(i, j) + ends];
    int found = -1;
    long[] least = {};
    for (int k = apexAfter(i, i, j); k < j; k = apexAfter(k, i, j)) {
      int left = at(i, k);
      int right = at(k, j);
      for (int rs = 0; rs < 4; rs++) {
        int leftEnds = 2 * (1 - (ends >> 1)) + (rs >> 1);
        int rightEnds = 2 * (rs & 1) + 1 - (ends & 1);
        long g = best[left + leftEnds] + one * costs[2 * k + (1 ^ (rs >> 1) ^ (rs & 1))];
        long f = best[right + rightEnds];
        if (cost(i, k, j, g, f) == wanted) {
          long[] others = isLargest ? seconds(i, k, j, g, f) : least;
          if (found < 0 || Arrays.compare(others, least) < 0) {
            found = 16 * k + 4 * leftEnds + rightEnds;
            least = others;
          }
        }
      }
    }
    return found;
  }

  /** The cost of so many unmet vertices with this second cost. */
  final long cost(int count, long secondCost) {
    return count * one + secondCost;
  }

  private long cost(int i, int k, int j, long g, long f) {
    return isLargest
        ? raised(joined(g, f), second.ofTriangle(i, k, j))
        : g + f + second.ofChord(i, j);
  }

  /** The second costs of a triangle and its two parts, the largest first. */
  private long[] seconds(int i, int k, int j, long g, long f) {
    long[] sorted = {second.ofTriangle(i, k, j), g & ~high, f & ~high};
    Arrays.sort(sorted);
    return new long[] {sorted[2], sorted[1], sorted[0]};
  }
}
