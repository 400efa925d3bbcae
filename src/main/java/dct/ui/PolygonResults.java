package dct.ui;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.problem.Method;
import dct.problem.Solution;
import dct.render.Scene;
import dct.ui.canvas.CanvasPanel;
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
  private final JFrame owner;
  private final CanvasPanel canvas;
  private final List<JFrame> frames = new ArrayList<>();
  private Method method = Method.byDefault(Domain.POLYGON);
  private Latest latest; // null before the first

  /** A solution, of which points, and where it is shown. */
  private record Latest(Points points, Solution solution, JFrame frame) {}

  /** A solution and its picture, both made in the background. */
  private record Result(Solution solution, Scene scene) {
    static Result of(Solution solution) {
      return new Result(solution, Scene.of(solution));
    }
  }

  /**
   * Results of a window.
   *
   * @param canvas the one whose labels new frames show
   */
  PolygonResults(Workbench workbench, JFrame owner, CanvasPanel canvas) {
    this.workbench = workbench;
    this.owner = owner;
    this.canvas = canvas;
  }

  /** Shows the polygon triangulated by this method. */
  void triangulate(Method chosen) {
    method = chosen;
    Document document = document();
    submit(
        chosen.title(),
        progress -> Result.of(solution(document, chosen, progress)),
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
    Method by = method;
    submit(
        "Perform Flip",
        progress ->
            Result.of(
                (from == null ? solution(document, by, progress) : from.solution)
                    .flipped(progress)),
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
                    solution(document, Method.byDefault(Domain.POLYGON), progress)
                        .wishing(goal.apply(document.size()))
                        .optimized(SearchLimits.DEFAULT, progress)),
            best -> show(document, best, what, owner));
  }

  private Document document() {
    return workbench.editor(Domain.POLYGON).document();
  }

  private Solution solution(Document document, Method by, Progress progress) {
    String name = workbench.editor(Domain.POLYGON).name();
    return Solution.of(document.instance(name, progress), by, progress);
  }

  private <T> void submit(
      String what, java.util.function.Function<Progress, T> work, Consumer<T> done) {
    workbench.jobs().submit(what, work, done);
  }

  private void show(Document document, Result result, String title, JFrame beside) {
    Editor editor = workbench.editor(Domain.POLYGON);
    ResultFrame frame =
        new ResultFrame(title, editor.name(), result.scene, canvas.labels(), workbench.jobs());
    Placement.beside(frame, beside, owner, frames.size());
    if (beside != owner) {
      beside.toFront(); // so that old and new can be compared
    }
    frames.add(frame);
    latest = new Latest(document.points(), result.solution, frame);
    frame.setVisible(true);
  }

  /** Closes all frames of results. */
  void dispose() {
    frames.forEach(JFrame::dispose);
  }
}
