package dct.ui.edit;

import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.ui.command.Command;
import dct.ui.command.CommandRegistry;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.document.Layout;
import dct.ui.workbench.Workbench;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** The commands that go back and forth in the history, or begin anew within it. */
public final class EditCommands {
  private static final String CLEAR = "Clear Canvas";
  private static final String NEW_HOLE = "New Hole";

  private final Workbench workbench;

  private EditCommands(Workbench workbench) {
    this.workbench = workbench;
  }

  /** Offers the commands for the documents of the workbench. */
  public static void offer(CommandRegistry commands, Workbench workbench) {
    new EditCommands(workbench).offer(commands);
  }

  /** Offers the commands that go back and forth in the history of an editor. */
  public static void offerHistory(CommandRegistry commands, Supplier<Optional<Editor>> of) {
    offerStep(
        commands.add(
            "Undo", "ctrl Z", "Takes the last step back", () -> of.get().ifPresent(Editor::undo)),
        () -> of.get().flatMap(editor -> editor.history().undoLabel()));
    offerStep(
        commands
            .add("Redo", "ctrl shift Z", "Does it again", () -> of.get().ifPresent(Editor::redo))
            .alsoOn("ctrl Y"),
        () -> of.get().flatMap(editor -> editor.history().redoLabel()));
  }

  /** Lets a command tell which step it is about. */
  private static void offerStep(Command command, Supplier<Optional<String>> label) {
    command
        .enabledWhen(() -> label.get().isPresent())
        .named(() -> command.id() + label.get().map(name -> " " + name).orElse(""));
  }

  private void offer(CommandRegistry commands) {
    offerHistory(commands, workbench::active);
    commands
        .add(
            NEW_HOLE,
            "H",
            "Begins a hole in the polygon; its vertices are clicked like those of the polygon",
            this::beginHole)
        .enabledWhen(this::canHaveHole);
    commands
        .add(CLEAR, "ctrl DELETE", "Removes all vertices", this::clear)
        .enabledWhen(() -> workbench.domain().isPresent());
  }

  private void onActive(Consumer<Editor> action) {
    workbench.active().ifPresent(action);
  }

  private boolean canHaveHole() {
    return workbench.isChosen(Domain.POLYGON)
        && openSize() != 1
        && openSize() != 2
        && workbench.document().size() > 2;
  }

  private int openSize() {
    Document document = workbench.document();
    return document.layout().openSize(document.size());
  }

  private void beginHole() {
    Document document = workbench.document();
    if (openSize() > 0) {
      Layout with = document.layout().withHole(document.size());
      workbench.perform(Edit.layout(NEW_HOLE, document, with));
    }
    workbench.chooseDraw();
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
