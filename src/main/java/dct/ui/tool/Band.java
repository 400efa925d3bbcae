package dct.ui.tool;

import dct.core.geometry.Box;
import dct.core.geometry.Points;
import dct.render.Ink;
import dct.render.Pen;
import dct.render.Stroke;
import dct.render.Viewport;
import dct.ui.document.Selection;
import java.util.BitSet;

/**
 * A rectangle drawn with the mouse round the vertices to select.
 *
 * @param from the corner where it began
 * @param to the corner where the mouse is
 */
record Band(Spot from, Spot to) {

  /** The vertices inside, in linear time. */
  Selection inside(Points points, Viewport view) {
    Box box = box();
    BitSet inside = new BitSet();
    for (int v = 0; v < points.size(); v++) {
      if (box.holds(view.screenX(points.x(v)), view.screenY(points.y(v)))) {
        inside.set(v);
      }
    }
    return Selection.of(inside);
  }

  private Box box() {
    return new Box(
        Math.min(from.screenX(), to.screenX()),
        Math.min(from.screenY(), to.screenY()),
        Math.max(from.screenX(), to.screenX()),
        Math.max(from.screenY(), to.screenY()));
  }

  /** Draws the rectangle. */
  void paint(Pen pen) {
    Box box = box();
    pen.style(Stroke.dashed(Ink.HIGHLIGHT, 1.4));
    pen.line(box.minX(), box.minY(), box.maxX(), box.minY());
    pen.line(box.maxX(), box.minY(), box.maxX(), box.maxY());
    pen.line(box.maxX(), box.maxY(), box.minX(), box.maxY());
    pen.line(box.minX(), box.maxY(), box.minX(), box.minY());
  }
}
