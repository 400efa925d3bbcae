package dct.ui.tool;

import dct.core.geometry.Points;
import dct.core.triangulate.Triangulation;
import dct.render.Scene;
import dct.render.Viewport;
import java.awt.geom.Line2D;
import java.util.OptionalInt;

/** Finds the edge of a triangulation that is nearest to the mouse, as measured on the screen. */
final class NearestEdge implements Scene.EdgeVisitor {
  private final Points points;
  private final Viewport view;
  private final Spot spot;
  private double least;
  private int from = -1;
  private int to = -1;

  private NearestEdge(Points points, Viewport view, Spot spot, double reach) {
    this.points = points;
    this.view = view;
    this.spot = spot;
    least = reach;
  }

  /**
   * The number of the nearest edge.
   *
   * @param scene a picture of the triangulation
   * @param reach how far it may be, in pixels
   */
  static OptionalInt of(
      Triangulation triangulation, Scene scene, Viewport view, Spot spot, double reach) {
    NearestEdge search = new NearestEdge(scene.points(), view, spot, reach);
    scene.visitNear(view, spot.screenX(), spot.screenY(), search);
    return search.from < 0
        ? OptionalInt.empty()
        : triangulation.edgeBetween(search.from, search.to);
  }

  @Override
  public double visit(int a, int b) {
    double distance =
        Line2D.ptSegDist(
            view.screenX(points.x(a)),
            view.screenY(points.y(a)),
            view.screenX(points.x(b)),
            view.screenY(points.y(b)),
            spot.screenX(),
            spot.screenY());
    if (distance < least) {
      least = distance;
      from = a;
      to = b;
    }
    return least;
  }
}
