package dct.ui;

import java.awt.GraphicsConfiguration;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import javax.swing.JFrame;

/** Finds places for windows on the screen. */
final class Placement {
  private static final int STEP = 36;

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
