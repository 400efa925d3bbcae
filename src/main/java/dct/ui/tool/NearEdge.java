package dct.ui.tool;

import dct.core.geometry.Points;
import dct.core.geometry.Predicates;
import dct.core.triangulate.Domain;
import dct.ui.document.Document;
import java.util.ArrayList;
import java.util.List;

/**
 * Where an edge is split on which no other coordinates lie exactly: at a place a few last digits
 * beside it, at which nothing else changes. A polygon stays as simple as it was: no vertex lies in
 * the triangle between the edge and the place. A site on the hull stays on the hull, and so do all
 * others: the place lies just outside, and every site on the inner side of its new edges.
 *
 * <p>Of some hundred places within two pixels of the mouse the first that suits is taken. The
 * vertex that spoiled one is looked at first for the next, so that this is linear in practice.
 */
final class NearEdge {
  private static final int STEPS = 50; // to each side of the mouse along the edge
  private static final double PIXELS = 2;

  /** How many last digits beside the edge: some, so that the new edges can be split in turn. */
  private static final int[] DIGITS = {16, -16, 1, -1, 0};

  private final Points points;
  private final int from;
  private final int to;
  private final int inner; // the side of the edge on which all sites lie; 0 in a polygon, or inside
  private final boolean polygon;
  private int spoiler; // the vertex that spoiled the last place

  private NearEdge(Document document, EdgePoint edge) {
    points = document.points();
    from = edge.from();
    to = edge.to();
    polygon = document.domain() == Domain.POLYGON;
    inner = polygon ? 0 : innerSide();
  }

  /**
   * The best place near this one.
   *
   * @param scale pixels per unit of the model
   */
  static EdgePoint settle(Document document, EdgePoint edge, double scale) {
    NearEdge near = new NearEdge(document, edge);
    return near.places(edge, scale).stream().filter(near::suits).findFirst().orElse(edge);
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

  private boolean suits(EdgePoint place) {
    int turn = turn(from, to, place);
    if (polygon ? turn == 0 : turn != -inner && inner != 0) {
      return false;
    }
    if (spoils(spoiler, place, turn)) {
      return false;
    }
    for (int v = 0; v < points.size(); v++) {
      if (spoils(v, place, turn)) {
        spoiler = v;
        return false;
      }
    }
    return true;
  }

  private boolean spoils(int v, EdgePoint place, int turn) {
    if (v == from || v == to) {
      return false;
    }
    if (polygon) { // lies in the triangle
      return turn * points.orient(from, to, v) >= 0
          && turn * turn(v, to, place) >= 0
          && turn * turn(from, v, place) >= 0;
    }
    return inner != 0 && (inner * turn(v, from, place) < 0 || inner * turn(to, v, place) < 0);
  }

  private int innerSide() {
    int side = 0;
    for (int v = 0; v < points.size(); v++) {
      int turn = points.orient(from, to, v);
      if (turn * side < 0) {
        return 0;
      }
      side = side == 0 ? turn : side;
    }
    return side;
  }

  private int turn(int a, int b, EdgePoint c) {
    return Predicates.orient(points.x(a), points.y(a), points.x(b), points.y(b), c.x(), c.y());
  }
}
