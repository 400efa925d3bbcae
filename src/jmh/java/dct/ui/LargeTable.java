package dct.ui;

import dct.core.triangulate.Domain;
import dct.experiment.generate.RandomSites;
import dct.ui.canvas.CanvasPanel;
import dct.ui.canvas.Links;
import dct.ui.document.BulkEdit;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Selection;
import dct.ui.session.Session;
import dct.ui.workbench.Workbench;
import java.awt.GridLayout;
import java.awt.event.MouseEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;

/**
 * What a window of 10⁶ sites costs the event thread: edits of 10,000 chosen ones with their
 * journal, and the mouse over two linked views. Prints the figures of docs/performance.md; needs a
 * screen.
 */
public final class LargeTable {
  private static final int SITES = 1_000_000;
  private static final int CHOSEN = 10_000;
  private static final int ROUNDS = 7;
  private static final int MOVES = 500;

  private final Path state;
  private final Session session;
  private final MainWindow window;
  private final Random random = new Random(1);

  private LargeTable() throws Exception {
    state = Files.createTempDirectory("large");
    session = Session.in(state);
    window = on(() -> new Windows(session).openWindow());
  }

  /** Prints the figures. */
  public static void main(String[] args) throws Exception {
    LargeTable table = new LargeTable();
    table.edits();
    table.links();
    System.exit(0);
  }

  private void edits() throws Exception {
    on(
        () -> {
          Workbench bench = window.workbench();
          bench.choose(Domain.SITES);
          bench.chooseEdit();
          bench
              .editor(Domain.SITES)
              .load(new Document(Domain.SITES, RandomSites.uniform(SITES, 1)), "random sites");
          return null;
        });
    settle();
    long begin = System.nanoTime();
    perform(() -> window.workbench().perform(Edit.move(document(), 5, 1.5, 2.5)));
    System.out.printf(Locale.ROOT, "first edit: event thread %.1f ms", millisSince(begin));
    begin = System.nanoTime();
    session.journals().await();
    System.out.printf(
        Locale.ROOT, ", journal %.0f ms, %,d bytes%n", millisSince(begin), journalBytes());
    settle();
    System.out.println("| edit | event thread: median ms | worst | journal: ms | bytes |");
    System.out.println("|---|---:|---:|---:|---:|");
    row("Move one site", () -> window.workbench().perform(Edit.move(document(), 5, x(), x())));
    row(
        "Move 10,000 sites",
        () -> {
          Selection which = window.workbench().selection();
          var places = RandomSites.uniform(which.count(), random.nextInt());
          window.workbench().perform(BulkEdit.move(document(), which, places));
        });
    for (String command : List.of("Delete Selection", "Cut", "Paste", "Duplicate", "Copy")) {
      row(command, () -> window.commands().get(command).perform());
    }
    row("Undo", () -> window.commands().get("Undo").perform());
    recovery();
  }

  private double x() {
    return 500 * random.nextDouble();
  }

  private Document document() {
    return window.workbench().document();
  }

  /** Each round selects other sites first, and is timed with all the events that follow at once. */
  private void row(String what, Runnable edit) throws Exception {
    double[] millis = new double[ROUNDS];
    double[] written = new double[ROUNDS];
    long bytes = 0;
    for (int k = 0; k < ROUNDS; k++) {
      on(
          () -> {
            window.workbench().select(chosen());
            return null;
          });
      settle();
      long before = journalBytes();
      long begin = System.nanoTime();
      millis[k] = perform(edit);
      session.journals().await();
      written[k] = millisSince(begin) - millis[k];
      settle();
      millis[k] = Math.max(millis[k], 0);
      bytes = journalBytes() - before;
    }
    Arrays.sort(millis);
    Arrays.sort(written);
    System.out.printf(
        Locale.ROOT,
        "| %s | %.0f | %.0f | %.0f | %,d |%n",
        what,
        millis[ROUNDS / 2],
        millis[ROUNDS - 1],
        written[ROUNDS / 2],
        bytes);
  }

  private Selection chosen() {
    BitSet set = new BitSet();
    while (set.cardinality() < CHOSEN) {
      set.set(random.nextInt(document().size()));
    }
    return Selection.of(set);
  }

  private static double perform(Runnable edit) throws Exception {
    double[] millis = {0};
    SwingUtilities.invokeAndWait(
        () -> {
          long begin = System.nanoTime();
          edit.run();
          millis[0] = millisSince(begin);
        });
    return millis[0];
  }

  private void recovery() throws Exception {
    Path copies = Files.createDirectories(state.resolve("copy").resolve("dct.journal"));
    session.journals().await();
    Files.copy(journal(), copies.resolve("a.journal"));
    long begin = System.nanoTime();
    int sites =
        Session.in(state.resolve("copy")).journals().orphans(unread -> {}).get(0).document().size();
    System.out.printf(
        Locale.ROOT,
        "recovery of %,d sites from %,d bytes: %.0f ms%n",
        sites,
        Files.size(copies.resolve("a.journal")),
        millisSince(begin));
  }

  private Path journal() throws IOException {
    try (Stream<Path> files = Files.list(state.resolve("dct.journal"))) {
      return files.filter(f -> f.toString().endsWith(".journal")).findFirst().orElseThrow();
    }
  }

  private long journalBytes() throws Exception {
    session.journals().await();
    return Files.isDirectory(state.resolve("dct.journal")) ? Files.size(journal()) : 0;
  }

  private void settle() throws Exception {
    while (!on(() -> window.workbench().jobs().isIdle())) {
      Thread.sleep(20);
    }
    session.journals().await();
  }

  /** The mouse moves over one of two views, each with its own points. */
  private void links() throws Exception {
    Links links = new Links();
    CanvasPanel[] views = {new CanvasPanel(), new CanvasPanel()};
    on(
        () -> {
          JFrame frame = new JFrame();
          frame.setLayout(new GridLayout(1, 2));
          for (CanvasPanel view : views) {
            view.setScene(window.workbench().shown().scene());
            links.add(view);
            frame.add(view);
          }
          frame.setSize(1200, 700);
          frame.setVisible(true);
          views[0].fit();
          views[0].zoom(8, 300, 350);
          return null;
        });
    Thread.sleep(3000); // the pictures are drawn
    double[] millis = new double[MOVES];
    for (int k = 0; k < MOVES; k++) {
      int x = 50 + random.nextInt(400);
      int y = 50 + random.nextInt(500);
      long begin = System.nanoTime();
      on(
          () -> {
            views[0].dispatchEvent(
                new MouseEvent(views[0], MouseEvent.MOUSE_MOVED, 0, 0, x, y, 0, false));
            return null;
          });
      on(() -> null); // what was asked to be painted is
      millis[k] = millisSince(begin);
    }
    Arrays.sort(millis);
    System.out.printf(
        Locale.ROOT,
        "linked hover: median %.1f ms, worst %.1f ms of %d moves%n",
        millis[MOVES / 2],
        millis[MOVES - 1],
        MOVES);
  }

  private static double millisSince(long nanos) {
    return (System.nanoTime() - nanos) / 1e6;
  }

  private static <T> T on(Callable<T> action) throws Exception {
    var task = new java.util.concurrent.FutureTask<>(action);
    SwingUtilities.invokeLater(task);
    return task.get();
  }
}
