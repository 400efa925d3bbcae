package dct.ui.workbench;

import dct.problem.Solution;
import dct.ui.document.Analysis;
import dct.ui.document.Editor;
import dct.ui.document.Result;
import dct.ui.flip.FlipSource;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** The triangulation of the sites in the canvas, as it is flipped by hand. */
public final class SiteFlips implements FlipSource {
  private static final String TITLE = "Flips by Hand";

  private final Editor editor;
  private final BooleanSupplier chosen;

  /**
   * The sites of an editor.
   *
   * @param chosen whether the canvas shows them
   */
  SiteFlips(Editor editor, BooleanSupplier chosen) {
    this.editor = editor;
    this.chosen = chosen;
  }

  @Override
  public Editor editor() {
    return editor;
  }

  @Override
  public Optional<Result> result() {
    Analysis shown = editor.shown();
    boolean current = chosen.getAsBoolean() && shown.document().equals(editor.document());
    return current ? shown.solution().map(solution -> of(shown, solution)) : Optional.empty();
  }

  private static String title(Analysis shown) {
    return shown.document().result().map(Result::title).orElse(TITLE);
  }

  @Override
  public String refusal() {
    if (!chosen.getAsBoolean()) {
      return "Triangulate the polygon: edges are flipped in the frame of a result";
    }
    return editor.document().size() > 2 && editor.shown().defects().isEmpty()
        ? "The sites are still being triangulated"
        : "There is nothing to flip yet; draw four sites or more, not all on one line";
  }

  private static Result of(Analysis shown, Solution solution) {
    return new Result(Result.CANVAS, title(shown), solution, shown.scene(), Optional.empty());
  }
}
