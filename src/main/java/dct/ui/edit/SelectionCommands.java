package dct.ui.edit;

import dct.core.Decimals;
import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Domain;
import dct.io.PointFile;
import dct.io.format.Choice;
import dct.io.format.UnclearInput;
import dct.ui.command.CommandRegistry;
import dct.ui.dialog.Found;
import dct.ui.dialog.WhatIsMeant;
import dct.ui.document.BulkEdit;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Selection;
import dct.ui.tool.Snap;
import dct.ui.tool.Spot;
import dct.ui.vertices.RowsText;
import dct.ui.workbench.Workbench;
import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;

/**
 * The commands for the vertices that are selected. The clipboard holds a line "x y" for each.
 *
 * <p>What is pasted or duplicated comes behind the last selected vertex, or last if none is; new
 * sites always come last. Copies that would lie on vertices which are there are moved aside
 * together, by the size of the grid if that is on.
 */
public final class SelectionCommands {
  private static final String CLIPBOARD = "the clipboard";
  private static final String IPE = "<ipeselection";
  private static final int ASIDE = 20; // steps of an arrow key
  private static final int TRIES = 100;
  private static final int MOST_WORK = 3_000_000; // vertices looked at in all tries: 30 ms

  private final Workbench workbench;

  private SelectionCommands(Workbench workbench) {
    this.workbench = workbench;
  }

  /** Offers the commands for the documents of the workbench. */
  public static void offer(CommandRegistry commands, Workbench workbench) {
    new SelectionCommands(workbench).offer(commands);
  }

  private void offer(CommandRegistry commands) {
    commands
        .add("Cut", "ctrl X", "Puts the selected vertices on the clipboard alone", this::cut)
        .enabledWhen(this::isAnySelected);
    commands
        .add("Copy", "ctrl C", "Copies the coordinates of the selected vertices", this::copy)
        .enabledWhen(this::isAnySelected);
    commands
        .add("Paste", "ctrl V", "Adds the vertices whose coordinates were copied", this::paste)
        .enabledWhen(() -> workbench.domain().isPresent());
    commands
        .add("Duplicate", "ctrl shift D", "Adds the selected vertices again", this::duplicate)
        .enabledWhen(this::isAnySelected);
    commands
        .add("Delete Selection", "DELETE", "Removes the selected vertices", () -> delete("Delete"))
        .alsoOn("BACK_SPACE")
        .enabledWhen(this::isAnySelected);
    commands
        .add("Select All", "ctrl A", "Selects every vertex", this::selectAll)
        .enabledWhen(() -> workbench.domain().isPresent());
  }

  private boolean isAnySelected() {
    return workbench.active().filter(editor -> !editor.selection().isEmpty()).isPresent();
  }

  private void selectAll() {
    workbench.chooseEdit();
    workbench.select(Selection.range(0, workbench.document().size()));
  }

  private void cut() {
    copy();
    delete("Cut");
  }

  private void delete(String what) {
    Document document = workbench.document();
    Selection which = workbench.selection();
    boolean one = which.count() == 1 && "Delete".equals(what);
    workbench.perform(
        one ? Edit.delete(document, which.next(0)) : BulkEdit.delete(what, document, which));
    workbench.select(Selection.NONE);
  }

  private void copy() {
    Points points = workbench.selection().of(workbench.document().points());
    Toolkit.getDefaultToolkit()
        .getSystemClipboard()
        .setContents(new RowsText(() -> text(points)), null);
    workbench.say("Copied " + words(points.size()));
  }

  private String words(int count) {
    return BulkEdit.words(count, workbench.document().domain()).toLowerCase(java.util.Locale.ROOT);
  }

  private static String text(Points points) {
    StringBuilder text = new StringBuilder();
    for (int k = 0; k < points.size(); k++) {
      Decimals.append(text, points.x(k));
      text.append(' ');
      Decimals.append(text, points.y(k));
      text.append('\n');
    }
    return text.toString();
  }

  private void paste() {
    Optional<String> text = clipboard();
    if (text.isEmpty()) {
      workbench.say("The clipboard holds no text; copy lines “x y” first");
      return;
    }
    paste(text.get(), Choice.NONE.as(workbench.document().domain()));
  }

