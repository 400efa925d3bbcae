package dct.ui.canvas;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.core.geometry.SimplicityCheck;
import dct.core.triangulate.Domain;
import dct.experiment.generate.PolygonShape;
import dct.render.Scene;
import dct.render.ScenePainter;
import dct.render.Theme;
import dct.render.Viewport;
import dct.ui.document.Document;
import dct.ui.document.Editor;
import dct.ui.document.LiveMethod;
import dct.ui.job.Jobs;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.SwingUtilities;

/**
 * How long it takes from a move of a polygon's vertex to the picture of the proven optimum of the
 * new place: prints the table of docs/performance.md. Each move goes through the editor and is
 * painted as the canvas paints it. Moves that would leave the polygon not simple are left out.
 */
public final class LiveTable {
  private static final Dimension CANVAS =
      new Dimension(CanvasPanel.WIDTH_AT_FIRST, CanvasPanel.HEIGHT_AT_FIRST);
  private static final int[] SIZES = {100, 400, 1000, 2000};
  private static final int MOVES = 200;
  private static final int WARM_UP = 100;
  private static final int STEP = 3;
  private static final double NANOS = 1e6;

  private final Jobs jobs = new Jobs();
  private final Editor editor = new Editor(Domain.POLYGON, jobs);
  private final BufferedImage screen =
      new BufferedImage(CANVAS.width, CANVAS.height, BufferedImage.TYPE_INT_RGB);
  private final SceneImage image = new SceneImage(() -> {});
  private final PolygonShape shape;
  private final Points start;
  private final Viewport view;
  private int proven;

  private LiveTable(PolygonShape shape, int n) {
    this.shape = shape;
    start = shape.generate(n, 5).points();
    Scene scene = Scene.outline(Rings.ofChain(start), false, List.of());
    view = ScenePainter.fitted(scene, CANVAS.width, CANVAS.height, false);
  }

  /** Prints the table. */
  public static void main(String[] args) throws Exception {
    System.out.println("| polygon | vertices | median ms | worst ms | moves a second | proven |");
    System.out.println("|---|---:|---:|---:|---:|---:|");
    for (PolygonShape shape :
        List.of(
            PolygonShape.TWO_OPT,
            PolygonShape.SPACE_PARTITIONING,
            PolygonShape.STAR_SHAPED,
            PolygonShape.CONVEX)) {
      for (int n : SIZES) {
        new LiveTable(shape, n).measure();
      }
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
        "| %s | %,d | %.1f | %.1f | %.0f | %d %% |%n",
        shape.title(),
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
      SwingUtilities.invokeAndWait(() -> there[0] = isShown(moved));
    }
    double millis = (System.nanoTime() - begin) / NANOS;
    proven += editor.shown().solution().orElseThrow().isProven() ? 1 : 0;
    return millis;
  }

  /** Paints, if what is known is of these points. */
  private boolean isShown(Points moved) {
    boolean follows =
        editor.shown().solution().isPresent() && editor.shown().document().points().equals(moved);
    if (follows) {
      Graphics2D graphics = screen.createGraphics();
      image.paint(graphics, new View(editor.shown().scene(), view, Theme.LIGHT, CANVAS, 1));
      graphics.dispose();
    }
    return follows;
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
