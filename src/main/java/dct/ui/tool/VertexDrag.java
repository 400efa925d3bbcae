package dct.ui.tool;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.SegmentPoints.Place;
import dct.core.geometry.Sites;
import dct.core.triangulate.Domain;
import dct.render.Viewport;
import dct.ui.document.BulkEdit;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Selection;
import java.util.Optional;

/**
 * Vertices on their way to other places, all by the same amount, from when the mouse or a key takes
 * hold of them until they are let go. Until then only a preview shows them elsewhere.
 */
final class VertexDrag {
  private final Document start;
  private final Selection moving;

  /** Takes hold of vertices of the document. */
  VertexDrag(Document start, Selection moving) {
    this.start = start;
    this.moving = moving;
  }

  /** The vertices that are moved. */
  Selection moving() {
    return moving;
  }

  /** Whether the document is still the one that was taken hold of; an undo ends a drag. */
  boolean isOf(Document document) {
    return start.equals(document);
  }

  /**
   * Where a vertex goes when the mouse has moved: it keeps its distance from the mouse, unless it
   * snaps to something.
   *
   * @param vertex the one under the mouse
   * @param pressed where the mouse took hold of it
   */
  Target target(ToolContext context, int vertex, Spot pressed, Spot spot) {
    Viewport view = context.viewport();
    double x = start.points().x(vertex);
    double y = start.points().y(vertex);
    Spot carried =
        new Spot(
            view.screenX(x) + spot.screenX() - pressed.screenX(),
            view.screenY(y) + spot.screenY() - pressed.screenY(),
            carried(view, x, spot.x() - pressed.x()),
            carried(view, y, spot.y() - pressed.y()),
            1,
            spot.shift());
    return Snapping.of(context, carried, Optional.of(new Place(x, y)), moving::has);
  }

  /** A coordinate keeps its place if the mouse did not move. */
  private static double carried(Viewport view, double old, double by) {
    return by == 0 ? old : Spot.rounded(view, old + by);
  }

  /** The places of the moved vertices if this one goes there. */
  Points places(Viewport view, int vertex, double x, double y) {
    Points old = moving.of(start.points());
    double[] xs = old.xs();
    double[] ys = old.ys();
    double dx = x - start.points().x(vertex);
    double dy = y - start.points().y(vertex);
    int k = 0;
    for (int v = moving.next(0); v >= 0; v = moving.next(v + 1)) {
      xs[k] = v == vertex ? x : finite(Spot.stepped(view, xs[k], dx), xs[k]);
      ys[k] = v == vertex ? y : finite(Spot.stepped(view, ys[k], dy), ys[k]);
      k++;
    }
    return Points.of(xs, ys);
  }

  private static double finite(double value, double otherwise) {
    return Double.isFinite(value) ? value : otherwise;
  }

  /** Shows the vertices at these places. */
  void preview(ToolContext context, Points places) {
    context.preview(BulkEdit.moved(start.points(), moving, places));
  }

  /** Leaves the vertices at these places, in one edit, unless a site is there already. */
  void drop(ToolContext context, Points places) {
    Points moved = BulkEdit.moved(start.points(), moving, places);
    if (moved.equals(start.points())) {
      context.endPreview();
    } else if (moving.count() == 1) {
      dropOne(context, places.x(0), places.y(0));
    } else if (start.domain() == Domain.SITES && merged(moved) > merged(start.points())) {
      context.endPreview();
      context.say("Another site is already there; the selected ones went back");
    } else {
      context.perform(BulkEdit.move(start, moving, places));
    }
  }

  private static int merged(Points points) {
    return Sites.of(points, Progress.NONE).merged();
  }

  private void dropOne(ToolContext context, double x, double y) {
    int vertex = moving.next(0);
    int there = start.vertexAt(x, y);
    if (there >= 0 && start.domain() == Domain.SITES) {
      context.endPreview();
      context.say("v" + there + " is already there; v" + vertex + " went back");
    } else {
      context.perform(Edit.move(start, vertex, x, y));
    }
  }
}
