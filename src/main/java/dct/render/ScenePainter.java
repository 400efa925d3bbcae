package dct.render;

import dct.core.geometry.Box;
import dct.core.geometry.Defect;
import dct.core.triangulate.MovedSite;
import java.util.EnumSet;
import java.util.List;
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
  private static final double FIT_MARGIN = 40;
  static final double FIT_GAP = 16; // room for rings and labels below the counts
  private static final double DEFECT_RING = 10;
  private static final double REACH = 14; // how far a line, dot or ring reaches from its place
  private static final double HIDDEN = 2; // dots at both ends cover edges of so many radii
  private static final double UNMET_WIDTH = 2;

  private final Scene scene;
  private final SceneIndex index;
  private final Viewport view;
  private final Box clip;
  private final Pen pen;
  private final double dot;
  private final ScenePatch patch;
  private final Gauge gauge;
  private Ink style; // that the pen has been given last, for vertices; null before the first

  private ScenePainter(Scene scene, Viewport view, Box screen, Gauge gauge, Pen pen) {
    this.scene = scene;
    this.index = scene.index();
    this.view = view;
    this.clip = screen.grown(REACH);
    this.pen = pen;
    this.gauge = gauge;
    this.dot = dotRadius(scene, view, gauge);
    this.patch = scene.patch();
  }

  /**
   * Draws everything but the ground and the {@link Notes}.
   *
   * @param screen the part of the screen to draw on, in pixels
   */
  public static void paint(Scene scene, Viewport view, Box screen, Pen pen) {
    paintShapes(scene, view, screen, pen);
    paintLabels(scene, view, screen, pen);
  }

  /**
   * Draws the inside of a polygon, the edges, the vertices and their rings. Parts of a screen that
   * are drawn one by one make the same picture as the whole.
   */
  static void paintShapes(Scene scene, Viewport view, Box part, Pen pen) {
    paintShapes(scene, view, part, Gauge.SCREEN, pen);
  }

  /** The same with lines and dots as this gauge has them. */
  static void paintShapes(Scene scene, Viewport view, Box part, Gauge gauge, Pen pen) {
    ScenePainter painter = new ScenePainter(scene, view, part, gauge, pen);
    painter.inside();
    painter.edges();
    painter.vertices();
    painter.unmet();
    painter.defects();
  }

  /** About how many vertices there are to draw in these parts of the screen, those twice in two. */
  static long vertices(Scene scene, Viewport view, List<Box> parts) {
    Blocks blocks = scene.index().blocks();
    long count = 0;
    for (Box part : parts) {
      Box clip = part.grown(REACH);
      int block = blocks.next(0, view, clip);
      for (; block < blocks.count(); block = blocks.next(block + 1, view, clip)) {
        count += blocks.end(block) - blocks.first(block);
      }
    }
    return count;
  }

  /**
   * Draws of a scene in which a site has moved this site and the edges that are new: what can be
   * seen of the move before the picture is drawn anew.
   */
  public static void paintMoved(Scene scene, Viewport view, Box screen, Pen pen) {
    ScenePainter painter = new ScenePainter(scene, view, screen, Gauge.SCREEN, pen);
    for (int layer = 0; layer < painter.index.layers().size(); layer++) {
      painter.added(layer);
    }
    painter.arrived(EnumSet.allOf(Ink.class));
  }

  /** Writes what there is to write beside the vertices. */
  static void paintLabels(Scene scene, Viewport view, Box screen, Pen pen) {
    if (scene.hasLabels()) {
      LabelPainter.paint(scene, view, screen, dotRadius(scene, view), pen);
    }
  }

  /**
   * The viewport that shows the whole scene as large as it fits on a screen of this size, below its
   * counts and with a margin on each side; actual size if there are no vertices.
   */
  public static Viewport fitted(Scene scene, double width, double height, boolean yUp) {
    return fitted(scene, 0, width, height, yUp);
  }

  /** The same, with room for so many lines of counts at least. */
  static Viewport fitted(Scene scene, int least, double width, double height, boolean yUp) {
    int lines = Caption.folded(scene.counts(), new Box(0, 0, width, height)).size();
    double top =
        Math.max(FIT_MARGIN, Caption.MARGIN + Caption.height(Math.max(least, lines)) + FIT_GAP);
    double lower = top - FIT_MARGIN;
    return scene
        .bounds()
        .map(box -> Viewport.fit(box, width, height - lower, FIT_MARGIN, yUp).panned(0, lower))
        .orElse(Viewport.IDENTITY);
  }

  /** The radius of the dots at the vertices, in pixels: smaller where they crowd. */
  public static double dotRadius(Scene scene, Viewport view) {
    return dotRadius(scene, view, Gauge.SCREEN);
  }

  /** The same in units of a drawing with this gauge. */
  static double dotRadius(Scene scene, Viewport view, Gauge gauge) {
    double largest = LARGEST_DOT * gauge.dots();
    return scene
        .bounds()
        .map(
            box -> {
              double area = 4 * box.halfWidth() * view.scale() * box.halfHeight() * view.scale();
              double spacing = Math.sqrt(area / scene.size());
              // Outlines and vertices on a line fill no area; their length counts as well.
              double length = 2 * Math.max(box.halfWidth(), box.halfHeight()) * view.scale();
              double room = Math.max(spacing, length / scene.size());
              return Math.max(SMALLEST_DOT * gauge.dots(), Math.min(largest, room / 5));
            })
        .orElse(largest);
  }

  private void inside() {
    if (scene.hasInside()) {
      Corners corners = Corners.of(scene.inside(), view, clip);
      if (!corners.isEmpty()) {
        pen.part(Part.POLYGON);
        pen.style(Stroke.fill(Ink.INSIDE));
        pen.polygon(corners.xs(), corners.ys());
      }
    }
  }

  private void edges() {
    for (int layer = 0; layer < index.layers().size(); layer++) {
      IndexedEdges edges = index.layers().get(layer);
      if (edges.blocks().count() > 0) {
        style(edges.stroke());
        edges(edges, patch.hidden(layer));
      }
      added(layer);
    }
  }

  private void style(Stroke stroke) {
    double thinner = Math.min(1, Math.max(0.4, dot / gauge.dots() / 2));
    pen.part(Part.ofEdges(stroke.ink()));
    pen.style(gauge.of(new Stroke(stroke.ink(), stroke.width() * thinner, stroke.dashed())));
  }

  /** Draws the edges of a layer that are not in the index. */
  private void added(int layer) {
    List<MovedSite.Edge> added = patch.added(layer);
    if (!added.isEmpty()) {
      style(index.layers().get(layer).stroke());
    }
    for (MovedSite.Edge edge : added) {
      int u = edge.from();
      int v = edge.to();
      edge(scene.x(u), scene.y(u), scene.x(v), scene.y(v));
    }
  }

  private void edges(IndexedEdges edges, Few hidden) {
    Blocks blocks = edges.blocks();
    int block = blocks.next(0, view, clip);
    for (; block < blocks.count(); block = blocks.next(block + 1, view, clip)) {
      if (edges.longest(block) * view.scale() > HIDDEN * dot) {
        int first = blocks.first(block);
        int end = blocks.end(block);
        boolean all = !hidden.meets(first, end);
        for (int k = first; k < end; k++) {
          if (all || !hidden.holds(k)) {
            int a = edges.from(k);
            int b = edges.to(k);
            edge(index.x(a), index.y(a), index.x(b), index.y(b));
          }
        }
      }
    }
  }

  private void edge(double fromX, double fromY, double toX, double toY) {
    double ax = view.screenX(fromX);
    double ay = view.screenY(fromY);
    double bx = view.screenX(toX);
    double by = view.screenY(toY);
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
    pen.part(Part.VERTICES);
    if (!scene.hasDegrees()) {
      vertices(EnumSet.of(Ink.VERTEX));
    } else if (dot == SMALLEST_DOT * gauge.dots()) {
      vertices(EnumSet.of(Ink.EVEN, Ink.ODD));
    } else {
      vertices(EnumSet.of(Ink.EVEN));
      vertices(EnumSet.of(Ink.ODD));
    }
  }

  private void vertices(Set<Ink> inks) {
    Blocks blocks = index.blocks();
    style = null;
    int block = blocks.next(0, view, clip);
    for (; block < blocks.count(); block = blocks.next(block + 1, view, clip)) {
      int first = blocks.first(block);
      int end = blocks.end(block);
      boolean asIndexed = !patch.meets(first, end);
      for (int place = first; place < end; place++) {
        if (asIndexed) {
          vertex(inks, index.vertex(place), index.ink(place), index.x(place), index.y(place));
        } else if (!patch.isLeft(place)) {
          int v = index.vertex(place);
          vertex(inks, v, scene.ink(v), index.x(place), index.y(place));
        }
      }
    }
    arrived(inks);
  }

  /** Draws the site that has moved. */
  private void arrived(Set<Ink> inks) {
    if (patch.isArrived()) {
      int v = patch.site();
      vertex(inks, v, scene.ink(v), scene.x(v), scene.y(v));
    }
  }

  private void vertex(Set<Ink> inks, int v, Ink ink, double x, double y) {
    if (inks.contains(ink)) {
      if (ink != style) {
        pen.style(Stroke.fill(ink));
        style = ink;
      }
      vertex(v, ink, view.screenX(x), view.screenY(y));
    }
  }

  /** Even vertices are discs and odd ones squares, so that they differ without colour too. */
  private void vertex(int v, Ink ink, double x, double y) {
    if (clip.holds(x, y)) {
      pen.vertex(v);
      if (ink == Ink.ODD) {
        pen.square(x, y, dot * Dots.SQUARE);
      } else {
        pen.disc(x, y, dot);
      }
    }
  }

  private void unmet() {
    if (scene.unmet().length > 0) {
      pen.style(gauge.of(Stroke.solid(Ink.UNMET, UNMET_WIDTH)));
    }
    for (int v : scene.unmet()) {
      ring(view.screenX(scene.x(v)), view.screenY(scene.y(v)), gauge.ringRadius(dot));
    }
  }

  private void defects() {
    for (Defect defect : scene.defects()) {
      if (defect.kind() != Defect.Kind.TOO_FEW && defect.kind() != Defect.Kind.COLLINEAR) {
        pen.style(gauge.of(Stroke.solid(Ink.DEFECT, 2)));
        ring(view.screenX(defect.x()), view.screenY(defect.y()), DEFECT_RING * gauge.dots());
      }
    }
  }

  private void ring(double x, double y, double radius) {
    if (clip.holds(x, y)) {
      pen.ring(x, y, radius);
    }
  }
}
