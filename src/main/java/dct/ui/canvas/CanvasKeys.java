package dct.ui.canvas;

import dct.render.Ink;
import dct.render.Pen;
import dct.render.Stroke;
import dct.render.Viewport;
import dct.ui.tool.Key;
import dct.ui.tool.Spot;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.util.function.Consumer;
import java.util.function.Predicate;

/**
 * The keyboard on a canvas. A key goes to the tool first. Arrows of which that makes no use move a
 * cross, by one unit of the model or with Shift by ten; while it is shown, Space and Enter click
 * there; where they did so already, Enter is the tool's, to end a drawing. The mouse takes it away.
 *
 * <p>The unit is 1 while a unit has between a tenth of a pixel and ten pixels, and the power of ten
 * that has as many in other scales.
 */
final class CanvasKeys extends KeyAdapter {
  private static final int LARGE_STEP = 10;
  private static final double ARM = 11; // of the cross, in pixels
  private static final double GAP = 3;

  private final CanvasPanel canvas;
  private final Predicate<Key> tool;
  private final Consumer<Spot> moved;
  private final Consumer<Spot> clicked;
  private boolean shown;
  private boolean wasClicked; // where it is
  private double x; // of the cross, in the model
  private double y;

  /**
   * Listens to the keys of the canvas.
   *
   * @param tool does what a key means to it, if anything
   * @param released is run when keys are no longer held
   * @param moved is told where the cross went
   * @param clicked is told where it was clicked
   */
  CanvasKeys(
      CanvasPanel canvas,
      Predicate<Key> tool,
      Runnable released,
      Consumer<Spot> moved,
      Consumer<Spot> clicked) {
    this.canvas = canvas;
    this.tool = tool;
    this.moved = moved;
    this.clicked = clicked;
    canvas.addKeyListener(this);
    canvas.addKeyListener(
        new KeyAdapter() {
          @Override
          public void keyReleased(KeyEvent e) {
            released.run();
          }
        });
    canvas.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent e) {
            released.run();
          }
        });
  }

  @Override
  public void keyPressed(KeyEvent e) {
    boolean plain = !e.isControlDown() && !e.isAltDown() && !e.isMetaDown();
    boolean givesUp = e.getKeyCode() == KeyEvent.VK_ESCAPE; // the window says what
    if (plain && !givesUp && isUsed(new Key(e.getKeyCode(), e.isShiftDown()))) {
      e.consume();
    }
  }

  private boolean isUsed(Key key) {
    boolean enter = key.code() == KeyEvent.VK_ENTER;
    if (!shown || !(enter || key.code() == KeyEvent.VK_SPACE)) {
      return tool.test(key) || (key.isArrow() && move(key));
    }
    if (!enter || !wasClicked || !tool.test(key)) {
      wasClicked = true;
      clicked.accept(spot(key.shift()));
    }
    return true;
  }

  private boolean move(Key key) {
    Viewport view = canvas.viewport();
    double step = Spot.step(view) * (key.shift() ? LARGE_STEP : 1);
    x = Spot.stepped(view, x, key.right() * step);
    y = Spot.stepped(view, y, (view.yUp() ? -1 : 1) * key.down() * step);
    shown = true;
    wasClicked = false;
    keepInSight();
    moved.accept(spot(key.shift()));
    return true;
  }

  private void keepInSight() {
    double outX = outside(canvas.viewport().screenX(x), canvas.getWidth() - 1.0);
    double outY = outside(canvas.viewport().screenY(y), canvas.getHeight() - 1.0);
    if (outX != 0 || outY != 0) {
      canvas.pan(-outX, -outY);
    }
  }

  private static double outside(double place, double last) {
    return place < 0 ? place : Math.max(0, place - last);
  }

  private Spot spot(boolean shift) {
    Viewport view = canvas.viewport();
    return new Spot(view.screenX(x), view.screenY(y), x, y, 1, shift);
  }

  /** Takes the cross away; it comes back where the mouse is now. */
  void mouseAt(Spot spot) {
    shown = false;
    wasClicked = false;
    x = spot.x();
    y = spot.y();
  }

  /** Whether the cross is there, and not the mouse, where things are done. */
  boolean isShown() {
    return shown;
  }

  /** Draws the cross. */
  void paint(Pen pen) {
    if (shown) {
      double px = canvas.viewport().screenX(x);
      double py = canvas.viewport().screenY(y);
      pen.style(Stroke.solid(Ink.LABEL, 1.5));
      pen.line(px - ARM, py, px - GAP, py);
      pen.line(px + GAP, py, px + ARM, py);
      pen.line(px, py - ARM, px, py - GAP);
      pen.line(px, py + GAP, px, py + ARM);
    }
  }
}
