package dct.ui.file;

import dct.core.triangulate.Domain;
import dct.io.FileStamp;
import dct.io.format.Choice;
import dct.ui.dialog.Ask;
import dct.ui.dialog.Found;
import dct.ui.document.Editor;
import dct.ui.document.Origin;
import dct.ui.session.Lane;
import dct.ui.workbench.Workbench;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.Timer;

/**
 * Says above the canvas when another program or window has written to the file of the document, or
 * has removed it. Looks whenever the system tells of a change in the folder, and whenever the
 * window is used again. Nothing is taken from the file unless it is asked for. Lives on the event
 * thread; files are read in a lane.
 */
public final class ChangedFiles {
  private static final int RETRY_MILLIS = 200; // while the window itself writes files

  private final JFrame window;
  private final Workbench workbench;
  private final Runnable save;
  private final Lane lane;
  private final FolderWatch watch = new FolderWatch(() -> SwingUtilities.invokeLater(this::look));
  private final Map<Domain, Seen> seen = new EnumMap<>(Domain.class);
  private final ChangeBar bar = new ChangeBar();
  private final Timer retry = new Timer(RETRY_MILLIS, e -> look());
  private Optional<Seen> shown = Optional.empty(); // in the bar

  /**
   * What was seen last of a document's file.
   *
   * @param origin where the document is from
   * @param now what the file holds; nothing if it cannot be read
   * @param isAnswered whether the user has said what to do about it
   */
  private record Seen(Origin origin, Optional<FileStamp> now, boolean isAnswered) {

    boolean isChange() {
      return !now.equals(origin.stamp());
    }

    boolean isGone() {
      return now.isEmpty() && origin.stamp().isPresent();
    }
  }

  /**
   * The changes of the files of a window's documents.
   *
   * @param save saves the chosen application's document
   * @param lane where files are looked at
   */
  public ChangedFiles(JFrame window, Workbench workbench, Runnable save, Lane lane) {
    this.window = window;
    this.workbench = workbench;
    this.save = save;
    this.lane = lane;
    retry.setRepeats(false);
  }

  /** The line that says so, to be put above the canvas. */
  public JComponent bar() {
    return bar;
  }

  /** Follows the workbench: another document has another file. */
  public void refresh() {
    boolean others = false;
    for (Domain domain : Domain.applications()) {
      Optional<Origin> origin = workbench.editor(domain).origin();
      if (!origin.equals(Optional.ofNullable(seen.get(domain)).map(Seen::origin))) {
        origin.ifPresentOrElse(
            now -> seen.put(domain, new Seen(now, now.stamp(), false)), () -> seen.remove(domain));
        others = true;
      }
    }
    if (others) {
      look();
    }
    show();
  }

  /** Looks at the files in the background. */
  public void look() {
    Set<Path> files = new HashSet<>();
    seen.values().forEach(each -> files.add(each.origin.file().toAbsolutePath()));
    seen.forEach(this::look);
    watch.watch(files); // also of none: it lets go of a folder that is no longer needed
  }

  private void look(Domain domain, Seen before) {
    if (before.origin.stamp().isPresent()) { // else it cannot be told what the file held
      Origin origin = before.origin;
      lane.execute(
          () -> {
            Optional<FileStamp> now = FileStamp.of(origin.file());
            SwingUtilities.invokeLater(() -> found(domain, origin, now));
          });
    }
  }

  private void found(Domain domain, Origin origin, Optional<FileStamp> now) {
    Seen before = seen.get(domain);
    if (workbench.jobs().isWriting()) {
      retry.restart(); // it may be this window's own save
    } else if (before != null && before.origin.equals(origin) && !before.now.equals(now)) {
      Seen after = new Seen(origin, now, false);
      seen.put(domain, after);
      workbench.editor(domain).setFileLost(after.isGone());
      show();
    }
  }

  private void show() {
    Optional<Seen> open =
        workbench
            .domain()
            .map(seen::get)
            .filter(Seen::isChange)
            .filter(change -> !change.isAnswered);
    if (!open.equals(shown)) {
      shown = open;
      open.ifPresentOrElse(this::show, () -> bar.setVisible(false));
    }
  }

  private void show(Seen change) {
    String name = change.origin.name();
    ChangeBar.Answer keep =
        new ChangeBar.Answer("Keep Mine", 'K', "Goes on with the document as it is", this::keep);
    if (change.isGone()) {
      bar.show(
          name + " has been removed or cannot be read any more.",
          List.of(
              new ChangeBar.Answer("Save Again", 'A', "Writes the document to it", save), keep));
    } else {
      bar.show(
          name + " has been changed by another program or window.",
          List.of(
              new ChangeBar.Answer(
                  "Reload", 'R', "Takes over what is in it; Undo brings this back", this::reload),
              keep));
    }
  }

  /** From now on the document counts as not saved, and saving it asks before it overwrites. */
  private void keep() {
    Editor editor = active();
    seen.computeIfPresent(
        editor.domain(), (domain, change) -> new Seen(change.origin, change.now, true));
    editor.setFileLost(true);
    show();
  }

  private Editor active() {
    return workbench.active().orElseThrow(); // the bar is shown for a document only
  }

  /** Reads the file again; the document that was there is one Undo away. */
  private void reload() {
    Editor editor = active();
    Path file = editor.origin().orElseThrow().file();
    Choice choice = Choice.NONE.otherwise(editor.domain());
    workbench
        .jobs()
        .read(
            "Reloading " + file.getFileName(),
            progress -> Found.by(() -> DocumentFile.read(file, choice, progress)),
            found -> found.handOn(read -> reloaded(editor, read), unclear -> refuse(file)));
  }

  private void reloaded(Editor editor, DocumentFile.Read read) {
    if (!read.own() || read.document().domain() != editor.domain()) {
      SwingUtilities.invokeLater(() -> refuse(read.origin().file()));
      return;
    }
    editor.reloaded(read.document(), read.origin());
    String remark = read.remark().isEmpty() ? "" : "; " + read.remark();
    workbench.say("Reloaded " + read.origin().name() + remark);
  }

  private void refuse(Path file) {
    String sentence =
        file.getFileName()
            + " holds something else now than this document; nothing was changed. File ▸ Open"
            + " opens it.";
    Ask.sorry(window, "Reload", sentence);
  }

  /** Ends the watch. */
  public void end() {
    retry.stop();
    watch.close();
  }
}
