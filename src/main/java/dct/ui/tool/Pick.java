package dct.ui.tool;

import dct.core.geometry.Points;
import dct.render.Ink;
import dct.render.Pen;
import dct.render.Scene;
import dct.render.Stroke;
import dct.render.Viewport;
import dct.ui.document.Analysis;
import java.util.Optional;

/** Finds what lies under the mouse, in linear time. */
final class Pick {
  /** How far from the mouse a vertex may be, in pixels. */
  static final double REACH = 9;

  /**
   * An edge and the point on it that is nearest to the mouse.
   *
   * @param from one end
   * @param to the other end
   * @param x the point's x in the model
   * @param y the point's y in the model
   */
  record EdgePoint(int from, int to, double x, double y) {}

  private Pick() {}

  /** The vertex nearest to the spot, if it is within reach; −1 if none is. */
  static int vertex(Points points, Viewport view, Spot spot) {
    int nearest = -1;
    double least = REACH * REACH;
    for (int v = 0; v < points.size(); v++) {
      double dx = view.screenX(points.x(v)) - spot.screenX();
      double dy = view.screenY(points.y(v)) - spot.screenY();
      double square = dx * dx + dy * dy;
      // Of several at one distance the last wins: it is drawn on top.
      if (square <= least) {
        least = square;
        nearest = v;
      }
    }
    return nearest;
  }

  /** How far a vertex is from the spot, in pixels. */
  static double distance(Points points, Viewport view, int v, Spot spot) {
    return Math.hypot(
        view.screenX(points.x(v)) - spot.screenX(), view.screenY(points.y(v)) - spot.screenY());
  }

  /** The point nearest to the spot on any edge shown; nothing if there are no edges. */
  static Optional<EdgePoint> edge(Analysis shown, Viewport view, Spot spot) {
    Search search = new Search(shown.document().points(), view, spot);
    shown.scene().visitNear(view, spot.screenX(), spot.screenY(), search);
    return Optional.ofNullable(search.best);
  }

  /** Draws a ring round a vertex. */
  static void mark(Pen pen, Viewport view, double x, double y) {
    pen.style(Stroke.solid(Ink.HIGHLIGHT, 2));
    pen.ring(view.screenX(x), view.screenY(y), REACH - 1);
  }

  /** Measures on the screen, where tiny and huge coordinates are no trouble. */
  private static final class Search implements Scene.EdgeVisitor {
    private final Points points;
    private final Viewport view;
    private final Spot spot;
    private double least = Double.POSITIVE_INFINITY;
    private EdgePoint best;

    Search(Points points, Viewport view, Spot spot) {
      this.points = points;
      this.view = view;
      this.spot = spot;
    }

    @Override
    public double visit(int from, int to) {
      double ax = view.screenX(points.x(from));
      double ay = view.screenY(points.y(from));
      double dx = view.screenX(points.x(to)) - ax;
      double dy = view.screenY(points.y(to)) - ay;
      double px = spot.screenX() - ax;
      double py = spot.screenY() - ay;
      double square = dx * dx + dy * dy;
      double t = square == 0 ? 0 : Math.max(0, Math.min(1, (px * dx + py * dy) / square));
      double distance = Math.hypot(px - t * dx, py - t * dy);
      if (distance < least) {
        least = distance;
        double x = points.x(from) * (1 - t) + points.x(to) * t;
        double y = points.y(from) * (1 - t) + points.y(to) * t;
        best = new EdgePoint(from, to, Spot.rounded(view, x), Spot.rounded(view, y));
      }
      return least;
    }
  }
}
