package dct.ui;

import dct.core.triangulate.Domain;
import dct.ui.canvas.CanvasPanel;
import dct.ui.canvas.InSight;
import dct.ui.canvas.Links;
import dct.ui.command.CommandRegistry;
import dct.ui.edit.WishWork;
import dct.ui.explain.BoundNote;
import dct.ui.explain.Explainer;
import dct.ui.file.FileWork;
import dct.ui.flip.FlipCommands;
import dct.ui.flip.FlipDesk;
import dct.ui.result.ResultView;
import dct.ui.result.ViewArea;
import dct.ui.session.Settings;
import dct.ui.shell.CallCopy;
import dct.ui.solve.FlipListWork;
import dct.ui.solve.FrameHost;
import dct.ui.solve.LiveCommands;
import dct.ui.solve.PieceWork;
import dct.ui.solve.PreferenceChoice;
import dct.ui.solve.ResultFrames;
import dct.ui.solve.ResultViewCommands;
import dct.ui.solve.ResultWork;
import dct.ui.solve.SearchOptions;
import dct.ui.solve.TriangulateCommands;
import dct.ui.study.StudyWork;
import dct.ui.workbench.Workbench;
import javax.swing.JComponent;
import javax.swing.JFrame;

/**
 * The results of a window: makes them, shows them in frames or beside the drawing, flips, compares
 * and explains them.
 */
final class WindowResults {
  private final JFrame window;
  private final Workbench workbench;
  private final CanvasPanel canvas;
  private final FileWork files;
  private final Links links = new Links();
  private final InSight inSight;
  private final ViewArea area;
  private final ResultFrames frames;
  private final StudyWork studies;
  private final Explainer explainer;
  private final BoundNote bound;
  private ResultViewCommands views; // null until they are offered, as flips
  private FlipCommands flips;

  /** The results of what a canvas shows. */
  WindowResults(JFrame window, Workbench workbench, CanvasPanel canvas, FileWork files) {
    this.window = window;
    this.workbench = workbench;
    this.canvas = canvas;
    this.files = files;
    links.addDrawing(canvas);
    inSight = new InSight(canvas, links);
    area = new ViewArea(canvas, inSight::setShared);
    frames = new ResultFrames(workbench, window, canvas, links, area, files);
    studies = new StudyWork(window, canvas, links, frames::open);
    explainer = new Explainer(canvas, workbench.jobs(), workbench::solution, FrameHost::shown);
    bound = new BoundNote(canvas, workbench.jobs(), workbench::showsBound, workbench::inCanvas);
  }

  /** Offers how results are made, shown, flipped and explained. */
  void offer(CommandRegistry commands, CallCopy calls, Settings settings) {
    PreferenceChoice preference = new PreferenceChoice(settings);
    SearchOptions searches =
        new SearchOptions(limits -> calls.copySearch(limits, preference.kind()));
    TriangulateCommands.offer(
        commands,
        workbench,
        new ResultWork(workbench, frames::showLate, searches::limits, preference),
        new WishWork(window, workbench, files::folder));
    preference.offer(commands);
    searches.offer(commands, window);
    PieceWork.offer(commands, workbench, frames::show);
    studies.offer(commands);
    LiveCommands.offer(commands, workbench, settings);
    offerViews(commands);
    explainer.offer(commands);
    offerFlips(commands);
  }

  private void offerViews(CommandRegistry commands) {
    views = new ResultViewCommands(window, commands, workbench, canvas, frames, links);
    views.offer();
    area.whenInFront(view -> commands.setFront(view.map(ResultView::commands)));
  }

  private void offerFlips(CommandRegistry commands) {
    FlipDesk desk = workbench.flips();
    FlipListWork lists = new FlipListWork(window, desk, workbench.jobs(), files::folder);
    flips =
        FlipCommands.offer(commands, desk, lists, canvas, () -> workbench.isChosen(Domain.SITES));
    inSight.shareWith(flips.panel());
  }

  /** The canvas, and views of results beside it. */
  JComponent area() {
    return area;
  }

  /** The list of the flips, once they are offered. */
  JComponent flipPanel() {
    return flips.panel();
  }

  /** Where views of results are. */
  ResultFrames frames() {
    return frames;
  }

  /** Takes up the flips and the bound of what is to be shown now. */
  void refresh() {
    flips.refresh();
    bound.refresh();
  }

  /** Has views, reasons and tables follow what the canvas shows now. */
  void follow() {
    frames.refresh();
    explainer.refresh();
    views.refresh();
  }

  /** Closes all that is not in the window itself. */
  void dispose() {
    frames.dispose();
    studies.dispose();
  }
}
