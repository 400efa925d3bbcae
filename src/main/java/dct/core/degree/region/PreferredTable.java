package dct.core.degree.region;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.Preference;
import dct.core.geometry.Points;
import dct.core.triangulate.VisibilityGraph;
import java.util.Arrays;
import java.util.stream.IntStream;

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
 * <p>Takes the same steps as {@link ParityTable}; memory 64 bytes a pair beside the 8 of the graph.
 */
public final class PreferredTable extends ChordTable {
  private static final long INFINITE = 1L << 61; // three of these still add up without overflow
  private static final int COUNT_END = 60; // counts end below this bit

  private final VisibilityGraph graph;
  private final SecondCost second;
  private final boolean isLargest;
  private final int n;
  private final int mostApexes;
  private final long one; // a count of 1
  private final long high; // the bits of the count
  private final long[] costs; // by position and parity of triangles, as in UnmetTable
  private final long[] best; // by slot: f(k, j)
  private final long[] closed; // by pair, as in UnmetTable

  private PreferredTable(
      VisibilityGraph graph,
      ParityGoal.Wish[] wishes,
      Preference preference,
      Points points,
      int[] vertex) {
    this.graph = graph;
    n = graph.vertices();
    int bits = COUNT_END - Integer.SIZE + Integer.numberOfLeadingZeros(n);
    one = 1L << bits;
    high = -one;
    second = new SecondCost(preference, points, vertex, bits);
    isLargest = second.isLargest();
    int[] counts = ParityTable.costs(wishes);
    costs = new long[counts.length];
    for (int i = 0; i < counts.length; i++) {
      costs[i] = counts[i] * one;
    }
    mostApexes =
        IntStream.range(0, n).map(i -> graph.firstUp(i + 1) - graph.firstUp(i)).max().orElse(0);
    best = new long[4 * graph.pairs()];
    closed = new long[4 * graph.pairs()];
  }

  /**
   * Fills the table.
   *
   * @param wishes by position
   * @param vertex by position: its number among the points
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static PreferredTable fill(
      VisibilityGraph graph,
      ParityGoal.Wish[] wishes,
      Preference preference,
      Points points,
      int[] vertex,
      Progress progress) {
    PreferredTable table = new PreferredTable(graph, wishes, preference, points, vertex);
    PairBlocks.fill(graph, () -> table.new Filler(), progress);
    return table;
  }

  // ---- filling

  /** Fills one pair after the other, with memory of its own for the apexes. */
  private final class Filler implements PairBlocks.Filler {
    private final int[] apex = new int[mostApexes + 1];
    private final int[] left = new int[mostApexes + 1]; // where the entries of (i, k) are in closed
    private final int[] right = new int[mostApexes + 1]; // where those of (k, j) are in best
    private long m00;
    private long m01;
    private long m10;
    private long m11;

    @Override
    public void fill(int i, int j, int pair) {
      int slot = graph.slotAfter(j, i);
      m00 = INFINITE;
      m01 = INFINITE;
      m10 = INFINITE;
      m11 = INFINITE;
      if (j == i + 1) {
        store(j, 4 * (slot - 1), 4 * pair, 0, INFINITE, INFINITE, INFINITE);
        return;
      }
      int count = findApexes(graph.firstUp(i), pair, slot, graph.firstDown(j + 1));
      long own = 0;
      if (isLargest) {
        takeLargest(i, j, count);
      } else {
        takeSums(count);
        own = second.ofChord(i, j);
      }
      store(j, 4 * (slot - 1), 4 * pair, m11 + own, m10 + own, m01 + own, m00 + own);
    }

    /** Merges two sorted lists, without a branch that cannot be foretold. */
    private int findApexes(int upStart, int upEnd, int slotStart, int slotEnd) {
      int up = upStart;
      int slot = slotStart;
      int count = 0;
      while (up < upEnd && slot < slotEnd) {
        int k = graph.high(up);
        int other = graph.low(slot);
        apex[count] = k;
        left[count] = 4 * up;
        right[count] = 4 * slot;
        count += k == other ? 1 : 0;
        up += k <= other ? 1 : 0;
        slot += other <= k ? 1 : 0;
      }
      return count;
    }

    private void takeSums(int count) {
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
    }

    /** A triangle is looked at only where its parts alone would be better than the best so far. */
    private void takeLargest(int i, int j, int count) {
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

  private void store(int j, int at, int closedAt, long f00, long f01, long f10, long f11) {
    best[at] = Math.min(INFINITE, f00);
    best[at + 1] = Math.min(INFINITE, f01);
    best[at + 2] = Math.min(INFINITE, f10);
    best[at + 3] = Math.min(INFINITE, f11);
    long even = costs[2 * j];
    long odd = costs[2 * j + 1];
    closed[closedAt] = Math.min(INFINITE, Math.min(f00 + odd, f01 + even));
    closed[closedAt + 1] = Math.min(INFINITE, Math.min(f00 + even, f01 + odd));
    closed[closedAt + 2] = Math.min(INFINITE, Math.min(f10 + odd, f11 + even));
    closed[closedAt + 3] = Math.min(INFINITE, Math.min(f10 + even, f11 + odd));
  }

  // ---- reading

  /** The fewest unmet vertices. */
  public int fewest() {
    return (int) (total(ends()) / one);
  }

  @Override
  int size() {
    return n;
  }

  @Override
  int ends() {
    int ends = 0;
    for (int other = 1; other < 4; other++) {
      ends = total(other) < total(ends) ? other : ends;
    }
    return ends;
  }

  private long total(int ends) {
    return best[at(0, n - 1) + ends] + costs[ends >> 1] + costs[2 * (n - 1) + (ends & 1)];
  }

  private int at(int i, int j) {
    return 4 * (graph.slotAfter(j, i) - 1);
  }

  @Override
  int triangle(int i, int j, int ends) {
    long wanted = best[at(i, j) + ends];
    int found = -1;
    long[] least = {};
    for (int k = graph.commonAfter(i, i, j); k < j; k = graph.commonAfter(k, i, j)) {
      int left = at(i, k);
      int right = at(k, j);
      for (int rs = 0; rs < 4; rs++) {
        int leftEnds = 2 * (1 - (ends >> 1)) + (rs >> 1);
        int rightEnds = 2 * (rs & 1) + 1 - (ends & 1);
        long g = best[left + leftEnds] + costs[2 * k + (1 ^ (rs >> 1) ^ (rs & 1))];
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
