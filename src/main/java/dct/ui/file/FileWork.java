package dct.ui.file;

import dct.core.triangulate.Domain;
import dct.io.format.Choice;
import dct.io.format.Drawing;
import dct.io.format.UnclearInput;
import dct.ui.canvas.CanvasPanel;
import dct.ui.dialog.Ask;
import dct.ui.dialog.Chooser;
import dct.ui.dialog.Found;
import dct.ui.dialog.WhatIsMeant;
import dct.ui.document.Document;
import dct.ui.document.Editor;
import dct.ui.document.Origin;
import dct.ui.document.Result;
import dct.ui.file.DocumentFile.Read;
import dct.ui.session.RecentFiles;
import dct.ui.workbench.Workbench;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;

/** What the File menu does to the documents. */
public final class FileWork {

  private final JFrame window;
  private final Workbench workbench;
  private final RecentFiles recent;
  private final Consumer<Boolean> shown;
  private final Saving saving;

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
    saving = new Saving(workbench.jobs(), recent);
  }

  /** Writes what this canvas shows to a picture that the user names. */
  void exportPicture(CanvasPanel canvas) {
    String name = workbench.active().map(Editor::name).orElse("canvas");
    PictureExport.ask(window, canvas, name, workbench.jobs(), workbench::say);
  }

  /** Whether the chosen application's document has any points. */
  boolean hasPoints() {
    return workbench.active().filter(editor -> editor.document().size() > 0).isPresent();
  }

  /** Writes the chosen application's document to a file of another program. */
  void exportData() {
    workbench.active().ifPresent(this::exportData);
  }

  private void exportData(Editor editor) {
    Document document = editor.document();
    String name = PictureExport.fileName(editor.name());
    Drawing drawing = document.drawing(name, workbench.solution());
    DataExport.ask(window, drawing, name, workbench.jobs(), workbench::say);
  }

  /** The folder of the chosen application's document, or else the one that was used last. */
  public Optional<Path> folder() {
    return workbench
        .active()
        .flatMap(Editor::origin)
        .map(origin -> origin.file().toAbsolutePath().getParent())
        .or(saving::folder);
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
    saving.used(typed);
  }

  private void open(Path typed, Choice choice) {
    workbench
        .jobs()
        .read(
            "Reading " + typed.getFileName(),
            progress -> Found.by(() -> DocumentFile.read(typed, choice, progress)),
            found -> found.handOn(this::offer, unclear -> choose(typed, choice, unclear)));
  }

  private void choose(Path typed, Choice choice, UnclearInput unclear) {
    String title = "Open " + typed.getFileName();
    WhatIsMeant.ask(window, title, unclear, choice).ifPresent(chosen -> open(typed, chosen));
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
    return Domain.applications().stream()
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
    if (Unsaved.needsAll(editor)) {
      saving.saveWhole(here(), editor, check);
    } else {
      saving.save(here(), editor, check);
    }
  }

  /**
   * Saves the chosen application's document to the file that it came from; asks if there is none.
   */
  public void save() {
    workbench.active().ifPresent(editor -> saving.save(here(), editor, () -> {}));
  }

  /** Asks where to save the chosen application's document, and saves it. */
  void saveAs() {
    workbench.active().ifPresent(editor -> saving.saveAs(here(), editor, () -> {}));
  }

  /**
   * Saves the document with a result that is shown somewhere, to the file that the document came
   * from if that keeps it all; asks else. A result that is no longer, or not yet, the one of the
   * document goes into a file of its own.
   */
  public void save(Saving.Asked by, Result result, String name) {
    ownerOf(result)
        .ifPresentOrElse(
            editor -> saving.saveWhole(by, editor, () -> {}),
            () -> saving.saveCopy(by, result, name));
  }

  /** Asks where to save the document with a result that is shown somewhere, and saves it. */
  public void saveAs(Saving.Asked by, Result result, String name) {
    ownerOf(result)
        .ifPresentOrElse(
            editor -> saving.saveWholeAs(by, editor, () -> {}),
            () -> saving.saveCopy(by, result, name));
  }

  /** The editor of the document that has this result now. */
  private Optional<Editor> ownerOf(Result result) {
    return Domain.applications().stream()
        .map(workbench::editor)
        .filter(editor -> editor.document().result().equals(Optional.of(result)))
        .findFirst();
  }

  private Saving.Asked here() {
    return new Saving.Asked(window, workbench::say);
  }
}
