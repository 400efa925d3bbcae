package dct.core.degree.region;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.degree.ParityGoal;
import dct.core.triangulate.VisibilityGraph;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.RecursiveAction;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * The {@link ChordTable} of a polygon of any size, over the pairs of vertices that see each other:
 * the fewest unmet vertices over all triangulations, and a triangulation that has them.
 *
 * <p>Time is the number of triangles that see through, at most n³/6, found by merging sorted lists;
 * memory 32 bytes a pair beside the 8 of the graph. The triangle of pairs is cut into blocks, and
 * the blocks of one anti-diagonal are computed in parallel.
 */
public final class ParityTable extends ChordTable {
  private static final int BLOCKS = 24;

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
    table.fillBlocks(progress);
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

  private void fillBlocks(Progress progress) {
    AtomicInteger done = new AtomicInteger();
    int blocks = n < 16 * BLOCKS ? 1 : BLOCKS;
    for (int distance = 0; distance < blocks; distance++) {
      List<Block> diagonal = new ArrayList<>();
      for (int b = 0; b + distance < blocks; b++) {
        diagonal.add(new Block(b, b + distance, blocks, done, progress));
      }
      ForkJoinTask.invokeAll(diagonal);
    }
  }

  /** The pairs (i, j) with i in one range of positions and j in another. */
  private final class Block extends RecursiveAction {
    private static final long serialVersionUID = 1L;
    private final int rowStart;
    private final int rowEnd;
    private final int columnStart;
    private final int columnEnd;
    private final int blocks;
    private final transient AtomicInteger done;
    private final transient Progress progress;

    Block(int row, int column, int blocks, AtomicInteger done, Progress progress) {
      rowStart = bound(row, blocks);
      rowEnd = bound(row + 1, blocks);
      columnStart = bound(column, blocks);
      columnEnd = bound(column + 1, blocks);
      this.blocks = blocks;
      this.done = done;
      this.progress = progress;
    }

    private int bound(int block, int count) {
      return (int) ((long) n * block / count);
    }

    @Override
    protected void compute() {
      for (int i = rowEnd - 1; i >= rowStart; i--) {
        progress.checkCancelled();
        int end = graph.firstUp(i + 1);
        int pair = firstPairFrom(i, columnStart);
        while (pair < end && graph.high(pair) < columnEnd) {
          fillPair(i, graph.high(pair), pair);
          pair++;
        }
      }
      double fraction = done.incrementAndGet() / (blocks * (blocks + 1) / 2.0);
      progress.report(fraction, "Filling the table");
    }
  }

  /** The first pair (i, j) with j at or after {@code from}. */
  private int firstPairFrom(int i, int from) {
    int lo = graph.firstUp(i);
    int hi = graph.firstUp(i + 1);
    while (lo < hi) {
      int middle = (lo + hi) >>> 1;
      if (graph.high(middle) < from) {
        lo = middle + 1;
      } else {
        hi = middle;
      }
    }
    return lo;
  }

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
    int slot = firstSlotAfter(j, i);
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

  /** The first slot (k, j) with k above i. */
  private int firstSlotAfter(int j, int i) {
    int lo = graph.firstDown(j);
    int hi = graph.firstDown(j + 1);
    while (lo < hi) {
      int middle = (lo + hi) >>> 1;
      if (graph.low(middle) <= i) {
        lo = middle + 1;
      } else {
        hi = middle;
      }
    }
    return lo;
  }

  // ---- reading

  @Override
  int size() {
    return n;
  }

  @Override
  int at(int i, int j) {
    return 4 * (firstSlotAfter(j, i) - 1);
  }

  @Override
  int own(int i, int j) {
    return noise.length == 0 ? 0 : noise[firstPairFrom(i, j)];
  }

  @Override
  int apexAfter(int k, int i, int j) {
    for (int slot = firstSlotAfter(j, k); slot < graph.firstDown(j + 1); slot++) {
      int apex = graph.low(slot);
      int left = firstSlotAfter(apex, i) - 1;
      if (left >= graph.firstDown(apex) && graph.low(left) == i) {
        return apex;
      }
    }
    return j;
  }

  /**
   * Cuts the face by the diagonals of a best triangulation.
   *
   * @param corner by position: the half-edge of the face that leaves the vertex there
   */
  public void cut(Dcel dcel, int[] corner) {
    List<Chord> waiting = new ArrayList<>();
    waiting.add(new Chord(0, n - 1, ends(), corner[n - 1]));
    while (!waiting.isEmpty()) {
      Chord chord = waiting.remove(waiting.size() - 1);
      if (chord.j > chord.i + 1) {
        cutAtApex(dcel, corner, chord, waiting);
      }
    }
  }

  /**
   * A chord whose part is still whole.
   *
   * @param i its lower position
   * @param j its higher position
   * @param ends the parities of the triangles of the part at its ends, 2p + q
   * @param back the half-edge along the chord that leaves j, with the part on its left
   */
  private record Chord(int i, int j, int ends, int back) {}

  private void cutAtApex(Dcel dcel, int[] corner, Chord chord, List<Chord> waiting) {
    int i = chord.i;
    int j = chord.j;
    int triangle = triangle(i, j, chord.ends);
    int k = triangle >> 4;
    int backLeft = k == i + 1 ? Dcel.NONE : dcel.splitFace(corner[i], corner[k]) ^ 1;
    int backRight = j == k + 1 ? Dcel.NONE : dcel.splitFace(corner[k], chord.back) ^ 1;
    waiting.add(new Chord(i, k, triangle >> 2 & 3, backLeft));
    waiting.add(new Chord(k, j, triangle & 3, backRight));
  }
}
