package dct.ui.tool;

import dct.core.geometry.Points;
import dct.core.geometry.Predicates;
import dct.core.triangulate.Domain;
import dct.ui.document.Document;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/**
 * Where an edge is split on which no other coordinates lie exactly: at a place a few last digits
 * beside it, at which nothing else changes. A polygon stays as simple as it was: no vertex lies in
 * the triangle between the edge and the place. Every site on the hull stays on it, however often
 * its edges are split:
 *
 * <ul>
 *   <li>an edge of the hull is split just outside of it, with all sites on the inner side of both
 *       new edges or on them, so that the new site is on the hull too;
 *   <li>where edges are so nearly straight that no such place is left, just inside: in a triangle
 *       of the edge and another site, so that the hull stays as it is;
 *   <li>so is any other edge, to either side.
 * </ul>
 *
 * <p>Where all sites are in one line, any place does. If no place suits, the edge is not split.
 *
 * <p>Of some thousand places within two pixels of the mouse the first that suits is taken. The
 * vertex that spoiled one, or covered it, is looked at first for the next, so that this is linear
 * in practice.
 */
final class NearEdge {
  private static final int STEPS = 50; // to each side of the mouse along the edge
  private static final double PIXELS = 2;

  /** How many last digits beside the edge: some, so that the new edges can be split in turn. */
  private static final int[] DIGITS = {16, -16, 1, -1, 0};

  private final Points points;
  private final int from;
  private final int to;
  private final boolean polygon;
  private final int inner; // the side of the edge on which all sites lie, if it is one; else 0
  private final boolean flat; // all sites are in one line
  private int last; // the vertex that decided about the last place

  private NearEdge(Document document, EdgePoint edge) {
    points = document.points();
    from = edge.from();
    to = edge.to();
    polygon = document.domain() == Domain.POLYGON;
    boolean left = isAnyOn(1);
    boolean right = isAnyOn(-1);
    inner = left == right ? 0 : left ? 1 : -1;
    flat = !left && !right;
  }

  private boolean isAnyOn(int side) {
    return IntStream.range(0, points.size()).anyMatch(v -> points.orient(from, to, v) == side);
  }

  /**
   * The best place near this one, if any suits.
   *
   * @param scale pixels per unit of the model
   */
  static Optional<EdgePoint> settle(Document document, EdgePoint edge, double scale) {
    NearEdge near = new NearEdge(document, edge);
    List<EdgePoint> places = near.places(edge, scale);
    Optional<EdgePoint> best = places.stream().filter(near::isBest).findFirst();
    return best.or(() -> places.stream().filter(near::isInside).findFirst());
  }

  /** Places along the edge, those near the mouse first, each with its neighbours. */
  private List<EdgePoint> places(EdgePoint edge, double scale) {
    List<EdgePoint> places = new ArrayList<>();
    double dx = points.x(to) - points.x(from);
    double dy = points.y(to) - points.y(from);
    double step = PIXELS / STEPS / scale / Math.max(Math.abs(dx), Math.abs(dy));
    for (int i = 0; i <= 2 * STEPS; i++) {
      double along = (i % 2 == 0 ? i / 2 : -(i + 1) / 2) * step;
      addNeighbours(edge.x() + along * dx, edge.y() + along * dy, places);
    }
    return places;
  }

  private void addNeighbours(double x, double y, List<EdgePoint> places) {
    for (int i : DIGITS) {
      for (int j : DIGITS) {
        double px = x + i * Math.ulp(x);
        double py = y + j * Math.ulp(y);
        if (isBeside(px, py)) {
          places.add(new EdgePoint(from, to, px, py, false));
        }
      }
    }
  }

  /** Whether the place is in the box of the edge, and not at its ends. */
  private boolean isBeside(double x, double y) {
    return (x - points.x(from)) * Math.signum(points.x(to) - x) >= 0
        && (y - points.y(from)) * Math.signum(points.y(to) - y) >= 0
        && !(x == points.x(from) && y == points.y(from))
        && !(x == points.x(to) && y == points.y(to));
  }

  private boolean isBest(EdgePoint place) {
    int turn = turn(from, to, place);
    if (turn == 0) {
      return true;
    }
    if (polygon) {
      return !isAny(v -> isInTriangle(v, place, turn));
    }
    return flat || (turn == -inner && !isAny(v -> leavesTheHull(v, place)));
  }

  /** Whether a site may go there without any effect on the hull. */
  private boolean isInside(EdgePoint place) {
    int turn = turn(from, to, place);
    return !polygon && turn != -inner && isAny(v -> covers(v, place, turn));
  }

  private boolean isAny(IntPredicate condition) {
    if (condition.test(last)) {
      return true;
    }
    OptionalInt found = IntStream.range(0, points.size()).filter(condition).findFirst();
    found.ifPresent(v -> last = v);
    return found.isPresent();
  }

  private boolean isInTriangle(int v, EdgePoint place, int turn) {
    return v != from
        && v != to
        && turn * points.orient(from, to, v) >= 0
        && turn * turn(v, to, place) >= 0
        && turn * turn(from, v, place) >= 0;
  }

  private boolean leavesTheHull(int v, EdgePoint place) {
    return v != from
        && v != to
        && (inner * turn(v, from, place) < 0 || inner * turn(to, v, place) < 0);
  }

  /** Whether the triangle of the edge and this vertex holds a place beside the edge. */
  private boolean covers(int v, EdgePoint place, int turn) {
    return points.orient(from, to, v) == turn
        && turn * turn(to, v, place) >= 0
        && turn * turn(v, from, place) >= 0;
  }

  private int turn(int a, int b, EdgePoint c) {
    return Predicates.orient(points.x(a), points.y(a), points.x(b), points.y(b), c.x(), c.y());
  }
}
