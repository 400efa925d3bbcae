package dct.ui.file;

import dct.core.triangulate.Domain;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import dct.io.FileNames;
import dct.io.FileStamp;
import dct.problem.Instance;
import dct.ui.dialog.Ask;
import dct.ui.dialog.Chooser;
import dct.ui.document.Document;
import dct.ui.document.Editor;
import dct.ui.document.Layout;
import dct.ui.document.Origin;
import dct.ui.document.Result;
import dct.ui.job.Jobs;
import dct.ui.session.RecentFiles;
import java.awt.Component;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;

/** Writes documents to files that they have or that the user names, in the background. */
public final class Saving {
  private static final String SAVE_AS = "Save As";

  private final Jobs jobs;
  private final RecentFiles recent;
  private Optional<Path> folder = Optional.empty(); // used last

  /**
   * Where a document is asked to be saved.
   *
   * @param parent dialogs lie over it
   * @param said is told what was done
   */
  public record Asked(Component parent, Consumer<String> said) {}

  /** How an attempt to save ended; not well if another program has changed the file. */
  private record Attempt(boolean isWritten, Optional<FileStamp> stamp) {}

  /** Saving by these jobs. */
  Saving(Jobs jobs, RecentFiles recent) {
    this.jobs = jobs;
    this.recent = recent;
  }

  /** The folder of the file that was used last. */
  Optional<Path> folder() {
    return folder;
  }

  /** Says that a file is used. */
  void used(Path file) {
    Chooser.DOCUMENTS.used(file);
    folder = Optional.ofNullable(file.toAbsolutePath().getParent());
  }

  /** Saves a document to the file that it came from; asks if there is none. */
  void save(Asked by, Editor editor, Runnable then) {
    Optional<Origin> origin = editor.origin();
    if (origin.isPresent()) {
      write(by, editor, origin.get().file(), origin.get().stamp(), then);
    } else {
      saveAs(by, editor, then);
    }
  }

  /** Saves a document to the file that it came from if that keeps all of it; asks else. */
  void saveWhole(Asked by, Editor editor, Runnable then) {
    if (editor.origin().filter(o -> DocumentFile.keepsAll(o.file())).isPresent()) {
      save(by, editor, then);
    } else {
      saveWholeAs(by, editor, then);
    }
  }

  /** Asks where to save a document, and saves it. */
  void saveAs(Asked by, Editor editor, Runnable then) {
    Path suggested = suggestion(editor);
    ask(by, Unsaved.needsAll(editor) ? FileEnding.JSON.insteadOf(suggested) : suggested)
        .map(typed -> FileNames.forSaving(typed, editor.document().content()))
        .ifPresent(file -> replace(by, editor, file, then));
  }

  /** Asks where to save all of a document, and saves it. */
  void saveWholeAs(Asked by, Editor editor, Runnable then) {
    ask(by, FileEnding.JSON.insteadOf(suggestion(editor)))
        .map(typed -> forWhole(typed, editor.document().content()))
        .ifPresent(file -> replace(by, editor, file, then));
  }

  /** Asks until the name has no ending that promises a file of another kind. */
  private static Optional<Path> ask(Asked by, Path suggested) {
    Optional<Path> typed = Chooser.DOCUMENTS.save(by.parent, suggested, SAVE_AS);
    Optional<FileEnding> other = typed.flatMap(Saving::otherKind);
    if (other.isEmpty()) {
      return typed;
    }
    String exported = other.get().holds(Content.PICTURE) ? "Export Picture" : "Export Data";
    Ask.sorry(
        by.parent,
        SAVE_AS,
        "Save As writes files that end in .txt or .json. File ▸ "
            + exported
            + " writes "
            + other.get().dotted()
            + ".");
    return ask(by, FileEnding.JSON.insteadOf(typed.get()));
  }

  /** The ending of a name if files of it are exported, not saved. */
  private static Optional<FileEnding> otherKind(Path typed) {
    return FileEnding.of(typed, Content.POINTS, Content.TRIANGULATION, Content.PICTURE)
        .filter(ending -> ending != FileEnding.TXT && !FileEnding.JSON.isOf(ending.dotted()));
  }

