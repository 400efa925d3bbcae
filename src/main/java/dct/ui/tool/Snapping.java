package dct.ui.tool;

import dct.core.Decimals;
import dct.core.geometry.Points;
import dct.core.geometry.SegmentPoints.Place;
import dct.render.Viewport;
import dct.ui.document.Analysis;
import java.math.BigDecimal;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import java.util.function.IntPredicate;

/**
 * Finds what a place snaps to. Directions come first, if Shift is down or angles are on: with Shift
 * they are multiples of 90°. Where one crosses an edge within reach, the place goes there if edges
 * are on; else level and upright ones go to coordinates of vertices, and all to lines of the grid.
 * Without a direction, a vertex within reach comes first, then two edges where they cross, an edge
 * within reach, and the grid.
 *
 * <p>What is snapped to is met exactly: a vertex has its own coordinates, the grid multiples of its
 * size as decimal numbers, an edge those of {@link EdgePoint}, and a level or upright direction one
 * coordinate of where it begins. Crossings are rounded as {@link NearCrossing} says.
 */
final class Snapping {
  private static final double RIGHT_ANGLE = 90;
  private static final double ALIGNED = 5; // how far from a vertex' coordinate, in pixels
  private static final int FINE = 3; // decimals of a slanting direction beyond those of pixels

  private final ToolContext context;
  private final Snap snap;
  private final Viewport view;
  private final Spot spot;
  private final IntPredicate moving;

  private Snapping(ToolContext context, Spot spot, IntPredicate moving) {
    this.context = context;
    this.snap = context.snap();
    this.view = context.viewport();
    this.spot = spot;
    this.moving = moving;
  }

  /**
   * Where a vertex goes.
   *
   * @param origin where directions begin, if anywhere
   * @param moving the vertices that are on their way themselves
   */
  static Target of(ToolContext context, Spot spot, Optional<Place> origin, IntPredicate moving) {
    Snapping snapping = new Snapping(context, spot, moving);
    boolean directed = spot.shift() || context.snap().isOn(Snap.To.ANGLES);
    return directed && origin.isPresent()
        ? snapping.inDirectionFrom(origin.get())
        : snapping.vertex().or(snapping::edge).or(snapping::gridPoint).orElse(snapping.free());
  }

  private Target free() {
    return new Target(spot.x(), spot.y(), "");
  }

  private Optional<Target> vertex() {
    if (!snap.isOn(Snap.To.VERTICES)) {
      return Optional.empty();
    }
    Points points = context.document().points();
    int v = Pick.vertex(points, view, spot, moving.negate());
    return v < 0 ? Optional.empty() : Optional.of(new Target(points.x(v), points.y(v), "on v" + v));
  }

  /** Whether edges are snapped to and those shown are not of an older document. */
  private boolean hasEdges() {
    return snap.isOn(Snap.To.EDGES)
        && context.shown().document().size() == context.document().size();
  }

  private Optional<Target> edge() {
    if (!hasEdges()) {
      return Optional.empty();
    }
    Analysis shown = context.shown();
    Optional<Target> crossing = new NearCrossing(shown, view, spot, moving.negate()).ofEdges();
    return crossing.or(
        () ->
            Pick.edge(shown, view, spot, (a, b) -> !moving.test(a) && !moving.test(b))
                .filter(edge -> edge.distance(view, spot) <= Pick.REACH)
                .map(edge -> new Target(edge.x(), edge.y(), "on " + edge.name())));
  }

  private Optional<Target> gridPoint() {
    return snap.isOn(Snap.To.GRID)
        ? Optional.of(new Target(onGrid(spot.x()), onGrid(spot.y()), "on the grid"))
        : Optional.empty();
  }

  /** The nearest multiple of the grid's size, as a decimal number; the value if it has none. */
  private double onGrid(double value) {
    double multiple = Math.rint(value / snap.grid());
    if (!Double.isFinite(multiple)) {
      return value;
    }
    return new BigDecimal(multiple).multiply(BigDecimal.valueOf(snap.grid())).doubleValue();
  }

  private Target inDirectionFrom(Place origin) {
    double step = spot.shift() ? RIGHT_ANGLE : snap.angle();
    double dx = spot.x() - origin.x();
    double dy = spot.y() - origin.y();
    double degrees = Math.rint(Math.toDegrees(Math.atan2(dy, dx)) / step) * step;
    String words = "in a direction of " + Decimals.format(Math.abs(degrees)) + "°";
    double cos = Math.abs(degrees) == RIGHT_ANGLE ? 0 : Math.cos(Math.toRadians(degrees));
    double sin = Math.abs(degrees) % 180 == 0 ? 0 : Math.sin(Math.toRadians(degrees));
    double length = dx * cos + dy * sin;
    Target place = new Target(origin.x() + length * cos, origin.y() + length * sin, words);
    return crossing(origin, cos, sin, place)
        .orElseGet(() -> alongDirection(origin, cos, sin, place));
  }

  /** Where an edge crosses the direction within reach of a place in it. */
  private Optional<Target> crossing(Place origin, double cos, double sin, Target place) {
    if (!hasEdges()) {
      return Optional.empty();
    }
    Spot there = Spot.at(view, view.screenX(place.x()), view.screenY(place.y()));
    return new NearCrossing(context.shown(), view, there, moving.negate())
        .inDirection(origin, cos, sin, place.hit());
  }

  private Target alongDirection(Place origin, double cos, double sin, Target place) {
    if (sin == 0) {
      return new Target(along(spot.x(), Points::x, view::screenX), origin.y(), place.hit());
    }
    if (cos == 0) {
      return new Target(origin.x(), along(spot.y(), Points::y, view::screenY), place.hit());
    }
    double length = Math.hypot(place.x() - origin.x(), place.y() - origin.y());
    String hit = place.hit();
    if (snap.isOn(Snap.To.GRID)) {
      hit = "on the grid " + hit;
      length =
          Math.abs(cos) >= Math.abs(sin)
              ? (onGrid(place.x()) - origin.x()) / cos
              : (onGrid(place.y()) - origin.y()) / sin;
    }
    int decimals = Spot.decimals(view) + FINE;
    return new Target(
        Spot.rounded(origin.x() + length * cos, decimals),
        Spot.rounded(origin.y() + length * sin, decimals),
        hit);
  }

  /** A coordinate of points. */
  @FunctionalInterface
  private interface Coordinate {
    double of(Points points, int v);
  }

  /** A coordinate along a level or upright direction: that of a vertex, of the grid, or its own. */
  private double along(double value, Coordinate coordinate, DoubleUnaryOperator screen) {
    double best = snap.isOn(Snap.To.GRID) ? onGrid(value) : value;
    double least = ALIGNED;
    Points points = context.document().points();
    for (int v = 0; snap.isOn(Snap.To.VERTICES) && v < points.size(); v++) {
      double own = coordinate.of(points, v);
      double distance = Math.abs(screen.applyAsDouble(own) - screen.applyAsDouble(value));
      if (distance < least && !moving.test(v)) {
        least = distance;
        best = own;
      }
    }
    return best;
  }
}
