package dct.render;

import dct.core.geometry.Box;
import dct.core.triangulate.MovedSite;
import dct.render.Pen.Anchor;
import java.util.BitSet;
import java.util.List;

/**
 * Writes labels beside the vertices: each at one of eight places round its vertex where no vertex
 * and no other label is, and few edges; of a polygon rather outside. A label for which there is no
 * such place is left out.
 *
 * <p>Vertices are served in their order, so that a picture always has the same labels; while it is
 * panned they stay where they are. Linear in the number of vertices, and of edges in sight.
 */
final class LabelPainter {
  private static final double SIZE = 11;
  private static final double ADVANCE = 0.31 * SIZE; // half a letter's; no pen need know its font
  private static final double HALF_HEIGHT = 0.45 * SIZE;
  private static final double BASELINE = 0.36 * SIZE; // below the middle of a line
  private static final double GAP = 2.5; // between a dot and its label
  private static final double BEYOND = 80; // what lies so far outside has its say in who is served
  private static final double SLANT = Math.sqrt(0.5);
  private static final double INSIDE = 6; // as bad as edges in so many cells
  private static final double AWAY = 2; // the same where there is no inside
  private static final double COVERED = 0.5; // of a label's cells; with more edges it is left out

  /** The directions from a vertex to its label; of equally good ones the first is taken. */
  private static final double[][] DIRECTIONS = {
    {SLANT, -SLANT},
    {-SLANT, -SLANT},
    {SLANT, SLANT},
    {-SLANT, SLANT},
    {1, 0},
    {-1, 0},
    {0, -1},
    {0, 1}
  };

  private final Scene scene;
  private final Viewport view;
  private final Box screen;
  private final Box near;
  private final Gauge gauge;
  private final double dot;
  private final BitSet ringed; // the vertices with a ring round them
  private final Outwards outwards;
  private final Cells taken; // by vertices and labels
  private final Cells edges;
  private Box frame; // that labels have to be in; null for none

  private LabelPainter(Scene scene, Viewport view, Box screen, Gauge gauge, double dot) {
    this.scene = scene;
    this.view = view;
    this.screen = screen;
    this.near = screen.grown(BEYOND);
    this.gauge = gauge;
    this.dot = dot;
    this.ringed = new BitSet();
    for (int v : scene.unmet()) {
      ringed.set(v);
    }
    this.outwards = new Outwards(scene, view);
    this.taken = new Cells(near, view);
    this.edges = new Cells(near, view);
  }

  /** Writes the labels in sight of a screen that can be panned, beside dots of this radius. */
  static void paint(Scene scene, Viewport view, Box screen, double dot, Pen pen) {
    new LabelPainter(scene, view, screen, Gauge.SCREEN, dot).paint(pen);
  }

  /**
   * Writes the labels of a picture that ends at its borders: all of each is inside.
   *
   * @param taken where no label may be
   */
  static void paint(
      Scene scene, Viewport view, Box picture, Gauge gauge, double dot, List<Box> taken, Pen pen) {
    LabelPainter painter = new LabelPainter(scene, view, picture, gauge, dot);
    painter.frame = picture;
    for (Box box : taken) {
      painter.taken.take(box.minX(), box.minY(), box.maxX(), box.maxY());
    }
    painter.paint(pen);
  }

  private void paint(Pen pen) {
    takeVertices();
    if (!Dots.areCrowded(dot / gauge.dots())) {
      takeEdges();
    }
    pen.part(Part.LABELS);
    pen.style(Stroke.fill(Ink.LABEL));
    for (int v = 0; v < scene.size(); v++) {
      double x = view.screenX(scene.x(v));
      double y = view.screenY(scene.y(v));
      double radius = radius(v);
      if (near.holds(x, y) && hasRoom(x, y, radius)) {
        label(pen, v, x, y, radius);
      }
    }
  }

  private double radius(int v) {
    return ringed.get(v) ? gauge.ringRadius(dot) : dot;
  }

  private void takeVertices() {
    SceneIndex index = scene.index();
    Blocks blocks = index.blocks();
    int block = blocks.next(0, view, near);
    for (; block < blocks.count(); block = blocks.next(block + 1, view, near)) {
      for (int place = blocks.first(block); place < blocks.end(block); place++) {
        if (!scene.patch().isLeft(place)) {
          takeVertex(index.vertex(place), index.x(place), index.y(place));
        }
      }
    }
    if (scene.patch().isArrived()) {
      int v = scene.patch().site();
      takeVertex(v, scene.x(v), scene.y(v));
    }
  }

