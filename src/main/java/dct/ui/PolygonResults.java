package dct.ui;

import dct.core.Progress;
import dct.core.degree.FlipResult;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ScanFlip;
import dct.core.degree.SearchLimits;
import dct.core.degree.best.BestTriangulation;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.render.Scene;
import dct.ui.document.Document;
import dct.ui.document.Editor;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import javax.swing.JFrame;

/**
 * Triangulates the polygon and shows each result in a frame of its own; remembers the most recent
 * one, which Perform Flip goes on from.
 */
final class PolygonResults {
  private final Workbench workbench;
  private final MainWindow owner;
  private final List<JFrame> frames = new ArrayList<>();
  private PolygonMethod method = PolygonMethod.MONOTONE;
  private Latest latest; // null before the first

  /** A triangulation, of which points, and where it is shown. */
  private record Latest(Points points, Triangulation triangulation, JFrame frame) {}

  /** A triangulation and its picture, both made in the background. */
  private record Result(Triangulation triangulation, Scene scene) {
    static Result of(Triangulation triangulation) {
      return new Result(triangulation, Scene.of(triangulation));
    }

    static Result of(FlipResult flips) {
      return new Result(flips.after(), Scene.of(flips));
    }

    static Result of(Optimum best) {
      return new Result(best.triangulation(), Scene.of(best));
    }
  }

  PolygonResults(Workbench workbench, MainWindow owner) {
    this.workbench = workbench;
    this.owner = owner;
  }

  /** Shows the polygon triangulated by this method. */
  void triangulate(PolygonMethod chosen) {
    method = chosen;
    Document document = document();
    submit(
        chosen.title(),
        progress -> Result.of(triangulation(document, chosen, progress)),
        result -> show(document, result, chosen.title(), owner));
  }

  /**
   * Shows the most recent triangulation after Scan-Flip, beside it. If the polygon has changed
   * since, it is triangulated anew by the method used last, the monotone one at first.
   */
  void flip() {
    Document document = document();
    boolean current = latest != null && latest.points.equals(document.points());
    Latest from = current ? latest : null;
    PolygonMethod by = method;
    submit(
        "Perform Flip",
        progress ->
            Result.of(
                ScanFlip.run(
                    from == null ? triangulation(document, by, progress) : from.triangulation,
                    progress)),
        result ->
            show(
                document,
                result,
                "Perform Flip after " + by.title(),
                from == null ? owner : from.frame));
  }

  /**
   * Shows the triangulation in which the most vertices have the parity wished, or the best found on
   * Cancel.
   *
   * @param what what is being done, for a person to read
   * @param goal the wishes for n vertices
   */
  void optimize(String what, IntFunction<ParityGoal> goal) {
    Document document = document();
    workbench
        .jobs()
        .submitSearch(
            what,
            progress ->
                Result.of(
                    BestTriangulation.of(
                        SimplePolygon.of(document.points(), progress),
                        goal.apply(document.size()),
                        SearchLimits.DEFAULT,
                        progress)),
            best -> show(document, best, what, owner));
  }

  private Document document() {
    return workbench.editor(Domain.POLYGON).document();
  }

  private static Triangulation triangulation(
      Document document, PolygonMethod method, Progress progress) {
    return method.triangulate(SimplePolygon.of(document.points(), progress), progress);
  }

  private <T> void submit(
      String what, java.util.function.Function<Progress, T> work, Consumer<T> done) {
    workbench.jobs().submit(what, work, done);
  }

  private void show(Document document, Result result, String title, JFrame beside) {
    Editor editor = workbench.editor(Domain.POLYGON);
    ResultFrame frame =
        new ResultFrame(
            title, editor.name(), result.scene, owner.canvas().labels(), workbench.jobs());
    Placement.beside(frame, beside, owner, frames.size());
    if (beside != owner) {
      beside.toFront(); // so that old and new can be compared
    }
    frames.add(frame);
    latest = new Latest(document.points(), result.triangulation, frame);
    frame.setVisible(true);
  }

  /** Closes all frames of results. */
  void dispose() {
    frames.forEach(JFrame::dispose);
  }
}
