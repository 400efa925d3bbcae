package dct.ui.document;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.SimplicityCheck;
import dct.core.triangulate.Domain;
import dct.experiment.generate.PolygonShape;
import dct.ui.job.Jobs;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import javax.swing.SwingUtilities;

/**
 * Prints how long it takes from a move of a polygon's vertex to the live triangulation of the new
 * place, by the most even vertices. Moves that would leave the polygon not simple are left out.
 */
public final class LiveTable {
  private static final int MOVES = 200;
  private static final int WARM_UP = 100;
  private static final int STEP = 3;
  private static final double NANOS = 1e6;

  private final Jobs jobs = new Jobs();
  private final Editor editor = new Editor(Domain.POLYGON, jobs);
  private final Points start;
  private int proven;

  private LiveTable(int n) {
    start = PolygonShape.TWO_OPT.generate(n, 5).points();
  }

  /** Prints the table. */
  public static void main(String[] args) throws Exception {
    System.out.println("| vertices | median ms | worst ms | moves a second | proven |");
    System.out.println("|---:|---:|---:|---:|---:|");
    for (int n : new int[] {100, 400, 1000, 2000}) {
      new LiveTable(n).measure();
    }
    System.exit(0);
  }

  private void measure() throws Exception {
    SwingUtilities.invokeAndWait(
        () -> {
          editor.load(new Document(Domain.POLYGON, start), "polygon", Optional.empty());
          editor.setLive(Optional.of(LiveMethod.MOST_EVEN));
        });
    double[] millis = new double[MOVES];
    for (int k = -WARM_UP; k < MOVES; k++) {
      proven = k == 0 ? 0 : proven;
      double taken = move(k + WARM_UP);
      if (k >= 0) {
        millis[k] = taken;
      }
    }
    Arrays.sort(millis);
    double sum = Arrays.stream(millis).sum();
    System.out.printf(
        Locale.ROOT,
        "| %,d | %.1f | %.1f | %.0f | %d %% |%n",
        start.size(),
        millis[MOVES / 2],
        millis[MOVES - 1],
        1000 * MOVES / sum,
        100 * proven / MOVES);
  }

  /** Moves a vertex a little, and waits until what is shown is of its new place. */
  private double move(int k) throws Exception {
    Points moved = moved(k);
    long begin = System.nanoTime();
    SwingUtilities.invokeAndWait(() -> editor.preview(moved));
    boolean[] there = {false};
    while (!there[0]) {
      SwingUtilities.invokeAndWait(
          () ->
              there[0] =
                  editor.shown().solution().isPresent()
                      && editor.shown().document().points().equals(moved));
    }
    double millis = (System.nanoTime() - begin) / NANOS;
    proven += editor.shown().solution().orElseThrow().isProven() ? 1 : 0;
    return millis;
  }

  private Points moved(int k) {
    for (int v = k % start.size(); ; v = (v + 1) % start.size()) {
      Points moved = start.moved(v, start.x(v) + STEP * (k % 2 == 0 ? 1 : -1), start.y(v) + STEP);
      if (SimplicityCheck.firstDefect(moved, Progress.NONE).isEmpty()) {
        return moved;
      }
    }
  }
}
