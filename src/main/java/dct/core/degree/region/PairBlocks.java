package dct.core.degree.region;

import dct.core.Progress;
import dct.core.triangulate.VisibilityGraph;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ForkJoinTask;
import java.util.concurrent.RecursiveAction;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;

/**
 * The order in which a table over the pairs of a {@link VisibilityGraph} is filled: each pair (i,
 * j) after all pairs within i … j. The triangle of pairs is cut into blocks, and the blocks of one
 * anti-diagonal are computed in parallel.
 */
final class PairBlocks {
  private static final int BLOCKS = 24;

  private final VisibilityGraph graph;
  private final Supplier<Filler> fillers;
  private final Progress progress;
  private final AtomicInteger done = new AtomicInteger();
  private final int blocks;

  /** What computes the entries of one pair from those within it. */
  @FunctionalInterface
  interface Filler {
    void fill(int i, int j, int pair);
  }

  private PairBlocks(VisibilityGraph graph, Supplier<Filler> fillers, Progress progress) {
    this.graph = graph;
    this.fillers = fillers;
    this.progress = progress;
    blocks = graph.vertices() < 16 * BLOCKS ? 1 : BLOCKS;
  }

  /**
   * Fills all pairs.
   *
   * @param fillers is asked once for each block, so that a filler may have memory of its own
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static void fill(VisibilityGraph graph, Supplier<Filler> fillers, Progress progress) {
    new PairBlocks(graph, fillers, progress).run();
  }

  private void run() {
    for (int distance = 0; distance < blocks; distance++) {
      List<Block> diagonal = new ArrayList<>();
      for (int b = 0; b + distance < blocks; b++) {
        diagonal.add(new Block(b, b + distance));
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

    Block(int row, int column) {
      rowStart = bound(row);
      rowEnd = bound(row + 1);
      columnStart = bound(column);
      columnEnd = bound(column + 1);
    }

    private int bound(int block) {
      return (int) ((long) graph.vertices() * block / blocks);
    }

    @Override
    protected void compute() {
      Filler filler = fillers.get();
      for (int i = rowEnd - 1; i >= rowStart; i--) {
        progress.checkCancelled();
        int end = graph.firstUp(i + 1);
        int pair = graph.pairFrom(i, columnStart);
        while (pair < end && graph.high(pair) < columnEnd) {
          filler.fill(i, graph.high(pair), pair);
          pair++;
        }
      }
      double fraction = done.incrementAndGet() / (blocks * (blocks + 1) / 2.0);
      progress.report(fraction, "Filling the table");
    }
  }
}
