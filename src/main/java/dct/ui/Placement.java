package dct.ui;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Frame;
import java.awt.GraphicsConfiguration;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import javax.swing.JFrame;
import javax.swing.Timer;

/** Finds places for windows on the screen. */
final class Placement {
  private static final int STEP = 36;
  private static final int SETTLE_MILLIS = 100;
  private static final int SETTLE_TIMES = 6;

  private Placement() {}

  /** Packs a window, no larger than the screen, and puts it into the middle. */
  static void centre(Window window) {
    window.pack();
    Rectangle screen = usable(window);
    if (window.getWidth() > screen.width || window.getHeight() > screen.height) {
      window.setSize(
          Math.min(window.getWidth(), screen.width), Math.min(window.getHeight(), screen.height));
    }
    window.setLocation(
        screen.x + (screen.width - window.getWidth()) / 2,
        screen.y + (screen.height - window.getHeight()) / 2);
  }

  /**
   * Sees to it that a component has its preferred size in the window that was just opened: the
   * widths of the frame's borders become known only some time after.
   */
  static void settle(JFrame window, Component component) {
    Timer timer = new Timer(SETTLE_MILLIS, null);
    int[] left = {SETTLE_TIMES};
    timer.addActionListener(
        e -> {
          boolean free = window.getExtendedState() == Frame.NORMAL && fits(window);
          if (free && !component.getSize().equals(component.getPreferredSize())) {
            centre(window);
          }
          if (--left[0] == 0) {
            timer.stop();
          }
        });
    timer.setInitialDelay(0);
    timer.start();
  }

  /**
   * Packs a window and puts it to the right of another, as far as the screen goes; over the owner,
   * windows are put one after the other a step down and right, below its menus.
   */
  static void beside(Window window, Window other, JFrame owner, int already) {
    window.pack();
    Rectangle screen = usable(owner);
    int step = STEP * (1 + already % 6);
    boolean overOwner = other == owner;
    int x = overOwner ? owner.getX() + step : other.getX() + other.getWidth();
    int y =
        overOwner ? owner.getContentPane().getLocationOnScreen().y + step - STEP / 2 : other.getY();
    if (!overOwner && x + window.getWidth() > screen.x + screen.width) {
      // No room on the right: to the left, or else as far right as there is room.
      int left = other.getX() - window.getWidth();
      x = left >= screen.x ? left : screen.x + screen.width - window.getWidth();
      y += STEP;
    }
    window.setLocation(
        Math.max(screen.x, Math.min(x, screen.x + screen.width - window.getWidth())),
        Math.max(screen.y, Math.min(y, screen.y + screen.height - window.getHeight())));
  }

  private static boolean fits(Window window) {
    Rectangle screen = usable(window);
    Dimension wished = window.getPreferredSize();
    return wished.width <= screen.width && wished.height <= screen.height;
  }

  private static Rectangle usable(Window window) {
    GraphicsConfiguration configuration = window.getGraphicsConfiguration();
    Rectangle screen = configuration.getBounds();
    Insets bars = Toolkit.getDefaultToolkit().getScreenInsets(configuration);
    return new Rectangle(
        screen.x + bars.left,
        screen.y + bars.top,
        screen.width - bars.left - bars.right,
        screen.height - bars.top - bars.bottom);
  }
}
