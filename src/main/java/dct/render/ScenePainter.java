package dct.render;

import dct.core.geometry.Defect;
import dct.core.geometry.Points;
import dct.render.Pen.Anchor;

/**
 * Draws a scene with a pen: the one painter for screen, PNG and SVG.
 *
 * <p>Linear in the size of the scene; what lies outside the screen is left out, and so is an edge
 * that begins and ends in one pixel. Dots and lines get smaller where the vertices crowd.
 */
public final class ScenePainter {
  private static final double LARGEST_DOT = 4.5;
  private static final double SMALLEST_DOT = 0.6;
  private static final double MARGIN = 12;
  private static final double FIT_MARGIN = 40;
  private static final double FIT_GAP = 16; // room for rings and labels below the counts
  private static final double DEFECT_RING = 10;
  private static final double UNMET_GAP = 4;
  private static final double UNMET_WIDTH = 2;

  private final Scene scene;
  private final Box clip;
  private final Pen pen;
  private final double[] x; // on the screen, by vertex
  private final double[] y;
  private final double dot;

  private ScenePainter(Scene scene, Viewport view, Box screen, Pen pen) {
    this.scene = scene;
    this.clip = screen;
    this.pen = pen;
    Points points = scene.points();
    x = new double[points.size()];
    y = new double[points.size()];
    for (int v = 0; v < x.length; v++) {
      x[v] = view.screenX(points.x(v));
      y[v] = view.screenY(points.y(v));
    }
    dot = dotRadius(scene, view);
  }

  /**
   * Draws everything but the ground.
   *
   * @param screen the part of the screen to draw on, in pixels
   */
  public static void paint(Scene scene, Viewport view, Box screen, Pen pen) {
    ScenePainter painter = new ScenePainter(scene, view, screen, pen);
    painter.edges();
    painter.vertices();
    painter.unmet();
    painter.defects(view);
    if (scene.hasLabels()) {
      new LabelPainter(scene, painter.x, painter.y, screen, painter.dot).paint(pen);
    }
    painter.counts();
  }

  /**
   * The viewport that shows the whole scene as large as it fits on a screen of this size, below its
   * counts and with a margin on each side; actual size if there are no vertices.
   */
  public static Viewport fitted(Scene scene, double width, double height, boolean yUp) {
    double top = Math.max(FIT_MARGIN, Caption.bottom(MARGIN, scene.counts().size()) + FIT_GAP);
    double lower = top - FIT_MARGIN;
    return scene
        .bounds()
        .map(box -> Viewport.fit(box, width, height - lower, FIT_MARGIN, yUp).panned(0, lower))
        .orElse(Viewport.IDENTITY);
  }

  /** The radius of the dots at the vertices, in pixels: smaller where they crowd. */
  public static double dotRadius(Scene scene, Viewport view) {
    return scene
        .bounds()
        .map(
            box -> {
              double area = 4 * box.halfWidth() * view.scale() * box.halfHeight() * view.scale();
              double spacing = Math.sqrt(area / scene.points().size());
              // Outlines and vertices on a line fill no area; their length counts as well.
              double length = 2 * Math.max(box.halfWidth(), box.halfHeight()) * view.scale();
              double room = Math.max(spacing, length / scene.points().size());
              return Math.max(SMALLEST_DOT, Math.min(LARGEST_DOT, room / 5));
            })
        .orElse(LARGEST_DOT);
  }

  private void edges() {
    double thinner = Math.min(1, Math.max(0.4, dot / 2));
    for (EdgeLayer layer : scene.layers()) {
      if (layer.size() > 0) {
        Stroke stroke = layer.stroke();
        pen.style(new Stroke(stroke.ink(), stroke.width() * thinner, stroke.dashed()));
      }
      for (int k = 0; k < layer.size(); k++) {
        edge(layer.from(k), layer.to(k));
      }
    }
  }

  private void edge(int a, int b) {
    boolean dotOnly = Math.abs(x[a] - x[b]) < 0.5 && Math.abs(y[a] - y[b]) < 0.5;
    if (!dotOnly && clip.mayMeet(x[a], y[a], x[b], y[b])) {
      pen.line(x[a], y[a], x[b], y[b]);
    }
  }

  private void vertices() {
    for (Ink ink : new Ink[] {Ink.VERTEX, Ink.EVEN, Ink.ODD}) {
      if (scene.hasDegrees() == (ink != Ink.VERTEX)) {
        pen.style(Stroke.fill(ink));
        vertices(ink);
      }
    }
  }

  /** Even vertices are discs and odd ones squares, so that they differ without colour too. */
  private void vertices(Ink ink) {
    Box near = clip.grown(dot);
    for (int v = 0; v < x.length; v++) {
      if (scene.ink(v) == ink && near.holds(x[v], y[v])) {
        if (ink == Ink.ODD) {
          pen.square(x[v], y[v], dot * 0.9);
        } else {
          pen.disc(x[v], y[v], dot);
        }
      }
    }
  }

  private void unmet() {
    if (scene.unmet().length > 0) {
      pen.style(Stroke.solid(Ink.UNMET, UNMET_WIDTH));
    }
    double radius = dot + UNMET_GAP;
    Box near = clip.grown(radius + UNMET_WIDTH);
    for (int v : scene.unmet()) {
      if (near.holds(x[v], y[v])) {
        pen.ring(x[v], y[v], radius);
      }
    }
  }

  private void defects(Viewport view) {
    for (Defect defect : scene.defects()) {
      if (defect.kind() != Defect.Kind.TOO_FEW && defect.kind() != Defect.Kind.COLLINEAR) {
        pen.style(Stroke.solid(Ink.DEFECT, 2));
        pen.ring(view.screenX(defect.x()), view.screenY(defect.y()), DEFECT_RING);
      }
    }
  }

  private void counts() {
    Caption.paint(pen, clip.maxX() - MARGIN, clip.minY() + MARGIN, Anchor.END, scene.counts());
  }
}
