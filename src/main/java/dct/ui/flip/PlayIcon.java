package dct.ui.flip;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Polygon;
import java.awt.RenderingHints;
import javax.swing.Icon;

/** The signs of a player, in the colour of the words beside them. */
enum PlayIcon implements Icon {
  FIRST(-1, true),
  BACK(-1, false),
  PLAY(2, false),
  PAUSE(0, true),
  FORWARD(1, false),
  LAST(1, true);

  private static final int SIZE = 14;

  private final int direction; // of the triangle; twice as large for playing; 0 for none
  private final boolean bar;

  PlayIcon(int direction, boolean bar) {
    this.direction = direction;
    this.bar = bar;
  }

  @Override
  public void paintIcon(Component c, Graphics g, int x, int y) {
    Graphics2D graphics = (Graphics2D) g.create();
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.setColor(c.getForeground());
    if (!c.isEnabled()) {
      graphics.setColor(javax.swing.UIManager.getColor("Button.disabledText"));
    }
    graphics.translate(x, y);
    if (direction < 0) {
      graphics.translate(SIZE, 0);
      graphics.scale(-1, 1);
    }
    draw(graphics);
    graphics.dispose();
  }

  /** Draws it pointing to the right. */
  private void draw(Graphics2D graphics) {
    if (direction == 0) {
      graphics.fillRect(2, 1, 4, SIZE - 2);
      graphics.fillRect(8, 1, 4, SIZE - 2);
      return;
    }
    int tip = Math.abs(direction) == 2 ? 13 : 10;
    int half = Math.abs(direction) == 2 ? 6 : 5;
    int left = bar ? 1 : 3;
    int middle = SIZE / 2;
    graphics.fill(
        new Polygon(
            new int[] {left, tip, left}, new int[] {middle - half, middle, middle + half}, 3));
    if (bar) {
      graphics.fillRect(11, middle - half, 2, 2 * half);
    }
  }

  @Override
  public int getIconWidth() {
    return SIZE;
  }

  @Override
  public int getIconHeight() {
    return SIZE;
  }
}
