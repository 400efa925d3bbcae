package dct.ui.solve;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.Preference;
import dct.core.degree.SearchLimits;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.problem.Method;
import dct.problem.Solution;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.document.Result;
import dct.ui.document.ResultTitle;
import dct.ui.workbench.Workbench;
import java.time.Duration;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.function.Supplier;

/**
 * Makes results of the document: triangulations, flips and optima. Each becomes a step of the
 * history. Polygons are triangulated first if they have to be, by the method chosen last.
 */
public final class ResultWork {

  private final Workbench workbench;
  private final Consumer<Late> late;
  private final Supplier<SearchLimits> limits;
  private final PreferenceChoice choice;
  private Method method = Method.byDefault(Domain.POLYGON);
  private int views = Result.OPENED;

  /**
   * A result of points that have changed while it was made.
   *
   * @param result the result
   * @param name of the document
   */
  public record Late(Result result, String name) {}

  /**
   * Work on the documents of a workbench.
   *
   * @param late is given what comes too late to become a step
   * @param limits what searches are given
   * @param choice what they prefer
   */
  public ResultWork(
      Workbench workbench,
      Consumer<Late> late,
      Supplier<SearchLimits> limits,
      PreferenceChoice choice) {
    this.workbench = workbench;
    this.late = late;
    this.limits = limits;
    this.choice = choice;
  }

  /** Triangulates the polygon by this method. */
  void triangulate(Method chosen) {
    method = chosen;
    Editor editor = workbench.editor(Domain.POLYGON);
    Document document = editor.document();
    String name = editor.name();
    submit(
        editor,
        chosen.title(),
        progress -> Solution.of(document.instance(name, progress), chosen, progress));
  }

  /** Goes back to the points alone: a polygon without diagonals, or Delaunay sites. */
  void dropResult(String label) {
    workbench
        .active()
        .ifPresent(
            editor -> editor.perform(Edit.result(label, editor.document(), Optional.empty())));
  }

  /** Whether there is anything to go back from. */
  boolean hasResult() {
    return workbench.active().flatMap(editor -> editor.document().result()).isPresent();
  }

  /** Runs Scan-Flip on the triangulation shown, or the polygon's most recent one. */
  void flip() {
    workbench.active().ifPresent(this::flip);
  }

  private void flip(Editor editor) {
    start(editor, "flip")
        .ifPresent(
            start ->
                submit(
                    editor, ResultTitle.FLIP, progress -> start.apply(progress).flipped(progress)));
  }

  /**
   * Finds the triangulation in which the most vertices have the parity wished, or the best found on
   * Cancel.
   *
   * @param what what is being done, for a person to read
   * @param goal the wishes for n vertices
   */
  void optimize(String what, IntFunction<ParityGoal> goal) {
    workbench.active().ifPresent(editor -> optimize(editor, what, goal));
  }

  private void optimize(Editor editor, String what, IntFunction<ParityGoal> goal) {
    Optional<Function<Progress, Solution>> start = start(editor, "improve");
    if (start.isPresent()) {
      SearchLimits given = limits.get();
      Function<Triangulation, Optional<Preference>> preference = choice.now();
      Function<Progress, Solution> search =
          progress -> {
            Solution before = start.get().apply(progress);
            Solution asked = before.wishing(goal.apply(before.instance().size()));
            return preference
                .apply(asked.triangulation())
                .map(preferred -> asked.optimized(given, preferred, progress))
                .orElseGet(() -> asked.optimized(given, progress));
          };
      Document document = editor.document();
      int view = view(editor);
      workbench
          .jobs()
          .submitSearch(
              what,
              timed(search, view),
              result -> {
                accept(editor, what, document, result);
                result
                    .solution()
                    .preferred()
                    .ifPresent(best -> workbench.say(what + ": " + best.words()));
              });
    }
  }

  /** What to begin with; says so and gives nothing if sites have no triangulation. */
  private Optional<Function<Progress, Solution>> start(Editor editor, String toDo) {
    Document document = editor.document();
    if (editor.domain() == Domain.POLYGON) {
      Method by = method;
      String name = editor.name();
      return Optional.of(
          progress ->
              document
                  .result()
                  .map(Result::solution)
                  .orElseGet(() -> Solution.of(document.instance(name, progress), by, progress)));
    }
    Optional<Solution> shown = editor.shown().solution();
    if (!editor.shown().isWhole() || !editor.shown().document().equals(document)) {
      workbench.say("The sites are still being triangulated; try again when that is done");
      return Optional.empty();
    }
    if (shown.isEmpty()) {
      workbench.say(
          "There is no triangulation to "
              + toDo
              + " yet; draw three sites or more, not all on one line");
    }
    return shown.map(solution -> progress -> solution);
  }

  private void submit(Editor editor, String label, Function<Progress, Solution> work) {
    Document document = editor.document();
    int view = view(editor);
    workbench
        .jobs()
        .submit(label, timed(work, view), result -> accept(editor, label, document, result));
  }

  /** Work that says how long it took. */
  private static Function<Progress, Result> timed(Function<Progress, Solution> work, int view) {
    return progress -> {
      long start = System.nanoTime();
      Solution made = work.apply(progress);
      Duration time = Duration.ofNanos(System.nanoTime() - start);
      return Result.of(view, ResultTitle.of(made), made).taking(time);
    };
  }

  /** Sites are shown in the canvas, each result of a polygon in a view of its own. */
  private int view(Editor editor) {
    return editor.domain() == Domain.SITES ? Result.CANVAS : ++views;
  }

  private void accept(Editor editor, String label, Document of, Result result) {
    if (!editor.accept(label, of, result)) {
      workbench.say(label + " is of an older state; it is shown in a window of its own");
      late.accept(new Late(result, editor.name()));
    }
  }
}
