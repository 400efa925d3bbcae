package dct.docs;

import dct.ui.Look;
import dct.ui.MainWindow;
import dct.ui.ResultFrame;
import dct.ui.Windows;
import dct.ui.session.Session;
import java.awt.Frame;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Window;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import javax.imageio.ImageIO;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.MenuElement;
import javax.swing.SwingUtilities;

/**
 * Takes the picture docs/window.png: the sample for Figures 3.9 and 3.10, triangulated by
 * Partitioning-AQT, and after Perform Flip beside it. Needs a display of at least 1280 × 800 pixels
 * with a window manager, and nothing else on it.
 */
public final class WindowPicture {
  private static final Rectangle MAIN = new Rectangle(0, 0, 1276, 776);
  private static final Rectangle BEFORE = new Rectangle(36, 62, 602, 528);
  private static final Rectangle AFTER = new Rectangle(638, 62, 602, 528);
  private static final int SETTLE_MILLIS = 1500;

  private WindowPicture() {}

  /** Takes the picture. */
  public static void main(String[] args) throws Exception {
    MainWindow window =
        onEventThread(
            () -> {
              Look.setUp();
              Path state = Files.createTempDirectory("dct");
              MainWindow opened = new Windows(Session.in(state)).openWindow();
              opened.setBounds(MAIN);
              opened.open(Path.of("samples", "figure_3_09_convex_pieces_polygonbased.txt"));
              return opened;
            });
    Thread.sleep(SETTLE_MILLIS);
    click(window, "Convex Polygon Even Triangulation");
    ResultFrame before = results().get(0);
    click(window, "Perform Flip");
    ResultFrame after = results().get(1);
    place(before, BEFORE);
    place(after, AFTER);
    Rectangle seen = onEventThread(window::getBounds); // a window manager may have moved it
    ImageIO.write(new Robot().createScreenCapture(seen), "png", new File("docs", "window.png"));
    System.exit(0);
  }

  private static void click(MainWindow window, String name) throws Exception {
    JMenuItem item = onEventThread(() -> item(window.getJMenuBar(), name));
    SwingUtilities.invokeAndWait(item::doClick);
    Thread.sleep(SETTLE_MILLIS);
  }

  /** The menu item of this name below an element, or null. */
  private static JMenuItem item(MenuElement element, String name) {
    if (element instanceof JMenuItem item
        && !(element instanceof JMenu)
        && name.equals(item.getText())) {
      return item;
    }
    return Arrays.stream(element.getSubElements())
        .map(below -> item(below, name))
        .filter(found -> found != null)
        .findFirst()
        .orElse(null);
  }

  private static List<ResultFrame> results() {
    return Arrays.stream(Frame.getFrames())
        .filter(ResultFrame.class::isInstance)
        .map(ResultFrame.class::cast)
        .toList();
  }

  private static void place(Window window, Rectangle bounds) throws Exception {
    SwingUtilities.invokeAndWait(
        () -> {
          window.setBounds(bounds);
          window.toFront();
        });
    Thread.sleep(SETTLE_MILLIS);
  }

  private static <T> T onEventThread(Callable<T> work) throws Exception {
    FutureTask<T> task = new FutureTask<>(work);
    SwingUtilities.invokeAndWait(task);
    return task.get();
  }
}
