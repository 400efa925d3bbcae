package dct.ui.canvas;

import dct.core.geometry.Points;
import dct.render.Pen;
import dct.ui.tool.Key;
import dct.ui.tool.Spot;
import dct.ui.tool.Tool;
import dct.ui.tool.ToolContext;
import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;

/** The one listener that turns mouse and keys on a canvas into calls of the chosen tool. */
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
  private final Clicks clicks = new Clicks();
  private final CanvasKeys keys;
  private boolean down; // the left button was pressed here and went to the tool
  private Spot last; // what was told last
  private Optional<Point> mouse = Optional.empty(); // where it is on the canvas, if it is there

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
    keys =
        new CanvasKeys(
            canvas,
            this::keyPressed,
            this::keysReleased,
            spot -> call(spot, Tool::moved),
            this::clickedByKey);
    last = Spot.at(canvas.viewport(), 0, 0);
    canvas.addMouseListener(this);
    canvas.addMouseMotionListener(this);
    canvas.addViewListener(this::viewChanged);
    canvas.addOverlay(this::paint);
    FocusLoss.of(canvas, this::giveUp);
  }

  private void paint(Pen pen) {
    tool.get()
        .ifPresent(
            t -> {
              paintSelection(pen);
              t.paint(context, pen);
            });
    keys.paint(pen);
  }

  private void paintSelection(Pen pen) {
    Points shown = context.shown().document().points();
    Points own = context.document().points();
    // While a large document is being analysed, what is shown is an older one.
    Points points = shown.size() == own.size() ? shown : own;
    SelectionMarks.paint(
        pen, context.selection(), points, canvas.viewport(), canvas.getWidth(), canvas.getHeight());
  }

  private boolean keyPressed(Key key) {
    boolean used = tool.get().map(t -> t.keyPressed(context, key)).orElse(false);
    if (used) {
      canvas.repaint();
      after.accept(last);
    }
    return used;
  }

  private void keysReleased() {
    tool.get().ifPresent(t -> t.keysReleased(context));
  }

  private void clickedByKey(Spot spot) {
    call(spot, Tool::pressed);
    call(spot, Tool::released);
  }

  /** What the mouse has begun cannot be ended in a window that has lost the keyboard. */
  private void giveUp() {
    if (down) {
      down = false;
      tool.get().ifPresent(t -> t.cancelled(context));
      canvas.repaint();
    }
  }

  /** Another place is under a mouse that is still; the picture is moved by a mouse that is down. */
  private void viewChanged() {
    if (!down) {
      SwingUtilities.invokeLater(this::lookAgain); // after whatever else changes with the view
    }
  }

  private void lookAgain() {
    if (mouse.isPresent() && !down && !keys.isShown()) {
      call(spot(mouse.get(), last.shift()), Tool::moved);
    }
  }

  @Override
  public void mousePressed(MouseEvent e) {
    if (SwingUtilities.isLeftMouseButton(e) && !e.isConsumed()) {
      down = true;
      call(spot(e).clicked(clicks.count(e.getWhen(), e.getPoint())), Tool::pressed);
    }
  }

  @Override
  public void mouseDragged(MouseEvent e) {
    if (down) {
      call(spot(e), Tool::dragged);
    } else {
      mouse = Optional.of(e.getPoint()); // it pans
    }
  }

  @Override
  public void mouseReleased(MouseEvent e) {
    if (down && SwingUtilities.isLeftMouseButton(e)) {
      down = false;
      call(spot(e), Tool::released);
    }
  }

  @Override
  public void mouseMoved(MouseEvent e) {
    call(spot(e), Tool::moved);
  }

  @Override
  public void mouseExited(MouseEvent e) {
    mouse = Optional.empty();
    if (!down) {
      tool.get().ifPresent(t -> t.left(context));
      canvas.setCorner("");
      canvas.repaint();
    }
  }

  private void call(Spot spot, Call call) {
    last = spot;
    tool.get().ifPresent(t -> call.on(t, context, spot));
    canvas.repaint();
    after.accept(spot);
  }

  private Spot spot(MouseEvent e) {
    mouse = Optional.of(e.getPoint());
    Spot spot = spot(e.getPoint(), e.isShiftDown());
    keys.mouseAt(spot);
    return spot;
  }

  /** A drag that leaves the canvas stays at its border: nothing can get lost outside. */
  private Spot spot(Point place, boolean shift) {
    int x = Math.max(0, Math.min(canvas.getWidth() - 1, place.x));
    int y = Math.max(0, Math.min(canvas.getHeight() - 1, place.y));
    return Spot.at(canvas.viewport(), x, y).withShift(shift);
  }
}
