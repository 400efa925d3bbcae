package dct.ui.tool;

import dct.core.Decimals;
import dct.render.Ink;
import dct.render.Pen;
import dct.render.Stroke;
import dct.render.Viewport;

/**
 * Where a vertex goes that is drawn or dragged.
 *
 * @param x its x in the model
 * @param y its y in the model
 * @param hit what it snaps to, for a person to read; empty if it is just where the mouse is
 */
record Target(double x, double y, String hit) {
  private static final double RADIUS = 6;

  /** Whether it is exactly this place. */
  boolean isAt(double otherX, double otherY) {
    return x == otherX && y == otherY;
  }

  /** Draws a ring round what is hit. */
  void mark(Pen pen, Viewport view) {
    if (!hit.isEmpty()) {
      pen.style(Stroke.solid(Ink.HIGHLIGHT, 2));
      pen.ring(view.screenX(x), view.screenY(y), RADIUS);
    }
  }

  /** Where it is, behind a hint; nothing if it is just where the mouse is. */
  String words() {
    return hit.isEmpty()
        ? ""
        : " at (" + Decimals.format(x) + ", " + Decimals.format(y) + "), " + hit;
  }
}
