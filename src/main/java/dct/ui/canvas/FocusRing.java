package dct.ui.canvas;

import java.awt.Color;
import java.awt.Graphics;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import javax.swing.JComponent;
import javax.swing.UIManager;

/**
 * A line round a component that has been reached by the keyboard and has the focus. Who clicks on
 * the component knows that it has the focus, and sees no line.
 */
final class FocusRing extends MouseAdapter implements FocusListener {
  private static final int WIDTH = 2;

  private final JComponent component;
  private boolean reached; // by the keyboard

  FocusRing(JComponent component) {
    this.component = component;
    component.addFocusListener(this);
    component.addMouseListener(this);
  }

  @Override
  public void focusGained(FocusEvent e) {
    switch (e.getCause()) {
      case TRAVERSAL, TRAVERSAL_BACKWARD, TRAVERSAL_DOWN, TRAVERSAL_FORWARD, TRAVERSAL_UP ->
          reached = true;
      case MOUSE_EVENT -> reached = false;
      default -> {} // the window came back: as before
    }
    component.repaint();
  }

  @Override
  public void focusLost(FocusEvent e) {
    reached = reached && e.isTemporary();
    component.repaint();
  }

  @Override
  public void mousePressed(MouseEvent e) {
    reached = false;
    component.repaint();
  }

  /** Draws the line, if it is to be seen. */
  void paint(Graphics g) {
    if (reached && component.isFocusOwner()) {
      Color before = g.getColor();
      g.setColor(UIManager.getColor("Component.accentColor"));
      for (int i = 0; i < WIDTH; i++) {
        g.drawRect(i, i, component.getWidth() - 1 - 2 * i, component.getHeight() - 1 - 2 * i);
      }
      g.setColor(before);
    }
  }
}
