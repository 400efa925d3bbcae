package dct.ui.dialog;

import java.awt.EventQueue;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;

/**
 * The key that has opened a dialog: as long as it is held, it is no text for the field that has the
 * focus there.
 */
final class HeldKey implements KeyEventDispatcher {
  private final int code;

  private HeldKey(int code) {
    this.code = code;
  }

  /** Keeps the key whose event is being handled, if it is one, from typing anything. */
  static void typesNothing() {
    if (EventQueue.getCurrentEvent() instanceof KeyEvent key
        && key.getID() == KeyEvent.KEY_PRESSED) {
      manager().addKeyEventDispatcher(new HeldKey(key.getKeyCode()));
    }
  }

  private static KeyboardFocusManager manager() {
    return KeyboardFocusManager.getCurrentKeyboardFocusManager();
  }

  @Override
  public boolean dispatchKeyEvent(KeyEvent e) {
    boolean held =
        e.getID() == KeyEvent.KEY_TYPED
            || (e.getID() == KeyEvent.KEY_PRESSED && e.getKeyCode() == code);
    if (!held) {
      manager().removeKeyEventDispatcher(this); // it was released, or another one is pressed
    }
    return held;
  }
}
