package dct.ui.random;

import dct.core.triangulate.Domain;
import dct.ui.dialog.Ask;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.shell.CallCopy;
import dct.ui.workbench.Workbench;
import java.awt.Component;

/** Random Sites, Random Polygon and Random Region: asks which, and puts it on the canvas. */
public final class RandomWork {
  private final String title;
  private final Component parent;
  private final Workbench workbench;
  private final Runnable shown;
  private final CallCopy calls;
  private final RandomForm form;

  /**
   * Work on one kind of input.
   *
   * @param shown is run when something else was put on the canvas
   */
  RandomWork(
      String title,
      Domain domain,
      Component parent,
      Workbench workbench,
      CallCopy calls,
      Runnable shown) {
    this.title = title;
    this.parent = parent;
    this.workbench = workbench;
    this.calls = calls;
    this.shown = shown;
    form = new RandomForm(domain, this::copy);
  }

  /** Asks until the answers can be, or Cancel is chosen; then makes the points. */
  void ask() {
    while (form.show(parent, title)) {
      try {
        make(form.plan());
        return;
      } catch (IllegalArgumentException e) {
        Ask.sorry(parent, title, e.getMessage());
      }
    }
  }

  private void copy(RandomForm of) {
    try {
      calls.copy(of.plan().call());
    } catch (IllegalArgumentException e) {
      Ask.sorry(of, title, e.getMessage());
    }
  }

  private void make(RandomPlan plan) {
    workbench.jobs().submit(title, plan::generate, made -> show(made, plan));
  }

  private void show(Document made, RandomPlan plan) {
    Editor editor = workbench.editor(made.domain());
    editor.perform(new Edit.Replace(title, editor.document(), made));
    if (workbench.isChosen(made.domain())) {
      shown.run();
    }
    if (workbench.isDrawing()) {
      workbench.chooseEdit(); // a stray click should not add a vertex, as with what was opened
    }
    workbench.say(plan.words());
    form.suggestAfter(plan.seed());
  }
}
