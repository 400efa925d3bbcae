package dct.ui.solve;

import dct.problem.Comparison;
import dct.render.ComparisonScene;
import dct.render.Scene;
import dct.ui.canvas.CanvasPanel;
import dct.ui.canvas.Links;
import dct.ui.command.CommandRegistry;
import dct.ui.dialog.Placement;
import dct.ui.document.Editor;
import dct.ui.document.Result;
import dct.ui.result.Arrangement;
import dct.ui.result.ResultList;
import dct.ui.result.ResultTable;
import dct.ui.result.ResultView;
import dct.ui.workbench.Workbench;
import java.util.List;
import javax.swing.JFrame;

/** The commands that say where results are shown, link them, compare them and list them. */
public final class ResultViewCommands {
  private final JFrame owner;
  private final CommandRegistry main;
  private final Workbench workbench;
  private final CanvasPanel canvas;
  private final ResultFrames results;
  private final Links links;
  private final ResultList list = new ResultList();
  private ResultTable table; // null until it is asked for

  /**
   * Commands for the results of a window.
   *
   * @param main the commands of the window
   */
  public ResultViewCommands(
      JFrame owner,
      CommandRegistry main,
      Workbench workbench,
      CanvasPanel canvas,
      ResultFrames results,
      Links links) {
    this.owner = owner;
    this.main = main;
    this.workbench = workbench;
    this.canvas = canvas;
    this.results = results;
    this.links = links;
  }

  /** Offers the commands to the window and to all views to come. */
  public void offer() {
    offer(main, "F6");
    results.setCommands(this::offerToView);
  }

  private void offerToView(CommandRegistry commands) {
    offer(commands, "");
    commands
        .add(
            "Drawing to Front",
            "F6",
            "Brings the window with the drawing to the front, and Results to Front brings them"
                + " back",
            this::bringDrawingForward)
        .enabledWhen(() -> !results.isInWindow());
  }

  private void bringDrawingForward() {
    FrameHost.toFront(owner);
    canvas.requestFocusInWindow();
  }

  private void offer(CommandRegistry commands, String keyOfResults) {
    commands
        .add(
            "Results in This Window",
            "ctrl shift I",
            "Shows results beside the drawing instead of in frames of their own",
            () -> turn(() -> results.setInWindow(!results.isInWindow())))
        .selectedWhen(results::isInWindow);
    offerArrangement(commands);
    commands
        .add(
            "Results to Front",
            keyOfResults,
            "Brings the frames of all results to the front, which the window may cover",
            this::bringResultsForward)
        .enabledWhen(() -> !results.isInWindow());
    commands
        .add(
            "Link Views",
            "ctrl L",
            "Views of the same points show the same part, and ring what the mouse is at in another",
            () -> turn(() -> links.setOn(!links.isOn())))
        .selectedWhen(links::isOn);
    commands
        .add(
            "Show Bound",
            "B",
            "Says beside the counts what no triangulation can go below, and when that is reached",
            () -> turn(() -> workbench.setShowsBound(!workbench.showsBound())))
        .selectedWhen(workbench::showsBound);
    commands
        .add(
            "Compare Results…",
            "ctrl shift K",
            "Shows only the edges in which two results of the same points differ",
            this::askToCompare)
        .enabledWhen(() -> workbench.domain().isPresent());
    commands
        .add(
            "Table of Results",
            "ctrl T",
            "Lists all results of these points with their counts, bounds and times",
            this::showTable)
        .enabledWhen(() -> workbench.domain().isPresent());
  }

  private void offerArrangement(CommandRegistry commands) {
    for (Arrangement arrangement : Arrangement.values()) {
      commands
          .add(
              arrangement.title(),
              "",
              arrangement.description(),
              () -> turn(() -> results.arrange(arrangement)))
          .enabledWhen(results::isInWindow)
          .selectedWhen(() -> results.arrangement() == arrangement);
    }
    offerMove(commands, "Move View Left", "ctrl shift LEFT", "before", -1);
    offerMove(commands, "Move View Right", "ctrl shift RIGHT", "behind", 1);
  }

  private void offerMove(
      CommandRegistry commands, String name, String key, String where, int places) {
    commands
        .add(
            name,
            key,
            "Exchanges the view in use within this window with the one " + where + " it",
            () -> turn(() -> results.move(places)))
        .enabledWhen(() -> results.canMove(places));
  }

  private void bringResultsForward() {
    if (!results.bringForward()) {
      workbench.say("There are no frames of results; make one by Triangulate");
    }
  }

  /** Turns a switch that other windows show, too. */
  private void turn(Runnable change) {
    change.run();
    main.refresh();
    results.refreshCommands();
  }

  private List<Result> all() {
    return workbench.active().map(list::of).orElse(List.of());
  }

  private void askToCompare() {
    List<Result> all = all();
    if (all.size() < 2) {
      workbench.say(
          "There are no two results of these points to compare; make another one by Triangulate");
    } else {
      CompareDialog.ask(owner, all).ifPresent(pair -> compare(pair.first(), pair.second()));
    }
  }

  private void compare(Result first, Result second) {
    String name = workbench.active().map(Editor::name).orElse("");
    workbench
        .jobs()
        .submit(
            "Comparing",
            progress ->
                ComparisonScene.of(
                    Comparison.of(
                        first.solution().triangulation(), second.solution().triangulation()),
                    first.title(),
                    second.title()),
            scene -> show(scene, name));
  }

  private void show(Scene scene, String name) {
    results.open(List.of(new ResultView("Comparison", name, scene, canvas.labels(), links)));
  }

  private void showTable() {
    if (table == null) {
      table = new ResultTable(owner, this::bringForward, this::compare, workbench::say);
      Placement.centre(table); // no larger than the screen
    }
    table.show(all());
    table.setVisible(true);
    table.toFront(); // of a frame of results from which it was asked for, too
  }

  /** The result that the canvas shows is in front when the window is. */
  private void bringForward(Result result) {
    boolean inCanvas =
        workbench
            .active()
            .flatMap(editor -> editor.shown().solution())
            .filter(shown -> shown.triangulation().equals(result.solution().triangulation()))
            .isPresent();
    if (inCanvas) {
      FrameHost.toFront(owner);
    } else {
      results.bringForward(result);
    }
  }

  /** Brings the table up to date with the document. */
  public void refresh() {
    if (table != null && table.isVisible()) {
      table.show(all());
    }
  }
}
