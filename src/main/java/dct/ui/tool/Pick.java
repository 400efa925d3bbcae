package dct.ui.tool;

import dct.core.geometry.Points;
import dct.render.Ink;
import dct.render.Pen;
import dct.render.Scene;
import dct.render.Stroke;
import dct.render.Viewport;
import dct.ui.document.Analysis;
import java.util.Optional;
import java.util.function.IntPredicate;

/** Finds what lies under the mouse, in linear time. */
final class Pick {
  /** How far from the mouse a vertex may be, in pixels. */
  static final double REACH = 9;

  /** Distances that differ by less are the same, in pixels. */
  private static final double TIE = 1e-6;

  private Pick() {}

  /** Which edges may be taken. */
  @FunctionalInterface
  interface EdgeTest {
    /** Whether the edge with these ends may be. */
    boolean test(int from, int to);
  }

  /** The vertex nearest to the spot, if it is within reach; −1 if none is. */
  static int vertex(Points points, Viewport view, Spot spot) {
    return vertex(points, view, spot, v -> true);
  }

  /** The same among the vertices that may be taken. */
  static int vertex(Points points, Viewport view, Spot spot, IntPredicate allowed) {
    int nearest = -1;
    double least = REACH * REACH;
    for (int v = 0; v < points.size(); v++) {
      double dx = view.screenX(points.x(v)) - spot.screenX();
      double dy = view.screenY(points.y(v)) - spot.screenY();
      double square = dx * dx + dy * dy;
      // Of several at one distance the last wins: it is drawn on top.
      if (square <= least && allowed.test(v)) {
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

  /** The point nearest to the spot on an edge shown that may be taken; nothing without any. */
  static Optional<EdgePoint> edge(Analysis shown, Viewport view, Spot spot, EdgeTest allowed) {
    Search search = new Search(shown.document().points(), view, spot, allowed);
    shown.scene().visitNear(view, spot.screenX(), spot.screenY(), search);
    return search.found();
  }

  /** Draws a ring round a vertex. */
  static void mark(Pen pen, Viewport view, double x, double y) {
    pen.style(Stroke.solid(Ink.HIGHLIGHT, 2));
    pen.ring(view.screenX(x), view.screenY(y), REACH - 1);
  }

  /** Draws the line between two vertices. */
  static void line(Pen pen, Viewport view, Points points, int from, int to) {
    pen.line(
        view.screenX(points.x(from)),
        view.screenY(points.y(from)),
        view.screenX(points.x(to)),
        view.screenY(points.y(to)));
  }

  /** Measures on the screen, where tiny and huge coordinates are no trouble. */
  private static final class Search implements Scene.EdgeVisitor {
    private final Points points;
    private final Viewport view;
    private final Spot spot;
    private final EdgeTest allowed;
    private double least = Double.POSITIVE_INFINITY;
    private int from = -1;
    private int to;
    private double t; // where on the edge

    Search(Points points, Viewport view, Spot spot, EdgeTest allowed) {
      this.points = points;
      this.view = view;
      this.spot = spot;
      this.allowed = allowed;
    }

    @Override
    public double visit(int a, int b) {
      return allowed.test(a, b) ? measure(a, b) : least + TIE;
    }

    private double measure(int a, int b) {
      double ax = view.screenX(points.x(a));
      double ay = view.screenY(points.y(a));
      double dx = view.screenX(points.x(b)) - ax;
      double dy = view.screenY(points.y(b)) - ay;
      double px = spot.screenX() - ax;
      double py = spot.screenY() - ay;
      double square = dx * dx + dy * dy;
      double part = square == 0 ? 0 : Math.max(0, Math.min(1, (px * dx + py * dy) / square));
      double distance = Math.hypot(px - part * dx, py - part * dy);
      // Of several at one distance the last wins: the boundary is drawn on top.
      if (distance <= least + TIE) {
        least = Math.min(least, distance);
        from = a;
        to = b;
        t = part;
      }
      return least + TIE;
    }

    Optional<EdgePoint> found() {
      return from < 0 ? Optional.empty() : Optional.of(EdgePoint.of(points, view, from, to, t));
    }
  }
}