  private void takeVertex(int v, double modelX, double modelY) {
    double x = view.screenX(modelX);
    double y = view.screenY(modelY);
    if (near.holds(x, y)) {
      double r = radius(v) * SLANT;
      taken.take(x - r, y - r, x + r, y + r);
    }
  }

  private void takeEdges() {
    List<IndexedEdges> layers = scene.index().layers();
    for (int layer = 0; layer < layers.size(); layer++) {
      takeEdges(layers.get(layer), scene.patch().hidden(layer));
      for (MovedSite.Edge edge : scene.patch().added(layer)) {
        takeEdge(edge.from(), edge.to());
      }
    }
  }

  private void takeEdges(IndexedEdges layer, Few hidden) {
    SceneIndex index = scene.index();
    Blocks blocks = layer.blocks();
    int block = blocks.next(0, view, near);
    for (; block < blocks.count(); block = blocks.next(block + 1, view, near)) {
      for (int k = blocks.first(block); k < blocks.end(block); k++) {
        if (!hidden.holds(k)) {
          takeEdge(index.vertex(layer.from(k)), index.vertex(layer.to(k)));
        }
      }
    }
  }

  private void takeEdge(int u, int v) {
    double ux = view.screenX(scene.x(u));
    double uy = view.screenY(scene.y(u));
    double vx = view.screenX(scene.x(v));
    double vy = view.screenY(scene.y(v));
    edges.takeLine(ux, uy, vx, vy);
    outwards.add(u, v, vx - ux, vy - uy);
  }

  /** Whether the middle of the shortest label would be free anywhere; in a crowd it rarely is. */
  private boolean hasRoom(double x, double y, double radius) {
    double r = radius + GAP;
    for (double[] direction : DIRECTIONS) {
      double middleX = x + r * direction[0] + ADVANCE * Math.signum(direction[0]);
      double middleY = y + r * direction[1] + HALF_HEIGHT * Math.signum(direction[1]);
      if (taken.isFree(middleX, middleY)) {
        return true;
      }
    }
    return false;
  }

  /** Writes the label at the best place, if there is any. */
  private void label(Pen pen, int v, double x, double y, double radius) {
    String text = scene.label(v);
    if (text.isEmpty()) {
      return;
    }
    double[] out = outwards.of(v);
    Place best = null;
    double least = Double.POSITIVE_INFINITY;
    for (double[] direction : DIRECTIONS) {
      Place place = place(x, y, radius, direction, ADVANCE * text.length());
      double cost = place.isFree() ? cost(place, direction, out) : Double.POSITIVE_INFINITY;
      if (cost < least) {
        least = cost;
        best = place;
      }
    }
    if (best != null) {
      best.take();
      if (screen.holds(best.x, best.y)) {
        pen.text(best.x, best.y + BASELINE, Anchor.MIDDLE, SIZE, text);
      }
    }
  }

  private double cost(Place place, double[] direction, double[] out) {
    int cells = place.edges();
    if (cells > COVERED * place.cells()) {
      return Double.POSITIVE_INFINITY;
    }
    double turned = 1 - direction[0] * out[0] - direction[1] * out[1];
    return cells + (scene.isPolygon() ? INSIDE : AWAY) * turned;
  }

  /** The place of a label of this half width, in a direction from its dot or ring. */
  private Place place(double x, double y, double radius, double[] direction, double halfWidth) {
    double r = radius + GAP;
    double dx = direction[0];
    double dy = direction[1];
    return new Place(
        x + r * dx + halfWidth * Math.signum(dx),
        y + r * dy + HALF_HEIGHT * Math.signum(dy),
        halfWidth);
  }

  /** A place of a label, by its middle. */
  private final class Place {
    private final double x;
    private final double y;
    private final double halfWidth;

    Place(double x, double y, double halfWidth) {
      this.x = x;
      this.y = y;
      this.halfWidth = halfWidth;
    }

    boolean isFree() {
      return isInside() && taken.isFree(left(), upper(), right(), lower());
    }

    private boolean isInside() {
      return frame == null || (frame.holds(left(), upper()) && frame.holds(right(), lower()));
    }

    void take() {
      taken.take(left(), upper(), right(), lower());
    }

    int edges() {
      return edges.count(left(), upper(), right(), lower());
    }

    double cells() {
      return 4 * halfWidth * HALF_HEIGHT / (Cells.SIDE * Cells.SIDE);
    }

    private double left() {
      return x - halfWidth;
    }

    private double right() {
      return x + halfWidth;
    }

    private double upper() {
      return y - HALF_HEIGHT;
    }

    private double lower() {
      return y + HALF_HEIGHT;
    }
  }
}
