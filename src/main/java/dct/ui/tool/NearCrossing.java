package dct.ui.tool;

import dct.core.geometry.Line;
import dct.core.geometry.Points;
import dct.core.geometry.SegmentPoints;
import dct.core.geometry.SegmentPoints.Place;
import dct.render.Viewport;
import dct.ui.document.Analysis;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.function.Predicate;
import java.util.function.Supplier;

/**
 * The crossings within reach of a place: of two edges, or of an edge with a direction. Where the
 * edges lie so dense that more than some come within reach, only some are looked at.
 *
 * <p>A crossing has the doubles nearest to it. That with a level or upright direction is met in
 * this direction exactly; that with another one, whose numbers are rounded anyway, lies exactly on
 * the edge if there is such a point a small part of a pixel away.
 */
final class NearCrossing {
  private static final int MOST_EDGES = 32;
  private static final double TELLABLE = 0.1; // pixels that nobody can tell apart

  private record Edge(int from, int to) {
    boolean meets(Edge other) {
      return from == other.from || from == other.to || to == other.from || to == other.to;
    }

    @Override
    public String toString() {
      return "v" + from + "–v" + to;
    }
  }

  private final Points points;
  private final Viewport view;
  private final Spot spot;
  private final List<Edge> edges = new ArrayList<>();

  /**
   * Looks for the edges.
   *
   * @param shown what holds the edges
   * @param spot the place near which crossings are looked for
   * @param allowed the vertices that edges may have as ends
   */
  NearCrossing(Analysis shown, Viewport view, Spot spot, IntPredicate allowed) {
    points = shown.document().points();
    this.view = view;
    this.spot = spot;
    shown
        .scene()
        .visitNear(
            view,
            spot.screenX(),
            spot.screenY(),
            (a, b) -> {
              if (edges.size() < MOST_EDGES
                  && allowed.test(a)
                  && allowed.test(b)
                  && !points.same(a, b)
                  && distance(a, b) <= Pick.REACH) {
                edges.add(new Edge(a, b));
              }
              return Pick.REACH;
            });
  }

  private double distance(int a, int b) {
    return Line2D.ptSegDist(
        view.screenX(points.x(a)),
        view.screenY(points.y(a)),
        view.screenX(points.x(b)),
        view.screenY(points.y(b)),
        spot.screenX(),
        spot.screenY());
  }

  /** The nearest crossing of two edges that have no end in common. */
  Optional<Target> ofEdges() {
    Optional<Target> nearest = Optional.empty();
    for (int i = 0; i < edges.size(); i++) {
      Edge one = edges.get(i);
      for (Edge other : edges.subList(0, i)) {
        if (!one.meets(other)) {
          String hit = "on the crossing of " + other + " and " + one;
          nearest =
              line(one)
                  .crossing(line(other))
                  .filter(place -> isOn(one, place) && isOn(other, place))
                  .map(place -> new Target(place.x(), place.y(), hit))
                  .filter(isNearerThan(nearest))
                  .or(orElse(nearest));
        }
      }
    }
    return nearest;
  }

  /**
   * The nearest crossing of an edge with a direction.
   *
   * @param origin where the direction begins
   * @param dx along it
   * @param dy along it
   * @param words what the direction is called
   */
  Optional<Target> inDirection(Place origin, double dx, double dy, String words) {
    Line direction = Line.along(origin.x(), origin.y(), dx, dy);
    Optional<Target> nearest = Optional.empty();
    for (Edge edge : edges) {
      nearest =
          line(edge)
              .crossing(direction)
              .filter(p -> isOn(edge, p))
              .filter(p -> (p.x() - origin.x()) * dx + (p.y() - origin.y()) * dy > 0)
              .map(p -> dx == 0 || dy == 0 ? p : onEdge(edge, p))
              .map(p -> new Target(p.x(), p.y(), "on " + edge + " " + words))
              .filter(isNearerThan(nearest))
              .or(orElse(nearest));
    }
    return nearest;
  }

  private static Supplier<Optional<Target>> orElse(Optional<Target> nearest) {
    return () -> nearest;
  }

  private Predicate<Target> isNearerThan(Optional<Target> nearest) {
    double least = nearest.map(target -> distance(target.x(), target.y())).orElse(Pick.REACH);
    return target -> distance(target.x(), target.y()) <= least;
  }

  private double distance(double x, double y) {
    return Math.hypot(view.screenX(x) - spot.screenX(), view.screenY(y) - spot.screenY());
  }

  private Line line(Edge edge) {
    return Line.through(
        points.x(edge.from()), points.y(edge.from()), points.x(edge.to()), points.y(edge.to()));
  }

  /** Whether a place on the line of an edge is between its ends or at one. */
  private boolean isOn(Edge edge, Place place) {
    return isBetween(points.x(edge.from()), place.x(), points.x(edge.to()))
        && isBetween(points.y(edge.from()), place.y(), points.y(edge.to()));
  }

  private static boolean isBetween(double a, double value, double b) {
    return Math.min(a, b) <= value && value <= Math.max(a, b);
  }

  private Place onEdge(Edge edge, Place place) {
    double ax = points.x(edge.from());
    double ay = points.y(edge.from());
    double bx = points.x(edge.to());
    double by = points.y(edge.to());
    boolean wide = Math.abs(bx - ax) >= Math.abs(by - ay);
    double t = wide ? (place.x() - ax) / (bx - ax) : (place.y() - ay) / (by - ay);
    double within = TELLABLE / view.scale();
    return SegmentPoints.near(ax, ay, bx, by, t, within)
        .filter(p -> Math.abs(p.x() - place.x()) <= within)
        .filter(p -> Math.abs(p.y() - place.y()) <= within)
        .orElse(place);
  }
}
