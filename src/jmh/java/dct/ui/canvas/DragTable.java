package dct.ui.canvas;

import dct.core.geometry.Box;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.generate.RandomSites;
import dct.render.Scene;
import dct.render.ScenePainter;
import dct.render.Theme;
import dct.render.Viewport;
import dct.ui.document.Document;
import dct.ui.document.Editor;
import dct.ui.job.Jobs;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.concurrent.Executors;
import javax.swing.SwingUtilities;

/**
 * How long a site that is dragged takes to be shown: prints the table of docs/performance.md. One
 * of many random sites is moved as the mouse would move it; each move goes through the editor and
 * is painted as the canvas paints it, on the event thread.
 */
public final class DragTable {
  private static final Dimension CANVAS =
      new Dimension(CanvasPanel.WIDTH_AT_FIRST, CanvasPanel.HEIGHT_AT_FIRST);
  private static final int WARM_UP = 100;
  private static final int MOVES = 300;
  private static final double STEP = 40; // pixels that the mouse moves at most at once, by axis

  private final Jobs jobs = new Jobs();
  private final Editor editor = new Editor(Domain.SITES, jobs);
  private final BufferedImage screen =
      new BufferedImage(CANVAS.width, CANVAS.height, BufferedImage.TYPE_INT_RGB);
  private final Random random = new Random(1);
  private int queued; // drawings in the background
  private int ended;
  private final SceneImage image;

  private DragTable() {
    var thread = Executors.newSingleThreadExecutor(DragTable::daemon);
    image =
        new SceneImage(
            () -> ended++,
            work -> {
              queued++;
              thread.execute(work);
            });
  }

  private static Thread daemon(Runnable work) {
    Thread thread = new Thread(work, "canvas");
    thread.setDaemon(true);
    return thread;
  }

  /** Measures for these numbers of sites, or for 10⁵ and 10⁶. */
  public static void main(String[] args) throws Exception {
    List<Integer> sizes =
        args.length == 0
            ? List.of(100_000, 1_000_000)
            : Arrays.stream(args).map(Integer::valueOf).toList();
    System.out.println(
        "| sites | site | zoom | shown: median | worst | whole: median | worst | at once |");
    System.out.println("|---:|---|---:|---:|---:|---:|---:|---:|");
    for (int n : sizes) {
      new DragTable().measure(RandomSites.uniform(n, 1));
    }
  }

  private void measure(Points sites) throws Exception {
    SwingUtilities.invokeAndWait(
        () -> editor.load(new Document(Domain.SITES, sites), "random sites"));
    awaitAnalysis();
    for (boolean hull : new boolean[] {false, true}) {
      int site = site(sites, hull);
      for (double zoom : new double[] {1, 8, 64}) {
        measure(site, hull ? "on the hull" : "inner", zoom);
      }
    }
  }

  private void awaitAnalysis() throws Exception {
    boolean[] whole = {false};
    while (!whole[0]) {
      Thread.sleep(10);
      SwingUtilities.invokeAndWait(() -> whole[0] = editor.shown().solution().isPresent());
    }
  }

  /** A site in the middle, or the outermost one on the right. */
  private static int site(Points sites, boolean hull) {
    Box box = Box.of(sites);
    double x = hull ? box.maxX() : box.centerX();
    int best = 0;
    for (int v = 1; v < sites.size(); v++) {
      if (distance(sites, v, x, box.centerY()) < distance(sites, best, x, box.centerY())) {
        best = v;
      }
    }
    return best;
  }

  private static double distance(Points sites, int v, double x, double y) {
    return Math.hypot(sites.x(v) - x, sites.y(v) - y);
  }

  private void measure(int site, String what, double zoom) throws Exception {
    Points start = editor.document().points();
    Scene scene = editor.shown().scene();
    Viewport fitted = ScenePainter.fitted(scene, CANVAS.width, CANVAS.height, false);
    double x = fitted.screenX(start.x(site));
    double y = fitted.screenY(start.y(site));
    Viewport view =
        zoom == 1
            ? fitted
            : fitted.zoomed(zoom, x, y).panned(CANVAS.width / 2.0 - x, CANVAS.height / 2.0 - y);
    SwingUtilities.invokeAndWait(() -> paint(view));
    awaitPicture(view);
    double[] shown = new double[MOVES];
    double[] whole = new double[MOVES];
    int atOnce = 0;
    for (int move = -WARM_UP; move < MOVES; move++) {
      double px = view.screenX(start.x(site)) + STEP * (2 * random.nextDouble() - 1);
      double py = view.screenY(start.y(site)) + STEP * (2 * random.nextDouble() - 1);
      long begin = System.nanoTime();
      SwingUtilities.invokeAndWait(
          () -> {
            editor.preview(start.moved(site, view.modelX(px), view.modelY(py)));
            paint(view);
          });
      double first = millisSince(begin);
      boolean complete = queued == ended;
      awaitPicture(view);
      if (move >= 0) {
        shown[move] = first;
        whole[move] = complete ? first : millisSince(begin);
        atOnce += complete ? 1 : 0;
      }
    }
    SwingUtilities.invokeAndWait(editor::endPreview);
    print(start.size(), what, zoom, shown, whole, atOnce);
  }

  private static double millisSince(long nanos) {
    return (System.nanoTime() - nanos) / 1e6;
  }

  private void paint(Viewport view) {
    Graphics2D graphics = screen.createGraphics();
    image.paint(graphics, new View(editor.shown().scene(), view, Theme.LIGHT, CANVAS, 1));
    graphics.dispose();
  }

  /** Waits until nothing is drawn in the background, and paints what was. */
  private void awaitPicture(Viewport view) throws Exception {
    boolean[] done = {false};
    while (!done[0]) {
      SwingUtilities.invokeAndWait(
          () -> {
            if (queued == ended) {
              done[0] = true;
              paint(view);
              done[0] &= queued == ended;
            }
          });
      if (!done[0]) {
        Thread.sleep(1);
      }
    }
  }

  private static void print(
      int n, String what, double zoom, double[] shown, double[] whole, int atOnce) {
    Arrays.sort(shown);
    Arrays.sort(whole);
    System.out.printf(
        Locale.ROOT,
        "| %,d | %s | %.0f × | %.1f | %.1f | %.1f | %.1f | %d %% |%n",
        n,
        what,
        zoom,
        shown[MOVES / 2],
        shown[MOVES - 1],
        whole[MOVES / 2],
        whole[MOVES - 1],
        100 * atOnce / MOVES);
  }
}
