package dct.ui;

import dct.core.triangulate.Domain;
import dct.io.FileNames;
import dct.io.FileStamp;
import dct.ui.DocumentFile.Read;
import dct.ui.canvas.CanvasPanel;
import dct.ui.document.Document;
import dct.ui.document.Editor;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.JFrame;

/** What the File menu does to the documents. */
final class FileWork {
  private final JFrame window;
  private final Workbench workbench;
  private final Runnable shown;
  private final Map<Domain, Origin> origins = new EnumMap<>(Domain.class);
  private Optional<Path> folder = Optional.empty(); // used last

  /** The file that a document came from or went to, and what that held then. */
  private record Origin(Path file, Optional<FileStamp> stamp) {}

  /** How an attempt to save ended; not well if another program has changed the file. */
  private record Attempt(boolean isWritten, Optional<FileStamp> stamp) {}

  /**
   * File work for a window.
   *
   * @param shown is run when another document was put on the canvas
   */
  FileWork(JFrame window, Workbench workbench, Runnable shown) {
    this.window = window;
    this.workbench = workbench;
    this.shown = shown;
  }

  /** Writes what this canvas shows to a picture that the user names. */
  void exportPicture(CanvasPanel canvas) {
    String name = workbench.active().map(Editor::name).orElse("canvas");
    PictureExport.ask(window, canvas, name, workbench.jobs(), workbench::say);
  }

  /** The folder of the chosen application's document, or else the one that was used last. */
  Optional<Path> folder() {
    return workbench.domain().flatMap(this::folderOf);
  }

  private Optional<Path> folderOf(Domain domain) {
    return Optional.ofNullable(origins.get(domain))
        .map(origin -> origin.file.toAbsolutePath().getParent())
        .or(() -> folder);
  }

  /** Begins an empty document of the chosen application. */
  void startAnew() {
    workbench.active().ifPresent(editor -> unlessLost(editor, () -> startAnew(editor)));
  }

  private void startAnew(Editor editor) {
    origins.remove(editor.domain());
    editor.startAnew();
    workbench.chooseDraw();
    shown.run();
  }

  /** Asks for a file and opens it. */
  void open() {
    Chooser.DOCUMENTS.open(window, folder().or(() -> folder)).ifPresent(this::open);
  }

  /** Opens a file in the application that it belongs to; whatever fails, nothing changes. */
  void open(Path typed) {
    Domain otherwise = workbench.domain().orElse(Domain.POLYGON);
    workbench
        .jobs()
        .read(
            "Reading " + typed.getFileName(),
            progress -> DocumentFile.read(typed, otherwise, progress),
            this::offer);
    folder = Optional.ofNullable(typed.toAbsolutePath().getParent());
  }

  private void offer(Read read) {
    unlessLost(workbench.editor(read.document().domain()), () -> show(read));
  }

  private void show(Read read) {
    show(read.document(), read.file().getFileName().toString());
    origins.put(read.document().domain(), new Origin(read.file(), read.stamp()));
    if (read.merged() > 0) {
      workbench.say(read.merged() + " sites were there already and have been merged");
    }
  }

  /** Opens a sample. */
  void openSample(String name) {
    Document sample = Samples.read(name);
    unlessLost(
        workbench.editor(sample.domain()),
        () -> {
          show(sample, name);
          origins.remove(sample.domain());
        });
  }

  private void show(Document document, String name) {
    workbench.choose(document.domain());
    workbench.chooseEdit(); // a stray click should not add a vertex to what was opened
    workbench.editor(document.domain()).load(document, name);
    shown.run();
  }

  /** Does something that replaces the document; asks first if it has changes or wishes. */
  private void unlessLost(Editor editor, Runnable then) {
    unlessChangesLost(editor, () -> unlessWishesLost(editor, then));
  }

