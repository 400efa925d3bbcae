package dct.ui.file;

import dct.core.triangulate.Domain;
import dct.io.FileEnding;
import dct.io.FileNames;
import dct.io.FileStamp;
import dct.io.format.Choice;
import dct.io.format.Shapes;
import dct.ui.canvas.CanvasPanel;
import dct.ui.dialog.Ask;
import dct.ui.dialog.Chooser;
import dct.ui.dialog.Found;
import dct.ui.dialog.ShapeChooser;
import dct.ui.document.Document;
import dct.ui.document.Editor;
import dct.ui.document.Origin;
import dct.ui.file.DocumentFile.Read;
import dct.ui.session.RecentFiles;
import dct.ui.workbench.Workbench;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;

/** What the File menu does to the documents. */
public final class FileWork {

  private final JFrame window;
  private final Workbench workbench;
  private final RecentFiles recent;
  private final Consumer<Boolean> shown;
  private Optional<Path> folder = Optional.empty(); // used last

  /** How an attempt to save ended; not well if another program has changed the file. */
  private record Attempt(boolean isWritten, Optional<FileStamp> stamp) {}

  /**
   * File work for a window.
   *
   * @param shown hears of another document put on the canvas, and whether its y grows upwards
   */
  public FileWork(JFrame window, Workbench workbench, RecentFiles recent, Consumer<Boolean> shown) {
    this.window = window;
    this.workbench = workbench;
    this.recent = recent;
    this.shown = shown;
  }

  /** Writes what this canvas shows to a picture that the user names. */
  void exportPicture(CanvasPanel canvas) {
    String name = workbench.active().map(Editor::name).orElse("canvas");
    PictureExport.ask(window, canvas, name, workbench.jobs(), workbench::say);
  }

  /** The folder of the chosen application's document, or else the one that was used last. */
  public Optional<Path> folder() {
    return workbench
        .active()
        .flatMap(Editor::origin)
        .map(origin -> origin.file().toAbsolutePath().getParent())
        .or(() -> folder);
  }

  /** Begins an empty document of the chosen application. */
  void startAnew() {
    workbench.active().ifPresent(editor -> unlessLost(editor, () -> startAnew(editor)));
  }

  private void startAnew(Editor editor) {
    editor.startAnew();
    workbench.chooseDraw();
    shown.accept(false);
  }

  /** Asks for a file and opens it. */
  public void open() {
    Chooser.DOCUMENTS.open(window, folder()).ifPresent(this::open);
  }

  /** Opens a file in the application that it belongs to; whatever fails, nothing changes. */
  public void open(Path typed) {
    Domain otherwise = workbench.domain().orElse(Domain.POLYGON);
    open(typed, Choice.NONE.otherwise(otherwise));
    used(typed);
  }

  private void open(Path typed, Choice choice) {
    workbench
        .jobs()
        .read(
            "Reading " + typed.getFileName(),
            progress -> Found.by(() -> DocumentFile.read(typed, choice, progress)),
            found -> found.handOn(this::offer, shapes -> choose(typed, choice, shapes)));
  }

  private void choose(Path typed, Choice choice, Shapes shapes) {
    String title = "Open " + typed.getFileName();
    ShapeChooser.ask(window, title, shapes, choice).ifPresent(chosen -> open(typed, chosen));
  }

  private void used(Path file) {
    folder = Optional.ofNullable(file.toAbsolutePath().getParent());
  }

  private void offer(Read read) {
    // A dialog waits for its answer; the queue of jobs must not wait with it.
    Editor editor = workbench.editor(read.document().domain());
    SwingUtilities.invokeLater(() -> unlessLost(editor, () -> show(read)));
  }

  private void show(Read read) {
    Optional<Origin> origin = Optional.of(read.origin()).filter(from -> read.own());
    show(read.document(), read.origin().name(), origin, read.yUp());
    recent.add(read.origin().file());
    if (!read.remark().isEmpty()) {
      workbench.say(read.remark());
    }
  }

  /** Opens a sample. */
  public void openSample(String name) {
    Document sample = Samples.read(name);
    unlessLost(
        workbench.editor(sample.domain()), () -> show(sample, name, Optional.empty(), false));
  }

  private void show(Document document, String name, Optional<Origin> origin, boolean yUp) {
    workbench.choose(document.domain());
    workbench.chooseEdit(); // a stray click should not add a vertex to what was opened
    workbench.editor(document.domain()).load(document, name, origin);
    shown.accept(yUp);
  }

