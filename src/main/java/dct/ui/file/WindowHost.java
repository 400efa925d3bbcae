package dct.ui.file;

import java.nio.file.Path;
import java.util.List;
import javax.swing.JFrame;

/** What a main window asks of the others. */
public interface WindowHost {

  /** Opens another, empty window. */
  void openEmpty();

  /** Opens a window for each of these files; none stays open for one that is not read. */
  void open(List<Path> files);

  /**
   * Closes all windows, this one first, and so ends the program; asks in each that would lose
   * something, and closes none if one answer is Cancel.
   */
  void exit(JFrame from);

  /** Whether this is the only main window. */
  boolean isLast(JFrame window);
}
