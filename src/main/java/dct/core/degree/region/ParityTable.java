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
 * The fewest unsatisfied vertices over all triangulations of a simple polygon, and a triangulation
 * that has them: a table over the pairs of vertices that see each other.
 *
 * <p>Let i &lt; j see each other, and let P(i, j) be the part of the polygon between the chord ij
 * and the boundary from i to j. For each parity p of the edges that P(i, j) puts at i, and q at j,
 * the chord itself not counted, the table holds the fewest unsatisfied vertices strictly between i
 * and j. With the apex k of the triangle on the chord,
 *
 * <pre>f(i, j)[1−p][1−q] = min over k, r, s of f(i, k)[p][r] + w(k, r+s) + f(k, j)[s][q]</pre>
 *
 * where w(k, r+s) is what that parity costs at k, 1 if it leaves k unsatisfied: k has besides the
 * chords ik and kj only the edges counted by r and s. An edge of the polygon has f[0][0] = 0 and no
 * other entry.
 *
 * <p>Time is the number of triangles that see through, at most n³/6, found by merging sorted lists;
 * memory 32 bytes a pair beside the 8 of the graph. The triangle of pairs is cut into blocks, and
 * the blocks of one anti-diagonal are computed in parallel. Ties go to the lowest apex.
 */
public final class ParityTable {
  private static final int INFINITE = 1 << 28; // three of these still add up without overflow
  private static final int BLOCKS = 24;

  private final VisibilityGraph graph;
  private final int[] wrong; // by position and parity of its degree: what that costs
  private final int[] noise; // by pair: what its chord costs; empty if nothing
  // Both hold four entries a pair; a loop over the apex runs through either in order.
  private final int[] best; // by slot: f(k, j)[s][q] at 2s + q
  private final int[] onward; // by pair: min over r of f(i, k)[p][r] + w(k, r + s) at 2p + s
  private final int n;

  private ParityTable(VisibilityGraph graph, int[] wrong, int[] noise) {
    this.graph = graph;
    this.wrong = wrong;
    this.noise = noise;
    n = graph.vertices();
    best = new int[4 * graph.pairs()];
    onward = new int[4 * graph.pairs()];
  }

  /**
   * Fills the table.
   *
   * @param wrong by position k, what it costs that the degree there is even, at 2k, or odd, at 2k +
   *     1
   * @param noise by pair, what its chord costs; or empty. All costs together stay below 2²⁸.
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static ParityTable fill(
      VisibilityGraph graph, int[] wrong, int[] noise, Progress progress) {
    ParityTable table = new ParityTable(graph, wrong, noise);
    table.fillBlocks(progress);
    return table;
  }

  /** The costs by which a table counts unsatisfied vertices, from the wish at each position. */
  public static int[] costs(ParityGoal.Wish[] wishes) {
    int[] wrong = new int[2 * wishes.length];
    for (int k = 0; k < wishes.length; k++) {
      wrong[2 * k] = wishes[k].isSatisfiedBy(0) ? 0 : 1;
      wrong[2 * k + 1] = wishes[k].isSatisfiedBy(1) ? 0 : 1;
    }
    return wrong;
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
    int chord = noise.length == 0 || j == i + 1 ? 0 : noise[pair];
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
        int g00 = onward[g];
        int g01 = onward[g + 1];
        int g10 = onward[g + 2];
        int g11 = onward[g + 3];
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
    store(mine, pair, j, m11 + chord, m10 + chord, m01 + chord, m00 + chord);
  }

  private void store(int slot, int pair, int j, int f00, int f01, int f10, int f11) {
    best[4 * slot] = Math.min(INFINITE, f00);
    best[4 * slot + 1] = Math.min(INFINITE, f01);
    best[4 * slot + 2] = Math.min(INFINITE, f10);
    best[4 * slot + 3] = Math.min(INFINITE, f11);
    int at = 4 * pair;
    int even = wrong[2 * j];
    int odd = wrong[2 * j + 1];
    onward[at] = Math.min(INFINITE, Math.min(f00 + even, f01 + odd));
    onward[at + 1] = Math.min(INFINITE, Math.min(f00 + odd, f01 + even));
    onward[at + 2] = Math.min(INFINITE, Math.min(f10 + even, f11 + odd));
    onward[at + 3] = Math.min(INFINITE, Math.min(f10 + odd, f11 + even));
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

  /** The least cost: the fewest unsatisfied vertices. */
  public int fewest() {
    int fewest = INFINITE;
    for (int parities = 0; parities < 4; parities++) {
      fewest = Math.min(fewest, total(parities));
    }
    return fewest;
  }

  /** The least cost with these parities at the ends of the last edge. */
  private int total(int parities) {
    return best(0, n - 1, parities)
        + wrong[1 - (parities >> 1)]
        + wrong[2 * n - 1 - (parities & 1)];
  }

  private int noiseOf(int i, int j) {
    return noise.length == 0 ? 0 : noise[firstPairFrom(i, j)];
  }

  private int best(int i, int j, int parities) {
    return best[4 * (firstSlotAfter(j, i) - 1) + parities];
  }

  /**
   * Cuts the face by the diagonals of a best triangulation.
   *
   * @param corner by position: the half-edge of the face that leaves the vertex there
   */
  public void cut(Dcel dcel, int[] corner) {
    int parities = 0;
    while (total(parities) != fewest()) {
      parities++;
    }
    List<Chord> waiting = new ArrayList<>();
    waiting.add(new Chord(0, n - 1, parities, corner[n - 1]));
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
   * @param parities those that the part puts at its ends, 2p + q
   * @param back the half-edge along the chord that leaves j, with the part on its left
   */
  private record Chord(int i, int j, int parities, int back) {}

  private void cutAtApex(Dcel dcel, int[] corner, Chord chord, List<Chord> waiting) {
    int i = chord.i;
    int j = chord.j;
    int p = 1 - (chord.parities >> 1);
    int q = 1 - (chord.parities & 1);
    int target = best(i, j, chord.parities) - noiseOf(i, j);
    for (int slot = firstSlotAfter(j, i); slot < graph.firstDown(j + 1); slot++) {
      int k = graph.low(slot);
      int left = firstSlotAfter(k, i) - 1;
      boolean seen = left >= graph.firstDown(k) && graph.low(left) == i;
      for (int rs = 0; seen && rs < 4; rs++) {
        int leftParities = 2 * p + (rs >> 1);
        int rightParities = 2 * (rs & 1) + q;
        int apex = wrong[2 * k + ((rs >> 1) ^ (rs & 1))];
        if (best[4 * left + leftParities] + apex + best[4 * slot + rightParities] == target) {
          int backLeft = k == i + 1 ? Dcel.NONE : dcel.splitFace(corner[i], corner[k]) ^ 1;
          int backRight = j == k + 1 ? Dcel.NONE : dcel.splitFace(corner[k], chord.back) ^ 1;
          waiting.add(new Chord(i, k, leftParities, backLeft));
          waiting.add(new Chord(k, j, rightParities, backRight));
          return;
        }
      }
    }
    throw new IllegalStateException("the table has no apex for its own value");
  }
}