  /** Does something that replaces the document; asks first if anything of it is not saved. */
  private void unlessLost(Editor editor, Runnable then) {
    if (!editor.history().isUnsaved()) {
      then.run();
      return;
    }
    switch (Ask.choose(
        window,
        "Unsaved Changes",
        Unsaved.sentence(editor) + " Save first?",
        0,
        "Save",
        "Don't Save",
        "Cancel")) {
      case 0 -> saveAll(editor, then);
      case 1 -> then.run();
      default -> {}
    }
  }

  /** The documents of which something is not saved. */
  List<Editor> unsaved() {
    return Stream.of(Domain.values())
        .map(workbench::editor)
        .filter(editor -> editor.history().isUnsaved())
        .toList();
  }

  /** Saves documents one after the other; what comes then comes only if all are saved. */
  void save(List<Editor> editors, Runnable then) {
    if (editors.isEmpty()) {
      then.run();
    } else {
      saveAll(editors.get(0), () -> save(editors.subList(1, editors.size()), then));
    }
  }

  /**
   * Saves a document with wishes and result; asks again if the file that is chosen keeps neither.
   */
  private void saveAll(Editor editor, Runnable then) {
    Runnable check = () -> SwingUtilities.invokeLater(() -> unlessLost(editor, then));
    boolean kept = editor.origin().filter(o -> DocumentFile.keepsAll(o.file())).isPresent();
    if (Unsaved.needsAll(editor) && !kept) {
      saveAs(editor, check);
    } else {
      save(editor, check);
    }
  }

  /**
   * Saves the chosen application's document to the file that it came from; asks if there is none.
   */
  void save() {
    workbench.active().ifPresent(editor -> save(editor, () -> {}));
  }

  /** Asks where to save the chosen application's document, and saves it. */
  void saveAs() {
    workbench.active().ifPresent(editor -> saveAs(editor, () -> {}));
  }

  private void save(Editor editor, Runnable then) {
    Optional<Origin> origin = editor.origin();
    if (origin.isPresent()) {
      save(editor, origin.get().file(), origin.get().stamp(), then);
    } else {
      saveAs(editor, then);
    }
  }

  private void saveAs(Editor editor, Runnable then) {
    Optional<Path> typed = Chooser.DOCUMENTS.save(window, suggestion(editor), "Save As");
    if (typed.isPresent()) {
      Path file = FileNames.forSaving(typed.get(), editor.domain());
      if (!Files.exists(file) || Chooser.confirmReplacing(window, file)) {
        save(editor, file, Optional.empty(), then);
      }
    }
  }

  /** The file that the document has, but one that keeps all of it. */
  private Path suggestion(Editor editor) {
    boolean named = FileNames.domain(Path.of(editor.name())).isPresent();
    int dot = editor.name().indexOf('.', 1);
    String stem = dot > 0 ? editor.name().substring(0, dot) : "untitled";
    String name = named ? editor.name() : stem + FileNames.suffix(editor.domain()) + ".txt";
    Path file =
        editor
            .origin()
            .map(Origin::file)
            .orElseGet(() -> folder.map(f -> f.resolve(name)).orElse(Path.of(name)));
    return Unsaved.needsAll(editor) ? FileEnding.JSON.insteadOf(file) : file;
  }

  /**
   * Saves to a file, but not over what another program has written to it.
   *
   * @param expected what the file should hold if it is there; nothing if that does not matter
   */
  private void save(Editor editor, Path file, Optional<FileStamp> expected, Runnable then) {
    Document document = editor.document();
    used(file);
    workbench
        .jobs()
        .write(
            "Saving " + file.getFileName(),
            progress -> {
              Optional<FileStamp> there = expected.flatMap(stamp -> FileStamp.of(file));
              return there.isEmpty() || there.equals(expected)
                  ? new Attempt(true, DocumentFile.write(file, document, progress))
                  : new Attempt(false, there);
            },
            attempt -> {
              if (attempt.isWritten) {
                saved(editor, document, new Origin(file, attempt.stamp), then);
              } else {
                // A dialog waits for its answer; the queue of jobs must not wait with it.
                SwingUtilities.invokeLater(() -> askToOverwrite(editor, file, then));
              }
            });
  }

  private void saved(Editor editor, Document document, Origin origin, Runnable then) {
    recent.add(origin.file());
    String kept = "";
    if (DocumentFile.keepsAll(origin.file())) {
      editor.wholeSaved(document, origin);
    } else {
      editor.saved(document, origin);
      kept =
          Unsaved.needsAll(editor)
              ? "; Save As with a name that ends in .json keeps wishes and triangulation, too"
              : "";
    }
    workbench.say("Saved " + origin.file() + kept);
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
}
