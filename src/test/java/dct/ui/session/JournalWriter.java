package dct.ui.session;

import dct.core.triangulate.Domain;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.job.Jobs;
import java.nio.file.Path;
import javax.swing.SwingUtilities;

/**
 * A program of its own that draws a vertex after the other, says so after each, and waits to be
 * killed: {@code JournalWriter FOLDER}. It draws the next vertex when the one before is written.
 */
public final class JournalWriter {
  private JournalWriter() {}

  /** Draws until the process is killed. */
  public static void main(String[] args) throws Exception {
    Journals journals = new Journals(Path.of(args[0]), new Lane());
    Editor[] editor = new Editor[1];
    SwingUtilities.invokeAndWait(
        () -> {
          editor[0] = new Editor(Domain.SITES, new Jobs());
          journals.of(editor[0], e -> Runtime.getRuntime().halt(1));
        });
    for (int k = 1; k < 10_000; k++) {
      double x = k;
      SwingUtilities.invokeAndWait(
          () -> editor[0].perform(Edit.draw(editor[0].document(), x, x * x)));
      System.out.println(k);
      journals.await();
    }
  }
}