  private void unlessWishesLost(Editor editor, Runnable then) {
    String question =
        editor.name()
            + " has wished parities that are not saved; Triangulate ▸ Wished Parities… can save"
            + " them.";
    if (!editor.history().hasUnsavedWishes()
        || Ask.confirm(window, "Unsaved Wishes", question, "Discard Wishes")) {
      then.run();
    }
  }

  private void unlessChangesLost(Editor editor, Runnable then) {
    if (!editor.history().isChanged()) {
      then.run();
      return;
    }
    String question = editor.name() + " has changes that are not saved. Save them?";
    switch (Ask.choose(window, "Unsaved Changes", question, 0, "Save", "Don't Save", "Cancel")) {
      case 0 -> save(editor, then);
      case 1 -> then.run();
      default -> {}
    }
  }

  /**
   * Saves the chosen application's document to the file that it came from; asks if there is none.
   */
  void save() {
    workbench.active().ifPresent(editor -> save(editor, () -> {}));
  }

  private void save(Editor editor, Runnable then) {
    Origin origin = origins.get(editor.domain());
    if (origin == null) {
      saveAs(editor, then);
    } else {
      save(editor, origin.file, origin.stamp, then);
    }
  }

  private void saveAs(Editor editor, Runnable then) {
    Optional<Path> typed = Chooser.DOCUMENTS.save(window, suggestion(editor));
    if (typed.isPresent()) {
      Path file = FileNames.forSaving(typed.get(), editor.domain());
      if (!Files.exists(file) || Chooser.confirmReplacing(window, file)) {
        save(editor, file, Optional.empty(), then);
      }
    }
  }

  private Path suggestion(Editor editor) {
    Origin origin = origins.get(editor.domain());
    if (origin != null) {
      return origin.file;
    }
    boolean sample = FileNames.domain(Path.of(editor.name())).isPresent();
    Path name = Path.of(sample ? editor.name() : "untitled" + FileNames.suffix(editor.domain()));
    return folder.map(f -> f.resolve(name)).orElse(name);
  }

  /**
   * Saves to a file, but not over what another program has written to it.
   *
   * @param expected what the file should hold if it is there; nothing if that does not matter
   */
  private void save(Editor editor, Path file, Optional<FileStamp> expected, Runnable then) {
    Document document = editor.document();
    folder = Optional.ofNullable(file.toAbsolutePath().getParent());
    workbench
        .jobs()
        .write(
            "Saving " + file.getFileName(),
            progress -> {
              Optional<FileStamp> there = expected.flatMap(stamp -> FileStamp.of(file));
              return there.equals(expected) || there.isEmpty()
                  ? new Attempt(true, DocumentFile.write(file, document, progress))
                  : new Attempt(false, there);
            },
            attempt -> {
              if (attempt.isWritten) {
                saved(editor, document, new Origin(file, attempt.stamp), then);
              } else {
                // A dialog waits for its answer; the queue of jobs must not wait with it.
                javax.swing.SwingUtilities.invokeLater(() -> askToOverwrite(editor, file, then));
              }
            });
  }

  private void saved(Editor editor, Document document, Origin origin, Runnable then) {
    origins.put(editor.domain(), origin);
    editor.saved(document, origin.file);
    if (DocumentFile.keepsAll(origin.file)) {
      editor.wishesSaved(document);
    }
    workbench.say("Saved " + origin.file);
    then.run();
  }

  private void askToOverwrite(Editor editor, Path file, Runnable then) {
    String question =
        file.getFileName()
            + " has been changed by another program or window since it was opened or saved here."
            + " Overwrite what is in it now?";
    switch (Ask.choose(window, "File Changed", question, 2, "Overwrite", "Save As…", "Cancel")) {
      case 0 -> save(editor, file, Optional.empty(), then);
      case 1 -> saveAs(editor, then);
      default -> {}
    }
  }

  /** The documents that have changes which are not saved. */
  List<String> unsaved() {
    return List.of(Domain.values()).stream()
        .map(workbench::editor)
        .filter(editor -> editor.history().isChanged() || editor.history().hasUnsavedWishes())
        .map(Editor::name)
        .toList();
  }
}
