package dct.ui.file;

import java.nio.file.Path;
import java.util.List;
import javax.swing.JFrame;

/** What a main window asks of the others. */
public interface WindowHost {

  /** Opens another, empty window. */
  void openEmpty();

  /** Opens a window for each of these files. */
  void open(List<Path> files);

  /** Whether this is the only main window. */
  boolean isLast(JFrame window);
}
