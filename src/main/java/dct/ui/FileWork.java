package dct.ui;

import dct.core.Progress;
import dct.core.geometry.InvalidGeometryException;
import dct.core.triangulate.Domain;
import dct.io.CannotWriteException;
import dct.io.FileNames;
import dct.io.PointDocument;
import dct.io.PointFile;
import dct.problem.Instance;
import dct.ui.canvas.CanvasPanel;
import dct.ui.document.Document;
import dct.ui.document.Editor;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.JFrame;

/** What the File menu does to the documents. */
final class FileWork {
  private final JFrame window;
  private final Workbench workbench;
  private final Runnable shown;
  private Optional<Path> folder = Optional.empty();

  /**
   * What was read from a file.
   *
   * @param merged how many sites were in it twice
   */
  private record Read(Document document, String name, int merged) {}

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
    PictureExport.ask(window, canvas, name, workbench.jobs());
  }

  /** The folder of the file that was opened or saved last. */
  Optional<Path> folder() {
    return folder;
  }

  /** Begins an empty document of the chosen application. */
  void startAnew() {
    workbench.active().ifPresent(editor -> unlessLost(editor, () -> startAnew(editor)));
  }

  private void startAnew(Editor editor) {
    editor.startAnew();
    workbench.chooseDraw();
    shown.run();
  }

  /** Asks for a file and opens it. */
  void open() {
    Chooser.DOCUMENTS.open(window, folder).ifPresent(this::open);
  }

  /** Opens a file in the application that it belongs to; whatever fails, nothing changes. */
  void open(Path typed) {
    Domain otherwise = workbench.domain().orElse(Domain.POLYGON);
    workbench
        .jobs()
        .read(
            "Reading " + typed.getFileName(),
            progress -> read(typed, otherwise, progress),
            this::offer);
    folder = Optional.ofNullable(typed.toAbsolutePath().getParent());
  }

  private static Read read(Path typed, Domain otherwise, Progress progress) {
    PointDocument read = PointFile.read(typed, progress);
    Domain domain = read.declared().orElse(otherwise);
    Instance instance = read.declared(domain).instance(progress);
    String name = FileNames.forOpening(typed).getFileName().toString();
    return new Read(new Document(domain, instance.points()), name, instance.merged());
  }

  /** Opens a sample. */
  void openSample(String name) {
    offer(new Read(Samples.read(name), name, 0));
  }

  private void offer(Read read) {
    unlessLost(workbench.editor(read.document.domain()), () -> show(read));
  }

  private void show(Read read) {
    Domain domain = read.document.domain();
    workbench.choose(domain);
    workbench.chooseEdit(); // a stray click should not add a vertex to what was opened
    workbench.editor(domain).load(read.document, read.name);
    shown.run();
    if (read.merged > 0) {
      workbench.say(read.merged + " sites were there already and have been merged");
    }
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
    switch (Ask.choose(window, "Unsaved Changes", question, "Save", "Discard", "Cancel")) {
      case 0 -> save(editor, then);
      case 1 -> then.run();
      default -> {}
    }
  }

  /** Asks where to save the chosen application's document, and saves it. */
  void save() {
    workbench.active().ifPresent(editor -> save(editor, () -> {}));
  }

  private void save(Editor editor, Runnable then) {
    if (!acceptsUnreadable(editor.document())) {
      return;
    }
    Optional<Path> typed = Chooser.DOCUMENTS.save(window, suggestion(editor));
    if (typed.isPresent()) {
      Path file = FileNames.forSaving(typed.get(), editor.domain());
      if (!Files.exists(file) || Chooser.confirmReplacing(window, file)) {
        save(editor, file, then);
      }
    }
  }

  private Path suggestion(Editor editor) {
    if (editor.file().isPresent()) {
      return editor.file().get();
    }
    boolean sample = FileNames.domain(Path.of(editor.name())).isPresent();
    Path name = Path.of(sample ? editor.name() : "untitled" + FileNames.suffix(editor.domain()));
    return folder.map(f -> f.resolve(name)).orElse(name);
  }

  /** A file that cannot be opened again is saved only if the user insists. */
  private boolean acceptsUnreadable(Document document) {
    Optional<String> fault = fault(document);
    return fault
        .map(
            sentence ->
                Ask.confirm(
                    window,
                    "Save",
                    "This cannot be opened again as it is: " + sentence + ". Save it all the same?",
                    "Save"))
        .orElse(true);
  }

  /** Why points cannot be triangulated, and so not be opened. */
  private static Optional<String> fault(Document document) {
    try {
      document.instance("", Progress.NONE);
      return Optional.empty();
    } catch (InvalidGeometryException e) {
      return Optional.of(e.defect().message());
    }
  }

  private void save(Editor editor, Path file, Runnable then) {
    Document document = editor.document();
    folder = Optional.ofNullable(file.toAbsolutePath().getParent());
    workbench
        .jobs()
        .write(
            "Saving " + file.getFileName(),
            progress -> write(file, document, progress),
            written -> {
              editor.saved(document, written);
              workbench.say("Saved " + written);
              then.run();
            });
  }

  private static Path write(Path file, Document document, Progress progress) {
    try {
      PointFile.write(file, document.domain(), document.points(), progress);
      return file;
    } catch (CannotWriteException e) {
      throw new UncheckedIOException(e);
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
