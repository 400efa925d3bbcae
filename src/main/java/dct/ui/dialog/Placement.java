package dct.ui.dialog;

import dct.ui.session.Settings;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Frame;
import java.awt.GraphicsConfiguration;
import java.awt.GraphicsEnvironment;
import java.awt.Insets;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import javax.swing.JFrame;
import javax.swing.Timer;

/** Finds places for windows on the screen. */
public final class Placement {
  private static final int STEP = 36;
  private static final int LEAST = 100;
  private static final String PLACED = "dct.placed"; // of a window whose size is not to change
  private static final int SETTLE_MILLIS = 100;
  private static final int SETTLE_TIMES = 6;

  private Placement() {}

  /** Packs a window, no larger than the screen, and puts it into the middle. */
  public static void centre(Window window) {
    Rectangle screen = usable(window);
    packWithin(window, screen);
    window.setLocation(
        screen.x + (screen.width - window.getWidth()) / 2,
        screen.y + (screen.height - window.getHeight()) / 2);
  }

  /** Packs a window, no larger than the screen, and puts it over the middle of another. */
  public static void over(Window window, Window other) {
    Rectangle screen = usable(other);
    packWithin(window, screen);
    window.setLocation(over(window.getSize(), other.getBounds(), screen));
  }

  /** Where a window lies over the middle of another and within the screen. */
  static Point over(Dimension window, Rectangle other, Rectangle screen) {
    int x = other.x + (other.width - window.width) / 2;
    int y = other.y + (other.height - window.height) / 2;
    return new Point(
        Math.max(screen.x, Math.min(x, screen.x + screen.width - window.width)),
        Math.max(screen.y, Math.min(y, screen.y + screen.height - window.height)));
  }

  private static void packWithin(Window window, Rectangle screen) {
    window.pack();
    if (window.getWidth() > screen.width || window.getHeight() > screen.height) {
      window.setSize(
          Math.min(window.getWidth(), screen.width), Math.min(window.getHeight(), screen.height));
    }
  }

  /**
   * Puts a window where it was when the settings were told of it, also on another screen than the
   * first, or else into the middle.
   */
  public static void restore(JFrame window, Settings settings) {
    centre(window);
    OptionalInt x = settings.number("window.x");
    OptionalInt y = settings.number("window.y");
    OptionalInt width = settings.number("window.width");
    OptionalInt height = settings.number("window.height");
    if (x.isPresent() && y.isPresent() && width.isPresent() && height.isPresent()) {
      Rectangle bounds =
          new Rectangle(x.getAsInt(), y.getAsInt(), width.getAsInt(), height.getAsInt());
      placed(bounds, screens())
          .ifPresent(
              there -> {
                window.setBounds(there);
                setPlaced(window);
              });
    }
    if (settings.isOn("window.maximized")) {
      window.setExtendedState(Frame.MAXIMIZED_BOTH);
    }
  }

  /**
   * Where a window can be that had these bounds: on the screen that shows most of it; nowhere if no
   * screen shows enough to use it.
   */
  static Optional<Rectangle> placed(Rectangle window, List<Rectangle> screens) {
    return screens.stream()
        .filter(screen -> isReachable(window, screen))
        .max(Comparator.comparingLong(screen -> area(window.intersection(screen))))
        .map(screen -> noLarger(window, screen));
  }

  private static long area(Rectangle part) {
    return (long) part.width * part.height;
  }

  /** These bounds, made smaller where the screen is: it may have been a larger one before. */
  static Rectangle noLarger(Rectangle window, Rectangle screen) {
    boolean wide = window.width > screen.width;
    boolean high = window.height > screen.height;
    return new Rectangle(
        wide ? screen.x : window.x,
        high ? screen.y : window.y,
        wide ? screen.width : window.width,
        high ? screen.height : window.height);
  }

  /** Whether enough of a window is on the screen to use it and move it. */
  private static boolean isReachable(Rectangle window, Rectangle screen) {
    Rectangle seen = window.intersection(screen);
    return seen.width >= LEAST && seen.height >= LEAST && window.y >= screen.y;
  }

