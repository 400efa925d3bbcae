package dct.ui.tool;

import java.awt.event.KeyEvent;

/**
 * A key that was pressed on the canvas, without Control, Alt or Meta.
 *
 * @param code one of {@link KeyEvent}'s
 * @param shift whether the Shift key is down
 */
public record Key(int code, boolean shift) {
  /** The key that gives up. */
  public static final Key ESCAPE = new Key(KeyEvent.VK_ESCAPE, false);

  /** Whether it is one of the four arrows. */
  public boolean isArrow() {
    return right() != 0 || down() != 0;
  }

  /** 1 for the arrow to the right, −1 for that to the left, else 0. */
  public int right() {
    return switch (code) {
      case KeyEvent.VK_RIGHT, KeyEvent.VK_KP_RIGHT -> 1;
      case KeyEvent.VK_LEFT, KeyEvent.VK_KP_LEFT -> -1;
      default -> 0;
    };
  }

  /** 1 for the arrow downwards, −1 for that upwards, else 0. */
  public int down() {
    return switch (code) {
      case KeyEvent.VK_DOWN, KeyEvent.VK_KP_DOWN -> 1;
      case KeyEvent.VK_UP, KeyEvent.VK_KP_UP -> -1;
      default -> 0;
    };
  }
}
