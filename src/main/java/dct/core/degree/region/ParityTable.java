package dct.core.degree.region;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.triangulate.VisibilityGraph;

/**
 * The {@link ChordTable} of a polygon of any size, over the pairs of vertices that see each other:
 * the fewest unmet vertices over all triangulations, and a triangulation that has them.
 *
 * <p>Time is the number of triangles that see through, at most n³/6, found by merging sorted lists;
 * memory 32 bytes a pair beside the 8 of the graph.
 */
public final class ParityTable extends UnmetTable {
  private final VisibilityGraph graph;
  private final int[] noise; // by pair: what its chord costs; empty if nothing
  private final int n;

  private ParityTable(VisibilityGraph graph, int[] costs, int[] noise) {
    super(costs, graph.pairs());
    this.graph = graph;
    this.noise = noise;
    n = graph.vertices();
  }

  /**
   * Fills the table.
   *
   * @param costs by position k, the cost of an even number of triangles there, at 2k, and of an odd
   *     one, at 2k + 1
   * @param noise by pair, what its chord costs; or empty. All costs together stay below 2²⁸.
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static ParityTable fill(
      VisibilityGraph graph, int[] costs, int[] noise, Progress progress) {
    ParityTable table = new ParityTable(graph, costs, noise);
    PairBlocks.fill(graph, () -> table::fillPair, progress);
    return table;
  }

  /** The costs by which a table counts unmet vertices, from the wish at each position. */
  public static int[] costs(ParityGoal.Wish[] wishes) {
    int[] costs = new int[2 * wishes.length];
    for (int k = 0; k < wishes.length; k++) {
      costs[2 * k] = wishes[k].isGrantedBy(1) ? 0 : 1; // one edge more than triangles
      costs[2 * k + 1] = wishes[k].isGrantedBy(0) ? 0 : 1;
    }
    return costs;
  }

  /** How many steps {@link #fill} will take: an upper bound on the triangles that see through. */
  public static long steps(VisibilityGraph graph) {
    long steps = 0;
    for (int i = 0; i < graph.vertices(); i++) {
      long up = (long) graph.firstUp(i + 1) - graph.firstUp(i);
      long down = (long) graph.firstDown(i + 1) - graph.firstDown(i);
      steps += up * up / 2 + down * down / 2;
    }
    return steps;
  }

  // ---- filling

  /** Long because it is the kernel: its loop runs once for each triangle that sees through. */
  private void fillPair(int i, int j, int pair) {
    int m00 = INFINITE;
    int m01 = INFINITE;
    int m10 = INFINITE;
    int m11 = INFINITE;
    if (j == i + 1) {
      m11 = 0; // stored as f[0][0] below
    }
    int own = noise.length == 0 || j == i + 1 ? 0 : noise[pair];
    int up = graph.firstUp(i);
    int slot = graph.slotAfter(j, i);
    int mine = slot - 1;
    int slotEnd = graph.firstDown(j + 1);
    while (up < pair && slot < slotEnd) {
      int k = graph.high(up);
      int other = graph.low(slot);
      if (k < other) {
        up++;
      } else if (k > other) {
        slot++;
      } else {
        int g = 4 * up++;
        int f = 4 * slot++;
        int g00 = closed[g];
        int g01 = closed[g + 1];
        int g10 = closed[g + 2];
        int g11 = closed[g + 3];
        int f00 = best[f];
        int f01 = best[f + 1];
        int f10 = best[f + 2];
        int f11 = best[f + 3];
        m00 = Math.min(m00, Math.min(g00 + f00, g01 + f10));
        m01 = Math.min(m01, Math.min(g00 + f01, g01 + f11));
        m10 = Math.min(m10, Math.min(g10 + f00, g11 + f10));
        m11 = Math.min(m11, Math.min(g10 + f01, g11 + f11));
      }
    }
    store(j, 4 * mine, 4 * pair, m11 + own, m10 + own, m01 + own, m00 + own);
  }

  // ---- reading

  @Override
  int size() {
    return n;
  }

  @Override
  int at(int i, int j) {
    return 4 * (graph.slotAfter(j, i) - 1);
  }

  @Override
  int own(int i, int j) {
    return noise.length == 0 ? 0 : noise[graph.pairFrom(i, j)];
  }

  @Override
  int apexAfter(int k, int i, int j) {
    return graph.commonAfter(k, i, j);
  }
}
