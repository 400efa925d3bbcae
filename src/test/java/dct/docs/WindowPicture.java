package dct.docs;

import dct.ui.MainWindow;
import dct.ui.Windows;
import dct.ui.menu.Look;
import dct.ui.session.Session;
import dct.ui.solve.ResultFrame;
import java.awt.Component;
import java.awt.Frame;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Window;
import java.awt.image.BufferedImage;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import javax.imageio.ImageIO;
import javax.swing.SwingUtilities;

/**
 * Takes the pictures of the README. docs/window.png: the sample for Figures 3.9 and 3.10,
 * triangulated by Partitioning-AQT, and after Perform Flip beside it. docs/sites.png: the sample
 * for Figure 3.12 with its optimum explained beside it, in the dark look. docs/flips.gif: Scan-Flip
 * on that sample, flip by flip. Needs a display of at least 1280 × 800 pixels with a window
 * manager, and nothing else on it.
 */
public final class WindowPicture {
  private static final Rectangle MAIN = new Rectangle(0, 0, 1276, 796);
  private static final Rectangle BEFORE = new Rectangle(30, 120, 476, 640);
  private static final Rectangle AFTER = new Rectangle(506, 120, 476, 640);
  private static final Rectangle NARROW = new Rectangle(0, 0, 900, 640); // Why? is beside it
  private static final int WHY_WIDTH = 376;
  private static final int SETTLE_MILLIS = 1500;
  private static final int FRAME_MILLIS = 900;

  private WindowPicture() {}

  /** Takes the pictures. */
  public static void main(String[] args) throws Exception {
    onEventThread(
        () -> {
          Look.setUp();
          return null;
        });
    takePolygon();
    takeSites();
    System.exit(0);
  }

  private static void takePolygon() throws Exception {
    MainWindow window = open("figure_3_09_convex_pieces_polygonbased.txt");
    perform(window, "Convex Polygon Even Triangulation");
    ResultFrame before = results().get(0);
    perform(window, "Perform Flip");
    ResultFrame after = results().get(1);
    place(before, BEFORE, window);
    place(after, AFTER, window);
    ImageIO.write(capture(window), "png", new File("docs", "window.png"));
    for (Window each : List.of(before, after, window)) {
      SwingUtilities.invokeAndWait(each::dispose);
    }
  }

  private static void takeSites() throws Exception {
    MainWindow window = open("figure_3_12_sites_pointbased.txt");
    perform(window, "Fit");
    perform(window, "Perform Flip");
    perform(window, "First Flip");
    int flips =
        onEventThread(
            () ->
                window.workbench().shown().solution().orElseThrow().flips().orElseThrow().flips());
    List<BufferedImage> frames = new ArrayList<>(List.of(capture(window.canvas())));
    for (int flip = 0; flip < flips; flip++) {
      perform(window, "Next Flip");
      frames.add(capture(window.canvas()));
    }
    AnimatedGif.write(frames, FRAME_MILLIS, new File("docs", "flips.gif"));
    takeReason(window);
  }

  private static void takeReason(MainWindow window) throws Exception {
    SwingUtilities.invokeAndWait(() -> window.setBounds(NARROW));
    perform(window, "Dark Look");
    perform(window, "Legend");
    perform(window, "Most Even Vertices");
    perform(window, "Fit");
    perform(window, "Why?");
    Window why =
        Arrays.stream(Window.getWindows())
            .filter(each -> "why".equals(each.getName()) && each.isShowing())
            .findFirst()
            .orElseThrow();
    place(why, new Rectangle(window.getWidth(), 0, WHY_WIDTH, window.getHeight()), window);
    ImageIO.write(capture(window, why), "png", new File("docs", "sites.png"));
  }

  private static MainWindow open(String sample) throws Exception {
    MainWindow window =
        onEventThread(
            () -> {
              Path state = Files.createTempDirectory("dct");
              MainWindow opened = new Windows(Session.in(state)).openWindow();
              opened.setBounds(MAIN);
              opened.open(Path.of("samples", sample));
              return opened;
            });
    Thread.sleep(2 * SETTLE_MILLIS);
    return window;
  }

  /** What the screen shows of windows or a part of one; a window manager may have moved them. */
  private static BufferedImage capture(Component... components) throws Exception {
    Rectangle seen =
        onEventThread(
            () ->
                Arrays.stream(components)
                    .map(each -> new Rectangle(each.getLocationOnScreen(), each.getSize()))
                    .reduce(Rectangle::union)
                    .orElseThrow());
    return new Robot().createScreenCapture(seen);
  }

  private static void perform(MainWindow window, String command) throws Exception {
    SwingUtilities.invokeAndWait(() -> window.commands().get(command).perform());
    Thread.sleep(SETTLE_MILLIS);
  }

  private static List<ResultFrame> results() {
    return Arrays.stream(Frame.getFrames())
        .filter(ResultFrame.class::isInstance)
        .map(ResultFrame.class::cast)
        .toList();
  }

  /** Puts a window over another, at this place of it. */
  private static void place(Window window, Rectangle bounds, Window over) throws Exception {
    SwingUtilities.invokeAndWait(
        () -> {
          Rectangle place = new Rectangle(bounds);
          place.translate(over.getX(), over.getY());
          window.setBounds(place);
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
