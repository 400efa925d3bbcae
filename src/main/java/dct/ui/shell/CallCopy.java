package dct.ui.shell;

import dct.core.degree.Preference;
import dct.core.degree.SearchLimits;
import dct.ui.dialog.Ask;
import dct.ui.document.Editor;
import dct.ui.workbench.Workbench;
import java.awt.Component;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;

/** Copy as Command Line: puts the call of the program that does the same on the clipboard. */
public final class CallCopy {
  private static final String TITLE = "Copy as Command Line";

  private final Component parent;
  private final Workbench workbench;

  public CallCopy(Component parent, Workbench workbench) {
    this.parent = parent;
    this.workbench = workbench;
  }

  /** Copies a call. */
  public void copy(ProgramCall call) {
    Toolkit.getDefaultToolkit()
        .getSystemClipboard()
        .setContents(new StringSelection(call.line()), null);
    workbench.say("Copied: " + call.line());
  }

  /** Copies the call that searches within these limits and prefers this, if anything. */
  public void copySearch(SearchLimits limits, Optional<Preference.Kind> preferred) {
    try {
      workbench
          .active()
          .ifPresent(editor -> copy(RepeatableCall.search(editor, limits, preferred)));
    } catch (NotRepeatableException e) {
      Ask.tell(parent, TITLE, e.getMessage());
    }
  }

  /** Copies the call that makes what is shown, or says why there is none. */
  public void copyShown() {
    workbench.active().ifPresent(editor -> withShown(editor, this::copy));
  }

  /** Finds the call that makes what the editor shows, or says why there is none. */
  private void withShown(Editor editor, Consumer<ProgramCall> then) {
    try {
      RepeatableCall shown = RepeatableCall.of(editor);
      workbench
          .jobs()
          .submit(
              TITLE,
              progress -> {
                try {
                  return new Found(shown.call(progress), "");
                } catch (NotRepeatableException e) {
                  return new Found(null, e.getMessage());
                }
              },
              found -> found.tell(then, this::sorry));
    } catch (NotRepeatableException e) {
      sorry(e.getMessage());
    }
  }

  private void sorry(String sentence) {
    // A dialog waits for its answer; the queue of jobs must not wait with it.
    SwingUtilities.invokeLater(() -> Ask.tell(parent, TITLE, sentence));
  }

  /** A call, or why there is none. */
  private record Found(ProgramCall call, String sentence) {
    void tell(Consumer<ProgramCall> then, Consumer<String> otherwise) {
      if (call != null) {
        then.accept(call);
      } else {
        otherwise.accept(sentence);
      }
    }
  }
}