  /** Where nothing else was typed, the ending is one of a file that keeps everything. */
  private static Path forWhole(Path typed, Domain domain) {
    Path file = FileNames.forSaving(typed, domain);
    boolean added = FileEnding.TXT.isOf(file.toString()) && !FileEnding.TXT.isOf(typed.toString());
    return added ? FileEnding.JSON.insteadOf(file) : file;
  }

  private void replace(Asked by, Editor editor, Path file, Runnable then) {
    if (isFree(by, file)) {
      write(by, editor, file, Optional.empty(), then);
    }
  }

  private static boolean isFree(Asked by, Path file) {
    return !Files.exists(file) || Chooser.confirmReplacing(by.parent, file);
  }

  /** The file that the document has, or a name for one. */
  private Path suggestion(Editor editor) {
    boolean named = FileNames.domain(Path.of(editor.name())).isPresent();
    int dot = editor.name().indexOf('.', 1);
    String stem = dot > 0 ? editor.name().substring(0, dot) : "untitled";
    String name =
        named ? editor.name() : stem + FileNames.suffix(editor.document().content()) + ".txt";
    return editor.origin().map(Origin::file).orElseGet(() -> inFolder(name));
  }

  private Path inFolder(String name) {
    return folder.map(f -> f.resolve(name)).orElse(Path.of(name));
  }

  /**
   * Saves to a file, but not over what another program has written to it.
   *
   * @param expected what the file should hold if it is there; nothing if that does not matter
   */
  private void write(
      Asked by, Editor editor, Path file, Optional<FileStamp> expected, Runnable then) {
    Document document = editor.document();
    used(file);
    jobs.write(
        "Saving " + file.getFileName(),
        progress -> {
          Optional<FileStamp> there = expected.flatMap(stamp -> FileStamp.of(file));
          return there.isEmpty() || there.equals(expected)
              ? new Attempt(true, DocumentFile.write(file, document, progress))
              : new Attempt(false, there);
        },
        attempt -> {
          if (attempt.isWritten) {
            saved(by, editor, document, new Origin(file, attempt.stamp));
            then.run();
          } else {
            // A dialog waits for its answer; the queue of jobs must not wait with it.
            SwingUtilities.invokeLater(() -> askToOverwrite(by, editor, file, then));
          }
        });
  }

  private void saved(Asked by, Editor editor, Document document, Origin origin) {
    if (DocumentFile.keepsAll(origin.file())) {
      editor.wholeSaved(document, origin);
    } else {
      editor.saved(document, origin);
    }
    say(by, origin.file(), Unsaved.needsAll(editor) || document.result().isPresent());
  }

  /** Says what was done, and how to keep more than points if there is more. */
  private void say(Asked by, Path file, boolean more) {
    recent.add(file);
    String cure =
        more && !DocumentFile.keepsAll(file)
            ? "; Save As with a name that ends in .json keeps wishes and triangulation, too"
            : "";
    by.said.accept("Saved " + file + cure);
  }

  private void askToOverwrite(Asked by, Editor editor, Path file, Runnable then) {
    String question =
        file.getFileName()
            + " has been changed by another program or window since it was opened or saved here."
            + " Overwrite what is in it now?";
    switch (Ask.choose(by.parent, "File Changed", question, 2, "Overwrite", "Save As…", "Cancel")) {
      case 0 -> write(by, editor, file, Optional.empty(), then);
      case 1 -> saveAs(by, editor, then);
      default -> {}
    }
  }

  /**
   * Asks where to save a result with its points, and saves it; no document has that file then.
   *
   * @param name of what it is a result of
   */
  void saveCopy(Asked by, Result result, String name) {
    Instance of = result.solution().instance();
    Layout layout =
        of instanceof Instance.OfRegion region ? Layout.of(region.region().rings()) : Layout.PLAIN;
    Document document =
        new Document(
            of.domain().application(), of.points(), layout, of.wishes(), Optional.of(result));
    String suggested = PictureExport.fileName(PictureExport.fileName(name) + " " + result.title());
    ask(by, inFolder(suggested + FileEnding.JSON.dotted()))
        .map(typed -> forWhole(typed, of.domain()))
        .filter(file -> isFree(by, file))
        .ifPresent(file -> writeCopy(by, document, file));
  }

  private void writeCopy(Asked by, Document document, Path file) {
    used(file);
    jobs.write(
        "Saving " + file.getFileName(),
        progress -> DocumentFile.write(file, document, progress),
        stamp -> say(by, file, true));
  }
}
