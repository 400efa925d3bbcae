package dct.ui.canvas;

import dct.ui.tool.Spot;
import dct.ui.tool.Tool;
import dct.ui.tool.ToolContext;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;

/** The one listener that turns the mouse on a canvas into calls of the chosen tool. */
public final class ToolMouse extends MouseAdapter {

  /** One of a tool's methods. */
  @FunctionalInterface
  private interface Call {
    void on(Tool tool, ToolContext context, Spot spot);
  }

  private final CanvasPanel canvas;
  private final Supplier<Optional<Tool>> tool;
  private final ToolContext context;
  private final Consumer<Spot> after;
  private boolean down; // the left button was pressed here and went to the tool

  /**
   * Listens to the canvas.
   *
   * @param tool the tool that is chosen
   * @param after is told the place after each event
   */
  public ToolMouse(
      CanvasPanel canvas,
      Supplier<Optional<Tool>> tool,
      ToolContext context,
      Consumer<Spot> after) {
    this.canvas = canvas;
    this.tool = tool;
    this.context = context;
    this.after = after;
    canvas.addMouseListener(this);
    canvas.addMouseMotionListener(this);
    canvas.setOverlay(pen -> tool.get().ifPresent(t -> t.paint(context, pen)));
  }

  @Override
  public void mousePressed(MouseEvent e) {
    if (SwingUtilities.isLeftMouseButton(e) && !e.isConsumed()) {
      down = true;
      call(e, Tool::pressed);
    }
  }

  @Override
  public void mouseDragged(MouseEvent e) {
    if (down) {
      call(e, Tool::dragged);
    }
  }

  @Override
  public void mouseReleased(MouseEvent e) {
    if (down && SwingUtilities.isLeftMouseButton(e)) {
      down = false;
      call(e, Tool::released);
    }
  }

  @Override
  public void mouseMoved(MouseEvent e) {
    call(e, Tool::moved);
  }

  @Override
  public void mouseExited(MouseEvent e) {
    if (!down) {
      tool.get().ifPresent(t -> t.left(context));
      canvas.setCorner("");
      canvas.repaint();
    }
  }

  private void call(MouseEvent e, Call call) {
    Spot spot = spot(e);
    tool.get().ifPresent(t -> call.on(t, context, spot));
    canvas.repaint();
    after.accept(spot);
  }

  /** A drag that leaves the canvas stays at its border: nothing can get lost outside. */
  private Spot spot(MouseEvent e) {
    int x = Math.max(0, Math.min(canvas.getWidth() - 1, e.getX()));
    int y = Math.max(0, Math.min(canvas.getHeight() - 1, e.getY()));
    return Spot.at(canvas.viewport(), x, y);
  }
}
