package dct.ui.session;

import dct.io.CannotWriteException;
import dct.io.FileLease;
import dct.ui.document.Editor;
import java.io.IOException;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** The journals of all programs of a user, in one folder. */
public final class Journals {
  private final Path folder;
  private final Lane lane;

  /** Journals in this folder, written in this lane. */
  public Journals(Path folder, Lane lane) {
    this.folder = folder;
    this.lane = lane;
  }

  /**
   * Keeps from now on what this editor holds and no file does.
   *
   * @param failed is told, in the lane, if it cannot be written
   */
  public Journal of(Editor editor, Consumer<IOException> failed) {
    return Journal.of(editor, folder, lane, failed);
  }

  /** Says why a journal could not be written, and what to do. */
  public String sentence(IOException e) {
    return "Edits are not kept for a crash: "
        + folder
        + " cannot be written, "
        + CannotWriteException.reason(e)
        + "; save often, or mend that and edit on";
  }

  /** Waits until everything is on the disk that is to be kept. */
  public void await() throws InterruptedException {
    lane.await();
  }

  /**
   * The drawings whose programs ended without saving or giving them up, the oldest first. They are
   * this program's until {@link Orphan#leave} or its end: no other one offers them meanwhile. A
   * journal that this program cannot read stays as it is: another version may have written it.
   *
   * @param unread is told of each of those, in a sentence for a person
   */
  public List<Orphan> orphans(Consumer<String> unread) {
    List<Orphan> orphans = new ArrayList<>();
    for (Path file : files()) {
      try {
        take(file).ifPresent(orphans::add);
      } catch (IOException e) {
        unread.accept(unreadable(file));
      }
    }
    orphans.sort(Comparator.comparing(Orphan::time));
    return orphans;
  }

  private List<Path> files() {
    List<Path> files = new ArrayList<>();
    if (Files.isDirectory(folder)) {
      try (DirectoryStream<Path> all = Files.newDirectoryStream(folder, "*" + JournalFile.ENDING)) {
        all.forEach(files::add);
      } catch (IOException | DirectoryIteratorException e) {
        // those that were seen
      }
    }
    return files;
  }

  private Optional<Orphan> take(Path file) throws IOException {
    Optional<FileLease> lease = JournalFile.lease(file);
    if (lease.isEmpty()) {
      return Optional.empty(); // its program is at work
    }
    Optional<Orphan> orphan = Optional.empty();
    try {
      orphan = Orphan.of(file, lease.get(), lane);
      if (orphan.isEmpty()) {
        JournalFile.delete(file); // killed before the first state was in it
      }
    } finally {
      if (orphan.isEmpty()) {
        lease.get().close();
      }
    }
    return orphan;
  }

  private static String unreadable(Path file) {
    return "A drawing that was not saved cannot be read by this version of the program, and is kept"
        + " as it is: "
        + file;
  }
}
