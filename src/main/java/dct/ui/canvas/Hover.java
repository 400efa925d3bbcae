package dct.ui.canvas;

import dct.core.geometry.Points;
import dct.render.Ink;
import dct.render.Pen;
import dct.render.Scene;
import dct.render.Stroke;
import dct.render.Viewport;
import java.util.Optional;

/**
 * The vertex or the edge of a scene under the mouse.
 *
 * @param from the vertex, or one end of the edge
 * @param to the other end of the edge; the vertex itself if it is one
 */
record Hover(int from, int to) {
  private static final double REACH = 9; // how far from the mouse, in pixels
  private static final double RING = 8;
  private static final double WIDTH = 3;

  /** What lies under a place of the screen; a vertex comes before the edges that end there. */
  static Optional<Hover> at(Scene scene, Viewport view, double x, double y) {
    Search search = new Search(scene.points(), view, x, y);
    scene.visitNear(view, x, y, search);
    return Optional.ofNullable(search.vertex).or(() -> Optional.ofNullable(search.edge));
  }

  /** Rings it in a scene of the same points; an edge that the scene lacks is dashed. */
  void paint(Scene scene, Viewport view, Pen pen) {
    Points points = scene.points();
    double x = view.screenX(points.x(from));
    double y = view.screenY(points.y(from));
    if (from == to) {
      pen.style(Stroke.solid(Ink.HIGHLIGHT, WIDTH));
      pen.ring(x, y, RING);
    } else {
      pen.style(new Stroke(Ink.HIGHLIGHT, WIDTH, !isEdgeOf(scene, view)));
      pen.line(x, y, view.screenX(points.x(to)), view.screenY(points.y(to)));
    }
  }

  private boolean isEdgeOf(Scene scene, Viewport view) {
    boolean[] found = {false};
    scene.visitNear(
        view,
        view.screenX(scene.points().x(from)),
        view.screenY(scene.points().y(from)),
        (a, b) -> {
          found[0] |= (a == from && b == to) || (a == to && b == from);
          return 1;
        });
    return found[0];
  }

  /** Measures on the screen. */
  private static final class Search implements Scene.EdgeVisitor {
    private final Points points;
    private final Viewport view;
    private final double x;
    private final double y;
    private double toVertex = REACH;
    private double toEdge = REACH;
    private Hover vertex;
    private Hover edge;

    Search(Points points, Viewport view, double x, double y) {
      this.points = points;
      this.view = view;
      this.x = x;
      this.y = y;
    }

    @Override
    public double visit(int from, int to) {
      double ax = view.screenX(points.x(from)) - x;
      double ay = view.screenY(points.y(from)) - y;
      double bx = view.screenX(points.x(to)) - x;
      double by = view.screenY(points.y(to)) - y;
      end(from, Math.hypot(ax, ay));
      end(to, Math.hypot(bx, by));
      double dx = bx - ax;
      double dy = by - ay;
      double square = dx * dx + dy * dy;
      double t = square == 0 ? 0 : Math.max(0, Math.min(1, -(ax * dx + ay * dy) / square));
      double distance = Math.hypot(ax + t * dx, ay + t * dy);
      if (distance < toEdge) {
        toEdge = distance;
        edge = new Hover(from, to);
      }
      return REACH;
    }

    private void end(int v, double distance) {
      if (distance < toVertex) {
        toVertex = distance;
        vertex = new Hover(v, v);
      }
    }
  }
}
