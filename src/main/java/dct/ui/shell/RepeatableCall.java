package dct.ui.shell;

import dct.core.Progress;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.Preference;
import dct.core.degree.ScanFlip;
import dct.core.degree.SearchLimits;
import dct.core.triangulate.Triangulation;
import dct.problem.Comparison;
import dct.problem.Method;
import dct.problem.Solution;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.document.Origin;
import dct.ui.document.Result;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Finds the call of the program that makes what an editor shows, from its file. It is made sure
 * that it does: the method and the flips are run again and compared; of a search, which may take
 * long, it is known what it began with.
 */
public final class RepeatableCall {
  private static final String KEEP = " Save as .json keeps the result itself.";

  private final Document document;
  private final Path file;
  private final Optional<Path> wishes;
  private final Optional<Edit.Made> making;
  private final Optional<Solution> shown;

  private RepeatableCall(Editor editor, Path file) {
    this.document = editor.document();
    this.file = file;
    this.wishes = editor.wishFile();
    this.making = editor.history().making();
    this.shown = document.result().map(Result::solution).or(() -> editor.shown().solution());
  }

  /**
   * What an editor shows now.
   *
   * @throws NotRepeatableException if its points are not in a file as they are, or are still being
   *     triangulated
   */
  public static RepeatableCall of(Editor editor) {
    Path file = savedFile(editor);
    if (!editor.shown().document().equals(editor.document())) {
      throw new NotRepeatableException(
          "The " + editor.domain().title() + " is still being analysed; try again after that.");
    }
    return new RepeatableCall(editor, file);
  }

  private static Path savedFile(Editor editor) {
    return editor
        .origin()
        .map(Origin::file)
        .filter(saved -> !editor.history().isChanged())
        .orElseThrow(
            () ->
                new NotRepeatableException(
                    "The command reads the "
                        + editor.domain().vertices()
                        + " from a file, and these are not saved; save them first."));
  }

  /**
   * The search for the most even vertices in what an editor shows.
   *
   * @param preferred what it prefers, if anything
   * @throws NotRepeatableException if its points are not in a file as they are
   */
  public static ProgramCall search(
      Editor editor, SearchLimits limits, Optional<Preference.Kind> preferred) {
    Method method =
        editor
            .document()
            .result()
            .flatMap(made -> made.solution().method())
            .orElse(Method.byDefault(editor.domain()));
    return ProgramCall.triangulate(savedFile(editor), editor.document().content(), method)
        .optimize("even", limits)
        .prefer(ofNoFile(preferred));
  }

  /**
   * The call.
   *
   * @throws NotRepeatableException if there is none that makes the same
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public ProgramCall call(Progress progress) {
    if (shown.isEmpty()) {
      return ProgramCall.check(file, document.content());
    }
    Solution solution = shown.get();
    Method method = solution.method().orElseThrow(RepeatableCall::foreign);
    ProgramCall call = ProgramCall.triangulate(file, document.content(), method);
    if (solution.optimum().isPresent()) {
      return searched(call, solution, solution.optimum().get(), progress);
    }
    Triangulation made = method.run(solution.instance(), progress);
    boolean isFlipped = solution.flips().isPresent();
    Triangulation again = isFlipped ? ScanFlip.run(made, progress).after() : made;
    if (!isSame(again, solution.triangulation())) {
      throw severalSteps();
    }
    return isFlipped ? call.flip() : call;
  }

  private static NotRepeatableException foreign() {
    return new NotRepeatableException(
        "What is shown began with the triangulation of a file; no command makes that." + KEEP);
  }

  private static NotRepeatableException severalSteps() {
    return new NotRepeatableException(
        "What is shown was made by hand or in several steps; one command makes a triangulation,"
            + " Scan-Flip of it, or a search that begins with it, and no more."
            + KEEP);
  }

  private static boolean isSame(Triangulation one, Triangulation other) {
    Comparison comparison = Comparison.of(one, other);
    return comparison.onlyFirst().isEmpty() && comparison.onlySecond().isEmpty();
  }

  private ProgramCall searched(
      ProgramCall call, Solution solution, Optimum best, Progress progress) {
    if (making.isEmpty()) {
      throw severalSteps();
    }
    if (best.interrupted() && Double.isInfinite(solution.limits().seconds())) {
      throw new NotRepeatableException(
          "The search was stopped early, and no command stops at the same place." + KEEP);
    }
    if (!beganWithTheMethod(solution, progress)) {
      throw new NotRepeatableException(
          "The search began with flips or another result; a command begins with a method alone."
              + KEEP);
    }
    Optional<Preference.Kind> kind =
        solution.preferred().map(preferred -> preferred.preference().kind());
    return wished(call, solution, best.goal()).prefer(ofNoFile(kind));
  }

  /** What is preferred, which must not need a triangulation. */
  private static Optional<Preference.Kind> ofNoFile(Optional<Preference.Kind> kind) {
    if (kind.equals(Optional.of(Preference.Kind.KEPT))) {
      throw new NotRepeatableException(
          "The search keeps edges of a triangulation that is in no file; a command keeps those of a"
              + " file."
              + KEEP);
    }
    return kind;
  }

  private ProgramCall wished(ProgramCall call, Solution solution, ParityGoal goal) {
    if (goal.isAll(Wish.EVEN) || goal.isAll(Wish.ODD)) {
      return call.optimize(goal.isAll(Wish.EVEN) ? "even" : "odd", solution.limits());
    }
    Path file =
        wishes.orElseThrow(
            () ->
                new NotRepeatableException(
                    "The command reads the wishes from a file, and these are not saved; choose"
                        + " Triangulate ▸ Wished Parities… and Save Wishes first."));
    return call.optimize(file, solution.limits());
  }

  /** Whether the search began where the command's would. */
  private boolean beganWithTheMethod(Solution found, Progress progress) {
    Optional<Solution> start = making.get().before().map(Result::solution);
    return start.isEmpty()
        || (start.get().method().equals(found.method())
            && start.get().flips().isEmpty()
            && start.get().optimum().isEmpty()
            && isSame(
                found.method().orElseThrow().run(start.get().instance(), progress),
                start.get().triangulation()));
  }
}
