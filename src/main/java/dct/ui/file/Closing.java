package dct.ui.file;

import dct.ui.dialog.Ask;
import dct.ui.document.Editor;
import dct.ui.job.Jobs;
import dct.ui.workbench.Workbench;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JFrame;

/** Closes a window, but not before what would be lost by that has been named. */
public final class Closing {
  private static final String TITLE = "Exit";

  private final JFrame window;
  private final Workbench workbench;
  private final FileWork files;
  private final WindowHost host;
  private final Runnable close;
  private boolean waiting; // until all files are written

  /**
   * Closing of a window.
   *
   * @param close closes it for good
   */
  public Closing(
      JFrame window, Workbench workbench, FileWork files, WindowHost host, Runnable close) {
    this.window = window;
    this.workbench = workbench;
    this.files = files;
    this.host = host;
    this.close = close;
  }

  /** Asks, and closes the window, once what is being saved is in its file. */
  public void begin() {
    begin(host.isLast(window) ? "Close the application?" : "Close this window?", close);
  }

  /**
   * Asks as before closing the window, and then does something instead: the whole program is to be
   * ended, and other windows are to be asked yet.
   */
  public void agree(Runnable then) {
    begin("Close the application with all its windows?", then);
  }

  /** Whether closing would lose anything or end what goes on. */
  public boolean hasSomethingToLose() {
    Jobs jobs = workbench.jobs();
    return !files.unsaved().isEmpty() || jobs.isWriting() || !jobs.work().isEmpty();
  }

  private void begin(String question, Runnable then) {
    Jobs jobs = workbench.jobs();
    if (jobs.isWriting() && !waiting) {
      waiting = true;
      workbench.say(
          "Closing as soon as what is being saved is in its file; Exit again asks at once");
      jobs.write("Closing", progress -> true, written -> ask(question, then));
    } else {
      ask(question, then);
    }
  }

  private void ask(String question, Runnable then) {
    waiting = false;
    List<Editor> unsaved = files.unsaved();
    String whole = whole(question, unsaved);
    if (unsaved.isEmpty()) {
      if (Ask.confirm(window, TITLE, whole, TITLE)) {
        then.run();
      }
      return;
    }
    switch (Ask.choose(window, TITLE, whole, 0, "Save", "Don't Save", "Cancel")) {
      case 0 -> files.save(unsaved, then);
      case 1 -> then.run();
      default -> {}
    }
  }

  private String whole(String question, List<Editor> unsaved) {
    List<String> sentences = new ArrayList<>();
    sentences.add(question);
    List<String> work = workbench.jobs().work();
    if (!work.isEmpty()) {
      sentences.add("What is going on would end: " + String.join(", ", work) + ".");
    }
    unsaved.forEach(editor -> sentences.add(Unsaved.sentence(editor)));
    return String.join(" ", sentences);
  }
}
