package dct.ui.canvas;

import java.awt.Cursor;
import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;

/**
 * Zooms a canvas with the wheel and pans it with the middle button, or with the left one while the
 * space bar is down. Events that it uses are consumed.
 */
final class Navigation extends MouseAdapter {
  private static final double ZOOM_STEP = 1.2;

  /** What moves the picture. */
  interface Target {
    /** Moves the picture by so many pixels. */
    void pan(double dx, double dy);

    /** Scales the picture with the place under (x, y) kept there. */
    void zoom(double factor, double x, double y);
  }

  private final JComponent canvas;
  private final Target target;
  private final SpaceBar space;
  private Point grabbed; // null while nothing is panned
  private Cursor cursor;

  Navigation(JComponent canvas, Target target) {
    this.canvas = canvas;
    this.target = target;
    canvas.addMouseListener(this);
    canvas.addMouseMotionListener(this);
    canvas.addMouseWheelListener(this);
    space = new SpaceBar(canvas);
    FocusLoss.of(canvas, this::release);
  }

  @Override
  public void mousePressed(MouseEvent e) {
    canvas.requestFocusInWindow();
    boolean pans =
        SwingUtilities.isMiddleMouseButton(e)
            || (space.isDown() && SwingUtilities.isLeftMouseButton(e));
    if (pans && grabbed == null) {
      grabbed = e.getPoint();
      cursor = canvas.getCursor();
      canvas.setCursor(Cursor.getPredefinedCursor(Cursor.MOVE_CURSOR));
      e.consume();
    }
  }

  @Override
  public void mouseDragged(MouseEvent e) {
    if (grabbed != null) {
      target.pan(e.getX() - grabbed.x, e.getY() - grabbed.y);
      grabbed = e.getPoint();
      e.consume();
    }
  }

  @Override
  public void mouseReleased(MouseEvent e) {
    if (grabbed != null) {
      drop();
      e.consume();
    }
  }

  private void drop() {
    grabbed = null;
    canvas.setCursor(cursor);
  }

  private void release() {
    space.reset();
    if (grabbed != null) {
      drop();
    }
  }

  @Override
  public void mouseWheelMoved(MouseWheelEvent e) {
    target.zoom(Math.pow(ZOOM_STEP, -e.getPreciseWheelRotation()), e.getX(), e.getY());
  }
}