  /** Tells the settings where a window is. */
  public static void remember(JFrame window, Settings settings) {
    boolean maximized = (window.getExtendedState() & Frame.MAXIMIZED_BOTH) != 0;
    settings.put("window.maximized", maximized);
    if (!maximized) {
      Rectangle bounds = window.getBounds();
      settings.put("window.x", bounds.x);
      settings.put("window.y", bounds.y);
      settings.put("window.width", bounds.width);
      settings.put("window.height", bounds.height);
    }
  }

  /** Gives a window the size of another, a step lower and further right if there is room. */
  public static void below(JFrame window, JFrame other) {
    window.setBounds(below(other.getBounds(), usable(other)));
    setPlaced(window);
  }

  /**
   * The bounds of a window of the size of another, all of it on the screen: a step lower and
   * further right, or in the corner where there is no room for that. Where the other one is in the
   * corner itself, the window becomes smaller, so that both titles can be seen.
   */
  static Rectangle below(Rectangle other, Rectangle screen) {
    Rectangle step = new Rectangle(other.x + STEP, other.y + STEP, other.width, other.height);
    if (screen.contains(step)) {
      return step;
    }
    boolean corner = other.x - screen.x < STEP && other.y - screen.y < STEP;
    int aside = corner ? STEP : 0;
    return new Rectangle(
        screen.x + aside,
        screen.y + aside,
        Math.min(other.width, screen.width - aside),
        Math.min(other.height, screen.height - aside));
  }

  /** Says that somebody has chosen the place and size of a window. */
  public static void setPlaced(JFrame window) {
    window.getRootPane().putClientProperty(PLACED, true);
  }

  /**
   * Sees to it that a component has its preferred size in the window that was just opened: the
   * widths of the frame's borders become known only some time after. What the window comes to hold
   * meanwhile, as a line above the canvas, takes its room from the component: the window does not
   * move away from under the mouse.
   *
   * @return what does so; it stops by itself
   */
  public static Timer settle(JFrame window, Component component) {
    Timer timer = new Timer(SETTLE_MILLIS, null);
    if (isPlaced(window)) {
      return timer;
    }
    Dimension opened = window.getContentPane().getPreferredSize();
    int[] left = {SETTLE_TIMES};
    timer.addActionListener(
        e -> {
          boolean free =
              window.getExtendedState() == Frame.NORMAL
                  && fits(window)
                  && !isPlaced(window)
                  && window.getContentPane().getPreferredSize().equals(opened);
          if (free && !component.getSize().equals(component.getPreferredSize())) {
            centre(window);
          }
          if (--left[0] == 0) {
            timer.stop();
          }
        });
    timer.setInitialDelay(0);
    timer.start();
    return timer;
  }

  private static boolean isPlaced(JFrame window) {
    return Boolean.TRUE.equals(window.getRootPane().getClientProperty(PLACED));
  }

  private static boolean fits(Window window) {
    Rectangle screen = usable(window);
    Dimension wished = window.getPreferredSize();
    return wished.width <= screen.width && wished.height <= screen.height;
  }

  /** The part of the screen of a window that no bar of the desktop takes. */
  public static Rectangle usable(Window window) {
    return usable(window.getGraphicsConfiguration());
  }

  /** The usable parts of all screens. */
  private static List<Rectangle> screens() {
    GraphicsEnvironment here = GraphicsEnvironment.getLocalGraphicsEnvironment();
    return Arrays.stream(here.getScreenDevices())
        .map(device -> usable(device.getDefaultConfiguration()))
        .toList();
  }

  private static Rectangle usable(GraphicsConfiguration configuration) {
    Rectangle screen = configuration.getBounds();
    Insets bars = Toolkit.getDefaultToolkit().getScreenInsets(configuration);
    return new Rectangle(
        screen.x + bars.left,
        screen.y + bars.top,
        screen.width - bars.left - bars.right,
        screen.height - bars.top - bars.bottom);
  }
}
