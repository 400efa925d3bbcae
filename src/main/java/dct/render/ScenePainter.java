package dct.render;

import dct.core.geometry.Box;
import dct.core.geometry.Defect;
import dct.render.Pen.Anchor;
import java.util.EnumSet;
import java.util.Set;

/**
 * Draws a scene with a pen: the one painter for screen and files.
 *
 * <p>Linear in what is to be seen of the scene: what lies outside the screen is left out by the
 * block, and so are edges that the dots at their ends cover. Dots and lines get smaller where the
 * vertices crowd.
 */
public final class ScenePainter {
  private static final double LARGEST_DOT = 4.5;
  private static final double SMALLEST_DOT = 0.6;
  private static final double MARGIN = 12;
  private static final double FIT_MARGIN = 40;
  private static final double FIT_GAP = 16; // room for rings and labels below the counts
  private static final double DEFECT_RING = 10;
  private static final double UNMET_GAP = 4;
  private static final double REACH = 14; // how far a line, dot or ring reaches from its place
  private static final double HIDDEN = 2; // dots at both ends cover edges of so many radii
  private static final double UNMET_WIDTH = 2;

  private final Scene scene;
  private final SceneIndex index;
  private final Viewport view;
  private final Box clip;
  private final Pen pen;
  private final double dot;

  private ScenePainter(Scene scene, Viewport view, Box screen, Pen pen) {
    this.scene = scene;
    this.index = scene.index();
    this.view = view;
    this.clip = screen.grown(REACH);
    this.pen = pen;
    this.dot = dotRadius(scene, view);
  }

  /**
   * Draws everything but the ground.
   *
   * @param screen the part of the screen to draw on, in pixels
   */
  public static void paint(Scene scene, Viewport view, Box screen, Pen pen) {
    paintShapes(scene, view, screen, pen);
    paintLabels(scene, view, screen, pen);
    paintCounts(scene, screen, pen);
  }

  /**
   * Draws the inside of a polygon, the edges, the vertices and their rings. Parts of a screen that
   * are drawn one by one make the same picture as the whole.
   */
  static void paintShapes(Scene scene, Viewport view, Box part, Pen pen) {
    ScenePainter painter = new ScenePainter(scene, view, part, pen);
    painter.inside();
    painter.edges();
    painter.vertices();
    painter.unmet();
    painter.defects();
  }

  /** Writes what there is to write beside the vertices. */
  static void paintLabels(Scene scene, Viewport view, Box screen, Pen pen) {
    if (scene.hasLabels()) {
      new LabelPainter(scene, view, screen, dotRadius(scene, view)).paint(pen);
    }
  }

  /** Writes the counts into the upper right corner of the screen. */
  public static void paintCounts(Scene scene, Box screen, Pen pen) {
    Caption.paint(pen, screen.maxX() - MARGIN, screen.minY() + MARGIN, Anchor.END, scene.counts());
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

  private void inside() {
    if (scene.isPolygon()) {
      Corners corners = Corners.of(scene.points(), view, clip);
      if (!corners.isEmpty()) {
        pen.style(Stroke.fill(Ink.INSIDE));
        pen.polygon(corners.xs(), corners.ys());
      }
    }
  }

  private void edges() {
    double thinner = Math.min(1, Math.max(0.4, dot / 2));
    for (IndexedEdges edges : index.layers()) {
      if (edges.blocks().count() > 0) {
        Stroke stroke = edges.stroke();
        pen.style(new Stroke(stroke.ink(), stroke.width() * thinner, stroke.dashed()));
        edges(edges);
      }
    }
  }

  private void edges(IndexedEdges edges) {
    Blocks blocks = edges.blocks();
    for (int block = 0; block < blocks.count(); block++) {
      boolean seen = edges.longest(block) * view.scale() > HIDDEN * dot;
      if (seen && blocks.mayMeet(block, view, clip)) {
        for (int k = blocks.first(block); k < blocks.end(block); k++) {
          edge(edges.from(k), edges.to(k));
        }
      }
    }
  }

  private void edge(int a, int b) {
    double ax = view.screenX(index.x(a));
    double ay = view.screenY(index.y(a));
    double bx = view.screenX(index.x(b));
    double by = view.screenY(index.y(b));
    double square = (bx - ax) * (bx - ax) + (by - ay) * (by - ay);
    if (square > HIDDEN * dot * HIDDEN * dot && clip.mayMeet(ax, ay, bx, by)) {
      pen.line(ax, ay, bx, by);
    }
  }

  /**
   * Odd vertices come last: the fewer they get, the more they are what is looked for. Where dots
   * cover each other that would hide most even ones, so there they come as they lie.
   */
  private void vertices() {
    if (!scene.hasDegrees()) {
      vertices(EnumSet.of(Ink.VERTEX));
    } else if (dot == SMALLEST_DOT) {
      vertices(EnumSet.of(Ink.EVEN, Ink.ODD));
    } else {
      vertices(EnumSet.of(Ink.EVEN));
      vertices(EnumSet.of(Ink.ODD));
    }
  }

  private void vertices(Set<Ink> inks) {
    Blocks blocks = index.blocks();
    Ink last = null;
    for (int block = 0; block < blocks.count(); block++) {
      if (blocks.mayMeet(block, view, clip)) {
        for (int place = blocks.first(block); place < blocks.end(block); place++) {
          Ink ink = index.ink(place);
          if (inks.contains(ink)) {
            if (ink != last) {
              pen.style(Stroke.fill(ink));
              last = ink;
            }
            vertex(ink, view.screenX(index.x(place)), view.screenY(index.y(place)));
          }
        }
      }
    }
  }

  /** Even vertices are discs and odd ones squares, so that they differ without colour too. */
  private void vertex(Ink ink, double x, double y) {
    if (clip.holds(x, y)) {
      if (ink == Ink.ODD) {
        pen.square(x, y, dot * 0.9);
      } else {
        pen.disc(x, y, dot);
      }
    }
  }

  private void unmet() {
    if (scene.unmet().length > 0) {
      pen.style(Stroke.solid(Ink.UNMET, UNMET_WIDTH));
    }
    for (int v : scene.unmet()) {
      ring(view.screenX(scene.points().x(v)), view.screenY(scene.points().y(v)), dot + UNMET_GAP);
    }
  }

  private void defects() {
    for (Defect defect : scene.defects()) {
      if (defect.kind() != Defect.Kind.TOO_FEW && defect.kind() != Defect.Kind.COLLINEAR) {
        pen.style(Stroke.solid(Ink.DEFECT, 2));
        ring(view.screenX(defect.x()), view.screenY(defect.y()), DEFECT_RING);
      }
    }
  }

  private void ring(double x, double y, double radius) {
    if (clip.holds(x, y)) {
      pen.ring(x, y, radius);
    }
  }
}
