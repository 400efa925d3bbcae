package dct.ui;

import dct.core.geometry.Points;
import dct.ui.command.CommandRegistry;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;

/** The commands that go back and forth in the history, or begin anew within it. */
final class EditCommands {
  private static final String CLEAR = "Clear Canvas";

  private final Workbench workbench;

  private EditCommands(Workbench workbench) {
    this.workbench = workbench;
  }

  /** Offers the commands for the documents of the workbench. */
  static void offer(CommandRegistry commands, Workbench workbench) {
    new EditCommands(workbench).offer(commands);
  }

  private void offer(CommandRegistry commands) {
    commands
        .add("Undo", "ctrl Z", "Takes the last step back", () -> onActive(Editor::undo))
        .enabledWhen(() -> label(editor -> editor.history().undoLabel()).isPresent())
        .named(() -> "Undo" + words(editor -> editor.history().undoLabel()));
    commands
        .add("Redo", "ctrl shift Z", "Does it again; also Ctrl+Y", () -> onActive(Editor::redo))
        .alsoOn("ctrl Y")
        .enabledWhen(() -> label(editor -> editor.history().redoLabel()).isPresent())
        .named(() -> "Redo" + words(editor -> editor.history().redoLabel()));
    commands
        .add(CLEAR, "ctrl DELETE", "Removes all vertices", this::clear)
        .enabledWhen(() -> workbench.domain().isPresent());
  }

  private Optional<String> label(Function<Editor, Optional<String>> of) {
    return workbench.active().flatMap(of);
  }

  private String words(Function<Editor, Optional<String>> of) {
    return label(of).map(name -> " " + name).orElse("");
  }

  private void onActive(Consumer<Editor> action) {
    workbench.active().ifPresent(action);
  }

  private void clear() {
    onActive(
        editor -> {
          if (editor.document().size() > 0) {
            editor.perform(Edit.replace(CLEAR, editor.document(), Points.ofPairs()));
          }
          workbench.chooseDraw();
        });
  }
}
