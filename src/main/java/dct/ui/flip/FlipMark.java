package dct.ui.flip;

import dct.core.degree.Flip;
import dct.core.geometry.Points;
import dct.render.Ink;
import dct.render.Pen;
import dct.render.Stroke;
import dct.render.Viewport;

/** Shows a flip on the canvas: the edge removed dashed, the edge made in full. */
final class FlipMark {
  private static final double WIDTH = 3.5;

  private FlipMark() {}

  /** Draws the flip that led to the state that is shown, if flips are played. */
  static void paint(Replay replay, Viewport view, Pen pen) {
    replay
        .last()
        .ifPresent(
            flip -> {
              Points points = replay.shown().orElseThrow().solution().triangulation().points();
              paint(flip, points, view, pen);
            });
  }

  private static void paint(Flip flip, Points points, Viewport view, Pen pen) {
    pen.style(Stroke.dashed(Ink.HIGHLIGHT, 1.6));
    line(points, flip.u(), flip.v(), view, pen);
    pen.style(Stroke.solid(Ink.HIGHLIGHT, WIDTH));
    line(points, flip.x(), flip.y(), view, pen);
  }

  private static void line(Points points, int from, int to, Viewport view, Pen pen) {
    pen.line(
        view.screenX(points.x(from)),
        view.screenY(points.y(from)),
        view.screenX(points.x(to)),
        view.screenY(points.y(to)));
  }
}
