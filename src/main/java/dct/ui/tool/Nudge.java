package dct.ui.tool;

import dct.core.geometry.Points;
import dct.render.Viewport;
import dct.ui.document.Document;
import dct.ui.document.Selection;

/** Moves the selection by arrow keys; all that is done until the keys are let go is one edit. */
final class Nudge {
  private static final int LARGE_STEP = 10;

  private VertexDrag drag; // null while no key is down
  private Points places;

  /** Moves the selection by a step, or with Shift by ten. */
  void move(ToolContext context, Key key) {
    Document document = context.document();
    Selection selection = context.selection();
    if (drag == null || !drag.isOf(document) || !drag.moving().equals(selection)) {
      drag = new VertexDrag(document, selection);
      places = selection.of(document.points());
    }
    Viewport view = context.viewport();
    double step = Spot.step(view) * (key.shift() ? LARGE_STEP : 1);
    places = stepped(view, key.right() * step, (view.yUp() ? -1 : 1) * key.down() * step);
    drag.preview(context, places);
  }

  private Points stepped(Viewport view, double dx, double dy) {
    double[] x = places.xs();
    double[] y = places.ys();
    for (int k = 0; k < x.length; k++) {
      x[k] = Spot.stepped(view, x[k], dx);
      y[k] = Spot.stepped(view, y[k], dy);
    }
    return Points.of(x, y);
  }

  /** The keys were let go. */
  void end(ToolContext context) {
    VertexDrag ended = drag;
    drag = null;
    if (ended != null && ended.isOf(context.document())) {
      ended.drop(context, places);
    }
  }
}
