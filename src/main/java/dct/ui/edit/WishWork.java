package dct.ui.edit;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.io.CannotWriteException;
import dct.io.WishFile;
import dct.ui.dialog.Ask;
import dct.ui.dialog.Chooser;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.workbench.Workbench;
import java.awt.Component;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;

/**
 * Triangulate ▸ Wished Parities…: what is wished, by clicks or from a file, and what comes of it.
 */
public final class WishWork {
  private static final String TITLE = "Wished Parities";
  private static final String LOAD = "Load Wishes";

  private final Component parent;
  private final Workbench workbench;
  private final Supplier<Optional<Path>> folder;

  /** Finds the triangulation that grants the most wishes. */
  @FunctionalInterface
  public interface Optimizer {
    /**
     * Begins the search.
     *
     * @param what what is being done, for a person to read
     * @param goal the wishes for n vertices
     */
    void optimize(String what, IntFunction<ParityGoal> goal);
  }

  /**
   * Wishes of the documents of a window.
   *
   * @param folder where the document's file is
   */
  public WishWork(Component parent, Workbench workbench, Supplier<Optional<Path>> folder) {
    this.parent = parent;
    this.workbench = workbench;
    this.folder = folder;
  }

  /** Says what is wished, and lets the user load or save wishes or have them granted. */
  public void ask(Optimizer optimizer) {
    workbench.active().ifPresent(editor -> ask(editor, optimizer));
  }

  private void ask(Editor editor, Optimizer optimizer) {
    ParityGoal wishes = editor.document().wishes();
    if (wishes.isAll(Wish.EVEN)) {
      String how =
          "Every vertex is wished to be even. Choose Edit ▸ Wish Parity (key W) and click vertices"
              + " to wish them odd or any, or load a file that has a line “v odd” or “v any” for"
              + " each vertex v that shall not be even.";
      if (Ask.choose(parent, TITLE, how, 0, LOAD, "Cancel") == 0) {
        load(editor, optimizer);
      }
    } else {
      switch (Ask.choose(
          parent, TITLE, words(wishes), 0, "Triangulate", LOAD, "Save Wishes", "Cancel")) {
        case 0 -> optimizer.optimize(TITLE, n -> wishes);
        case 1 -> load(editor, optimizer);
        case 2 -> save(editor);
        default -> {}
      }
    }
  }

  private static String words(ParityGoal wishes) {
    return String.format(
        Locale.ROOT,
        "Wished: even %d · odd %d · any %d.",
        wishes.count(Wish.EVEN),
        wishes.count(Wish.ODD),
        wishes.count(Wish.ANY));
  }

  private void load(Editor editor, Optimizer optimizer) {
    Document document = editor.document();
    Optional<Path> file = Chooser.WISHES.open(parent, folder.get(), LOAD);
    file.ifPresent(
        path ->
            workbench
                .jobs()
                .read(
                    "Reading " + path.getFileName(),
                    progress -> WishFile.read(path, document.size(), progress),
                    wishes -> loaded(editor, document, wishes, path, optimizer)));
  }

  private void loaded(
      Editor editor, Document document, ParityGoal wishes, Path from, Optimizer optimizer) {
    if (editor.document().size() != document.size()) {
      workbench.say("The vertices have changed meanwhile; the wishes were not taken over");
      return;
    }
    editor.perform(Edit.wishes(LOAD, editor.document(), wishes));
    editor.wishesSaved(editor.document(), from);
    // A dialog waits for its answer; the queue of jobs must not wait with it.
    SwingUtilities.invokeLater(() -> ask(editor, optimizer));
  }

  private void save(Editor editor) {
    String name = editor.name().replaceFirst("\\.txt$", "") + "_wishes.txt";
    Path suggested = folder.get().map(f -> f.resolve(name)).orElse(Path.of(name));
    Optional<Path> typed = Chooser.WISHES.save(parent, suggested, "Save Wishes");
    if (typed.isPresent()
        && (!Files.exists(typed.get()) || Chooser.confirmReplacing(parent, typed.get()))) {
      save(editor, typed.get());
    }
  }

  private void save(Editor editor, Path file) {
    Document document = editor.document();
    workbench
        .jobs()
        .write(
            "Saving " + file.getFileName(),
            progress -> write(file, document.wishes(), progress),
            written -> {
              editor.wishesSaved(document, written);
              workbench.say("Saved " + written);
            });
  }

  private static Path write(Path file, ParityGoal wishes, Progress progress) {
    try {
      WishFile.write(file, wishes, progress);
      return file;
    } catch (CannotWriteException e) {
      throw new UncheckedIOException(e);
    }
  }
}
