package dct.ui;

import java.nio.file.Path;
import java.util.List;
import javax.swing.SwingUtilities;

/** Opens the window. */
public final class Launcher {

  private Launcher() {}

  /**
   * Opens a window for each of these files, or an empty one; returns at once.
   *
   * @throws java.awt.HeadlessException if there is no display
   */
  public static void open(List<Path> files) {
    if (java.awt.GraphicsEnvironment.isHeadless()) {
      throw new java.awt.HeadlessException("there is no display");
    }
    Thread.setDefaultUncaughtExceptionHandler(FaultLog.ofUser());
    SwingUtilities.invokeLater(() -> openWindows(files));
  }

  private static void openWindows(List<Path> files) {
    Look.setUp();
    if (files.isEmpty()) {
      new MainWindow().setVisible(true);
    }
    for (Path file : files) {
      MainWindow window = new MainWindow();
      window.setVisible(true);
      window.open(file);
    }
  }
}