  private void paste(String text, Choice choice) {
    Domain domain = workbench.document().domain();
    boolean turned = text.stripLeading().startsWith(IPE) && !workbench.viewport().yUp();
    workbench
        .jobs()
        .read(
            "Pasting",
            progress -> Found.by(() -> distinct(parse(text, choice, turned), domain, progress)),
            found ->
                found.handOn(
                    points -> paste(points, domain), unclear -> choose(text, choice, unclear)));
  }

  private static Points distinct(Points points, Domain domain, Progress progress) {
    return domain == Domain.SITES ? Sites.of(points, progress).points() : points;
  }

  private void paste(Points points, Domain domain) {
    if (workbench.isChosen(domain)) {
      insert("Paste", points, ParityGoal.allEven(points.size()), 0);
    }
  }

  private void choose(String text, Choice choice, UnclearInput unclear) {
    Component over = KeyboardFocusManager.getCurrentKeyboardFocusManager().getActiveWindow();
    WhatIsMeant.ask(over, "Paste", unclear, choice).ifPresent(chosen -> paste(text, chosen));
  }

  private static Optional<String> clipboard() {
    try {
      return Optional.of(
          (String)
              Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor));
    } catch (UnsupportedFlavorException | IOException | IllegalStateException e) {
      return Optional.empty(); // it holds something else, or another program has hold of it
    }
  }

  /** The points of a text; a drawing of Ipe looks as it does there if it is turned. */
  private static Points parse(String text, Choice choice, boolean turned) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    try {
      Points read = PointFile.read(CLIPBOARD, new ByteArrayInputStream(bytes), choice).points();
      return turned ? Points.of(read.xs(), Arrays.stream(read.ys()).map(y -> -y).toArray()) : read;
    } catch (IOException e) {
      throw new UncheckedIOException(e); // an array has no errors
    }
  }

  private void duplicate() {
    Document document = workbench.document();
    Selection which = workbench.selection();
    insert("Duplicate", which.of(document.points()), BulkEdit.wishes(document, which), 1);
  }

  private void insert(String what, Points points, ParityGoal wishes, int steps) {
    if (points.size() == 0) {
      workbench.say("There are no points on the clipboard");
      return;
    }
    Document document = workbench.document();
    boolean atEnd = document.domain() == Domain.SITES || workbench.selection().isEmpty();
    int next = document.layout().next(document.size());
    int first = atEnd ? next : workbench.selection().last() + 1;
    Points aside = aside(document.points(), points, steps);
    workbench.chooseEdit();
    workbench.perform(BulkEdit.insert(what, document, first, aside, wishes));
    workbench.select(Selection.range(first, first + points.size()));
  }

  /**
   * The points moved aside so that none of them is where a vertex is; so many tries are made for it
   * that nobody waits, and the last counts.
   */
  private Points aside(Points there, Points points, int steps) {
    Snap snap = workbench.snap();
    double step = snap.isOn(Snap.To.GRID) ? snap.grid() : ASIDE * Spot.step(workbench.viewport());
    int tries = Math.min(TRIES, 1 + MOST_WORK / Math.max(1, there.size() + points.size()));
    Points moved = points;
    for (int k = steps; k < tries + steps; k++) {
      moved = shifted(points, k * step);
      if (!isAnyThere(there, moved)) {
        return moved;
      }
    }
    return moved;
  }

  private Points shifted(Points points, double by) {
    double[] x = points.xs();
    double[] y = points.ys();
    for (int k = 0; k < x.length; k++) {
      x[k] = Spot.stepped(workbench.viewport(), x[k], by);
      y[k] = Spot.stepped(workbench.viewport(), y[k], by);
    }
    return Points.of(x, y);
  }

  /** In linear time, and with a table of the fewer points only. */
  private static boolean isAnyThere(Points there, Points points) {
    Set<Long> places = new HashSet<>();
    for (int k = 0; k < points.size(); k++) {
      places.add(place(points, k));
    }
    for (int v = 0; v < there.size(); v++) {
      if (places.contains(place(there, v)) && isAmong(points, there.x(v), there.y(v))) {
        return true;
      }
    }
    return false;
  }

  /** The same for the same place, and hardly ever for others. */
  private static long place(Points points, int v) {
    return (Double.doubleToLongBits(points.x(v)) * 0x9E3779B97F4A7C15L)
        ^ Double.doubleToLongBits(points.y(v));
  }

  private static boolean isAmong(Points points, double x, double y) {
    for (int k = 0; k < points.size(); k++) {
      if (points.x(k) == x && points.y(k) == y) {
        return true;
      }
    }
    return false;
  }
}
