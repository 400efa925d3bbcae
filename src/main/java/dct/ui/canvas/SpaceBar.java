package dct.ui.canvas;

import java.awt.Component;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.HierarchyEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.beans.PropertyChangeListener;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;

/**
 * Whether the space bar is held for the canvas.
 *
 * <p>It is the canvas' while that has the keyboard, and also while the mouse was moved over the
 * canvas since the keyboard went to another component: whoever points at the canvas after a click
 * on a button means to pan, whoever goes to a button by keys means to press it. It never is while
 * text is typed.
 */
final class SpaceBar extends MouseAdapter implements KeyEventDispatcher {
  private static final String FOCUS_OWNER = "permanentFocusOwner";

  private final JComponent canvas;
  private final PropertyChangeListener focusMoved = e -> pointed = false;
  private boolean down;
  private boolean taken; // from the component that has the keyboard
  private boolean pointed; // the mouse was moved over the canvas since the keyboard moved

  SpaceBar(JComponent canvas) {
    this.canvas = canvas;
    canvas.addMouseListener(this);
    canvas.addMouseMotionListener(this);
    canvas.addHierarchyListener(
        e -> {
          if ((e.getChangeFlags() & HierarchyEvent.SHOWING_CHANGED) != 0) {
            listen();
          }
        });
  }

  private void listen() {
    KeyboardFocusManager manager = KeyboardFocusManager.getCurrentKeyboardFocusManager();
    manager.removeKeyEventDispatcher(this);
    manager.removePropertyChangeListener(FOCUS_OWNER, focusMoved);
    if (canvas.isShowing()) {
      manager.addKeyEventDispatcher(this);
      manager.addPropertyChangeListener(FOCUS_OWNER, focusMoved);
    }
  }

  /** Whether it is down. */
  boolean isDown() {
    return down;
  }

  /** Forgets that it is down: its release may go elsewhere. */
  void reset() {
    down = false;
    taken = false;
  }

  @Override
  public void mouseMoved(MouseEvent e) {
    pointed = true;
  }

  @Override
  public void mouseExited(MouseEvent e) {
    pointed = false;
  }

  @Override
  public boolean dispatchKeyEvent(KeyEvent e) {
    return switch (e.getID()) {
      case KeyEvent.KEY_PRESSED -> e.getKeyCode() == KeyEvent.VK_SPACE && pressed(e);
      case KeyEvent.KEY_TYPED -> e.getKeyChar() == ' ' && taken;
      default -> e.getKeyCode() == KeyEvent.VK_SPACE && released();
    };
  }

  private boolean pressed(KeyEvent e) {
    KeyboardFocusManager manager = KeyboardFocusManager.getCurrentKeyboardFocusManager();
    if (e.getModifiersEx() != 0
        || manager.getFocusedWindow() != SwingUtilities.getWindowAncestor(canvas)) {
      return taken;
    }
    Component owner = manager.getFocusOwner();
    boolean typing = owner instanceof JTextComponent text && text.isEditable();
    down |= owner == canvas || (pointed && !typing);
    taken |= down && owner != canvas;
    return taken;
  }

  private boolean released() {
    boolean consumed = taken;
    reset();
    return consumed;
  }
}
