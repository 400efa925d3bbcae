package dct.ui.tool;

import dct.core.triangulate.Domain;
import dct.render.Pen;
import java.awt.Cursor;
import java.awt.event.KeyEvent;

/**
 * A mouse mode: its name, key, description, pointer and hint, and what it does. Its methods are
 * called with the left button's presses, drags and releases, with moves without a button, and with
 * the keys that are pressed on the canvas.
 */
public interface Tool {

  /** What its checkbox is called. */
  String name();

  /** What it does, in a line, for its tooltip and the list of commands. */
  String description();

  /** The key that chooses it, one of {@link KeyEvent}'s. */
  int key();

  /** Whether this application has a use for it. */
  default boolean isFor(Domain application) {
    return true;
  }

  /** What the mouse pointer looks like. */
  default Cursor cursor() {
    return Cursor.getDefaultCursor();
  }

  /** What the next click will do, for the status line. */
  String hint(ToolContext context);

  /** The mouse was moved without a button. */
  default void moved(ToolContext context, Spot spot) {}

  /** The mouse left the canvas, or another tool was chosen. */
  default void left(ToolContext context) {}

  /** The button was pressed. */
  default void pressed(ToolContext context, Spot spot) {}

  /** The mouse was moved with the button down. */
  default void dragged(ToolContext context, Spot spot) {}

  /** The button was released. */
  default void released(ToolContext context, Spot spot) {}

  /**
   * A key was pressed.
   *
   * @return whether the tool has a use for it
   */
  default boolean keyPressed(ToolContext context, Key key) {
    return false;
  }

  /** A key was released, or the canvas lost the keyboard. */
  default void keysReleased(ToolContext context) {}

  /**
   * Gives up what was begun with the button still down.
   *
   * @return whether anything was
   */
  default boolean cancelled(ToolContext context) {
    return false;
  }

  /** Draws what the tool adds to the picture. */
  default void paint(ToolContext context, Pen pen) {}
}
