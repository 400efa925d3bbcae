package dct.core.degree.region;

/**
 * A {@link ChordTable} of costs that are small whole numbers.
 *
 * <p>Which chords there are, and how the apexes of each are found, is left to the kinds of table:
 * {@link RegionTable} for few vertices, {@link ParityTable} for many. Each has its own copy of the
 * loop over the apexes, since that is where all the time goes. Ties go to the lowest apex.
 */
abstract class UnmetTable extends ChordTable {
  static final int INFINITE = 1 << 28; // three of these still add up without overflow

  private final int[] costs;
  // Four entries a chord each; f[p][q] is at 2p + q.
  final int[] best; // f(k, j)
  final int[] closed; // at 2p + s: min over r of f(i, k)[p][r] + w(k, 1 + r + s)

  /**
   * An empty table.
   *
   * @param costs by position k, the cost of an even number of triangles there, at 2k, and of an odd
   *     one, at 2k + 1; read when the table is filled. All costs together stay below 2²⁸.
   * @param chords the number of chords at most
   */
  UnmetTable(int[] costs, int chords) {
    this.costs = costs;
    best = new int[4 * chords];
    closed = new int[4 * chords];
  }

  // ---- filling

  /**
   * Stores the entries of a chord that ends at j.
   *
   * @param at where they go in {@link #best}
   * @param closedAt where they go in {@link #closed}
   */
  final void store(int j, int at, int closedAt, int f00, int f01, int f10, int f11) {
    best[at] = Math.min(INFINITE, f00);
    best[at + 1] = Math.min(INFINITE, f01);
    best[at + 2] = Math.min(INFINITE, f10);
    best[at + 3] = Math.min(INFINITE, f11);
    int even = costs[2 * j];
    int odd = costs[2 * j + 1];
    closed[closedAt] = Math.min(INFINITE, Math.min(f00 + odd, f01 + even));
    closed[closedAt + 1] = Math.min(INFINITE, Math.min(f00 + even, f01 + odd));
    closed[closedAt + 2] = Math.min(INFINITE, Math.min(f10 + odd, f11 + even));
    closed[closedAt + 3] = Math.min(INFINITE, Math.min(f10 + even, f11 + odd));
  }

  // ---- reading

  /** Where the entries of the chord (i, j) are in {@link #best}. */
  abstract int at(int i, int j);

  /** What the chord (i, j) itself costs. */
  abstract int own(int i, int j);

  /** The lowest apex above {@code k} of a triangle on the chord (i, j), or j if there is none. */
  abstract int apexAfter(int k, int i, int j);

  /** The least cost of the whole polygon. */
  public final int fewest() {
    return total(ends());
  }

  @Override
  final int ends() {
    int ends = 0;
    for (int other = 1; other < 4; other++) {
      ends = total(other) < total(ends) ? other : ends;
    }
    return ends;
  }

  private int total(int ends) {
    int last = size() - 1;
    return best[at(0, last) + ends] + costs[ends >> 1] + costs[2 * last + (ends & 1)];
  }

  @Override
  final int triangle(int i, int j, int ends) {
    int wanted = best[at(i, j) + ends] - own(i, j);
    for (int k = apexAfter(i, i, j); k < j; k = apexAfter(k, i, j)) {
      int left = at(i, k);
      int right = at(k, j);
      for (int rs = 0; rs < 4; rs++) {
        int leftEnds = 2 * (1 - (ends >> 1)) + (rs >> 1);
        int rightEnds = 2 * (rs & 1) + 1 - (ends & 1);
        int apex = costs[2 * k + (1 ^ (rs >> 1) ^ (rs & 1))];
        if (best[left + leftEnds] + apex + best[right + rightEnds] == wanted) {
          return 16 * k + 4 * leftEnds + rightEnds;
        }
      }
    }
    throw new IllegalStateException("no triangle on chord " + i + ", " + j);
  }
}
