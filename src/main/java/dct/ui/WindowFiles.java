package dct.ui;

import dct.core.triangulate.Domain;
import dct.ui.document.Document;
import dct.ui.document.Editor;
import dct.ui.file.ChangedFiles;
import dct.ui.file.Closing;
import dct.ui.file.FileDrop;
import dct.ui.file.FileWork;
import dct.ui.file.WindowHost;
import dct.ui.session.Journal;
import dct.ui.session.Journals;
import dct.ui.session.Orphan;
import dct.ui.session.Session;
import dct.ui.workbench.Workbench;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;

/**
 * The files of a window: what is opened, saved and dropped, what changes on the disk, what is kept
 * for the case that the program is killed, and what is asked before the window is closed.
 */
final class WindowFiles {
  private final Workbench workbench;
  private final WindowHost host;
  private final WindowDrawing drawing;
  private final FileWork files;
  private final Closing closing;
  private final ChangedFiles changed;
  private final WindowForFile forFile;
  private final List<Journal> journals;

  /**
   * The files of a window.
   *
   * @param close closes the window for good
   */
  WindowFiles(
      JFrame window,
      Workbench workbench,
      Session session,
      WindowHost host,
      WindowDrawing drawing,
      Runnable close) {
    this.workbench = workbench;
    this.host = host;
    this.drawing = drawing;
    files = new FileWork(window, workbench, session.recent(), drawing::showOpened);
    closing = new Closing(window, workbench, files, host, close);
    forFile = new WindowForFile(() -> isIdleAndEmpty() && !host.isLast(window), close);
    changed = new ChangedFiles(window, workbench, files::save, session.lane());
    journals =
        Domain.applications().stream().map(domain -> journal(session.journals(), domain)).toList();
    window.setTransferHandler(new FileDrop(this::openDropped));
  }

  private Journal journal(Journals all, Domain domain) {
    return all.of(
        workbench.editor(domain),
        e -> SwingUtilities.invokeLater(() -> workbench.say(all.sentence(e))));
  }

  /** Opening and saving. */
  FileWork work() {
    return files;
  }

  /** What is asked before the window is closed. */
  Closing closing() {
    return closing;
  }

  /** What the system tells of the files that are open. */
  ChangedFiles changed() {
    return changed;
  }

  /** Whether the window was opened for a file. */
  WindowForFile forFile() {
    return forFile;
  }

  /** Opens a file, and closes the window if nothing comes of it and it is not the last. */
  void openOrClose(Path file) {
    forFile.begin();
    files.open(file);
  }

  private void openDropped(List<Path> dropped) {
    dropped.stream().findFirst().ifPresent(files::open);
    host.open(dropped.stream().skip(1).toList());
  }

  private boolean isIdleAndEmpty() {
    return workbench.jobs().isIdle() && isFree(Domain.POLYGON) && isFree(Domain.SITES);
  }

  /** Whether this application of the window has nothing in it that would have to give way. */
  boolean isFree(Domain domain) {
    Editor editor = workbench.editor(domain);
    return editor.document().size() == 0 && !editor.history().isUnsaved();
  }

  /** Shows a drawing that was not saved when the program was killed; it still is not. */
  void recover(Orphan orphan) {
    Document document = orphan.document();
    workbench.choose(document.domain());
    workbench.chooseEdit();
    workbench.editor(document.domain()).recover(document, orphan.name(), orphan.origin());
    drawing.showOpened(false);
    workbench.say("Recovered " + orphan.name() + ", which is not saved yet");
  }

  /** Ends the journals: all is saved or given up. */
  void end() {
    journals.forEach(Journal::end);
  }
}
