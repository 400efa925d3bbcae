package dct.ui.tool;

import dct.core.geometry.Points;
import dct.core.geometry.SegmentPoints;
import dct.core.geometry.SegmentPoints.Place;
import dct.render.Viewport;
import java.util.Optional;

/**
 * A place on an edge near the mouse: exactly on it where numbers allow it.
 *
 * @param from one end
 * @param to the other end
 * @param x the place's x in the model
 * @param y the place's y in the model
 * @param exact whether the place lies on the line through both ends without rounding
 */
record EdgePoint(int from, int to, double x, double y, boolean exact) {
  /** A place so near to the mouse is taken for the sake of coordinates with few digits. */
  private static final double PIXELS = 2;

  /** The place at from + t (to − from), or so near to it that nobody can tell. */
  static EdgePoint of(Points points, Viewport view, int from, int to, double t) {
    double ax = points.x(from);
    double ay = points.y(from);
    double bx = points.x(to);
    double by = points.y(to);
    double x = ax * (1 - t) + bx * t;
    double y = ay * (1 - t) + by * t;
    if (t == 0 || t == 1) {
      return new EdgePoint(from, to, x, y, true);
    }
    if (ax == bx && isBetween(ay, Spot.rounded(view, y), by)) {
      return new EdgePoint(from, to, ax, Spot.rounded(view, y), true);
    }
    if (ay == by && isBetween(ax, Spot.rounded(view, x), bx)) {
      return new EdgePoint(from, to, Spot.rounded(view, x), ay, true);
    }
    Optional<Place> on =
        points.same(from, to)
            ? Optional.empty()
            : SegmentPoints.near(ax, ay, bx, by, t, PIXELS / view.scale());
    return on.map(p -> new EdgePoint(from, to, p.x(), p.y(), true))
        .orElse(new EdgePoint(from, to, x, y, false));
  }

  /** The name of the edge. */
  String name() {
    return "v" + from + "–v" + to;
  }

  /** How far it is from a spot, in pixels. */
  double distance(Viewport view, Spot spot) {
    return Math.hypot(view.screenX(x) - spot.screenX(), view.screenY(y) - spot.screenY());
  }

  private static boolean isBetween(double a, double value, double b) {
    return (a < value && value < b) || (b < value && value < a);
  }
}
