package dct.ui;

import dct.ui.dialog.FaultLog;
import dct.ui.menu.Look;
import dct.ui.session.Orphan;
import dct.ui.session.Session;
import java.nio.file.Path;
import java.util.ArrayList;
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
    Session session = Session.ofUser();
    Look.setUp(session.settings());
    Windows windows = new Windows(session);
    if (files.isEmpty()) {
      windows.openWindow();
    } else {
      windows.open(files);
    }
    Thread search = new Thread(() -> recover(session, windows), "recovery");
    search.setDaemon(true);
    search.start();
  }

  private static void recover(Session session, Windows windows) {
    List<String> unread = new ArrayList<>();
    List<Orphan> orphans = session.journals().orphans(unread::add);
    SwingUtilities.invokeLater(() -> windows.offer(orphans, unread));
  }
}
