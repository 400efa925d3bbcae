package dct.ui.explain;

import dct.core.degree.Explanation;
import dct.io.ResultJson;
import dct.problem.Solution;
import dct.problem.Why;
import dct.problem.verify.Verdict;
import dct.problem.verify.Verifier;
import dct.ui.canvas.CanvasPanel;
import dct.ui.command.CommandRegistry;
import dct.ui.job.Jobs;
import java.awt.Window;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;

/**
 * Explains and verifies what a canvas shows: the commands Why? and Verify Result. An explanation
 * puts its marks on the canvas until it is closed, or the canvas shows something else.
 */
public final class Explainer {
  private final CanvasPanel canvas;
  private final Jobs jobs;
  private final Supplier<Optional<Solution>> shown;
  private final Supplier<List<? extends Window>> frames;
  private TextDialog explanation; // null if there is none
  private Solution explained;

  /**
   * An explainer of a canvas.
   *
   * @param shown what it shows; empty if that is no result
   * @param frames which no text may cover; they are moved if there is no other room
   */
  public Explainer(
      CanvasPanel canvas,
      Jobs jobs,
      Supplier<Optional<Solution>> shown,
      Supplier<List<? extends Window>> frames) {
    this.canvas = canvas;
    this.jobs = jobs;
    this.shown = shown;
    this.frames = frames;
  }

  /** Offers the commands. */
  public void offer(CommandRegistry commands) {
    commands
        .add(
            "Why?",
            "shift W",
            "Explains on the picture why no triangulation can be better than the bound says",
            this::explain)
        .enabledWhen(() -> shown.get().isPresent())
        .alsoOn("typed ?");
    commands
        .add(
            "Verify Result",
            "",
            "Checks all that the result says of itself, from its points and edges alone",
            this::verify)
        .enabledWhen(() -> shown.get().isPresent());
  }

  /** Takes the explanation away if it is one of something that is no longer shown. */
  public void refresh() {
    if (explanation != null && shown.get().filter(this::isExplained).isEmpty()) {
      explanation.dispose();
    }
  }

  private boolean isExplained(Solution solution) {
    return solution.triangulation() == explained.triangulation()
        && solution.instance().wishes().equals(explained.instance().wishes());
  }

  private void explain() {
    shown
        .get()
        .ifPresent(
            solution ->
                jobs.submit(
                    "Why?", progress -> Why.of(solution, progress), why -> show(solution, why)));
  }

  private void show(Solution solution, Explanation why) {
    if (explanation != null) {
      explanation.dispose();
    }
    Window owner = SwingUtilities.getWindowAncestor(canvas);
    if (owner == null || !canvas.isShowing()) {
      return; // it was closed meanwhile
    }
    explained = solution;
    TextDialog dialog = new TextDialog(owner, "Why?", "why", why.title(), text(why));
    explanation = dialog;
    dialog.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosed(WindowEvent e) {
            closed(dialog);
          }
        });
    canvas.setMarks(why.marks());
    dialog.showBeside(canvas, frames.get());
    refresh();
  }

  private static String text(Explanation why) {
    return String.join("\n\n", why.sentences());
  }

  private void closed(TextDialog dialog) {
    if (explanation == dialog) {
      explanation = null;
      canvas.setMarks(List.of());
    }
  }

  private void verify() {
    shown
        .get()
        .ifPresent(
            solution ->
                jobs.submit(
                    "Verify Result",
                    progress ->
                        Verifier.verify(
                            ResultJson.claims(solution),
                            Optional.of(solution.instance()),
                            progress),
                    this::tell));
  }

  private void tell(Verdict verdict) {
    Window owner = SwingUtilities.getWindowAncestor(canvas);
    if (owner != null && canvas.isShowing()) {
      new TextDialog(
              owner,
              "Verify Result",
              "verdict",
              VerdictText.heading(verdict),
              VerdictText.of(verdict))
          .showBeside(canvas, frames.get());
    }
  }
}
