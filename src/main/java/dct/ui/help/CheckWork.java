package dct.ui.help;

import dct.core.Progress;
import dct.core.geometry.Crossings;
import dct.core.geometry.Defect;
import dct.core.geometry.InvalidGeometryException;
import dct.ui.dialog.Ask;
import dct.ui.document.Document;
import dct.ui.document.Editor;
import dct.ui.workbench.Workbench;
import java.awt.Component;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;

/** Help ▸ Check Input: whether the points can be triangulated, and what is wrong, and where. */
public final class CheckWork {
  private static final String TITLE = "Check Input";

  private final Component parent;
  private final Workbench workbench;
  private final Consumer<Defect> goTo;

  /**
   * Checks of the documents of a window.
   *
   * @param goTo shows the place of a defect
   */
  public CheckWork(Component parent, Workbench workbench, Consumer<Defect> goTo) {
    this.parent = parent;
    this.workbench = workbench;
    this.goTo = goTo;
  }

  /**
   * What came out.
   *
   * @param sentence what the points are, or what is wrong
   * @param defect what is wrong, if it has a place
   */
  record Report(String sentence, Optional<Defect> defect) {}

  /** Checks what is on the canvas, and says what came out. */
  void check() {
    workbench
        .active()
        .map(Editor::document)
        .ifPresent(
            document ->
                workbench.jobs().submit(TITLE, progress -> report(document, progress), this::show));
  }

  /** Checks the points of a document. */
  static Report report(Document document, Progress progress) {
    try {
      String what = document.instance("", progress).description();
      return new Report("This can be triangulated: " + what + ".", Optional.empty());
    } catch (InvalidGeometryException e) {
      return report(document, e.defect(), progress);
    }
  }

  private static Report report(Document document, Defect defect, Progress progress) {
    String fault = "This cannot be triangulated: " + defect.message() + ".";
    return switch (defect.kind()) {
      case TOO_FEW, COLLINEAR, FEW_SITES, SITES_ON_ONE_LINE -> new Report(fault, Optional.empty());
      default -> {
        int found = Crossings.of(document.rings(), progress).size();
        String more = found > 1 ? " " + found + " such places are marked on the canvas." : "";
        yield new Report(fault + more, Optional.of(defect));
      }
    };
  }

  private void show(Report report) {
    // A dialog waits for its answer; the queue of jobs must not wait with it.
    SwingUtilities.invokeLater(() -> ask(report));
  }

  private void ask(Report report) {
    if (report.defect().isEmpty()) {
      Ask.tell(parent, TITLE, report.sentence());
    } else if (Ask.offer(parent, TITLE, report.sentence(), "Show Me").isPresent()) {
      goTo.accept(report.defect().get());
    }
  }
}
