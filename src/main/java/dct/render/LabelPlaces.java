package dct.render;

import dct.core.geometry.Box;
import dct.core.triangulate.MovedSite;
import dct.render.Pen.Anchor;
import java.util.List;

/**
 * Finds places for labels beside vertices: each at one of eight places round its vertex where no
 * vertex and no other label is, and few edges; of a polygon rather outside.
 *
 * <p>Who asks first is served first. Linear in the number of vertices and edges in sight.
 */
final class LabelPlaces {
  private static final double ADVANCE = 0.31; // half a letter's; no pen need know its font
  private static final double HALF_HEIGHT = 0.45;
  private static final double BASELINE = 0.36; // below the middle of a line
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
  private final double dot;
  private final Outwards outwards;
  private final Cells taken; // by vertices and labels
  private final Cells edges;
  private Box frame; // that labels have to be in; null for none

  /**
   * The places of a screen on which there are no labels yet.
   *
   * @param dot the radius of the vertices
   */
  LabelPlaces(Scene scene, Viewport view, Box screen, double dot) {
    this.scene = scene;
    this.view = view;
    this.screen = screen;
    this.near = screen.grown(BEYOND);
    this.dot = dot;
    this.outwards = new Outwards(scene, view);
    this.taken = new Cells(near, view);
    this.edges = new Cells(near, view);
    takeVertices();
  }

  /** Keeps labels inside a box, all of each. */
  void keepWithin(Box box) {
    frame = box;
  }

  /** Lets no label be in a box. */
  void take(Box box) {
    taken.take(box.minX(), box.minY(), box.maxX(), box.maxY());
  }

  /** Lets no label be within so much of a vertex. */
  void take(int v, double radius) {
    takeVertex(scene.x(v), scene.y(v), radius);
  }

  private void takeVertices() {
    SceneIndex index = scene.index();
    Blocks blocks = index.blocks();
    int block = blocks.next(0, view, near);
    for (; block < blocks.count(); block = blocks.next(block + 1, view, near)) {
      for (int place = blocks.first(block); place < blocks.end(block); place++) {
        if (!scene.patch().isLeft(place)) {
          takeVertex(index.x(place), index.y(place), dot);
        }
      }
    }
    if (scene.patch().isArrived()) {
      int v = scene.patch().site();
      takeVertex(scene.x(v), scene.y(v), dot);
    }
  }

  private void takeVertex(double modelX, double modelY, double radius) {
    double x = view.screenX(modelX);
    double y = view.screenY(modelY);
    if (near.holds(x, y)) {
      double r = radius * SLANT;
      taken.take(x - r, y - r, x + r, y + r);
    }
  }

  /** Has labels keep clear of edges where they can, and of the inside of a polygon. */
  void takeEdges() {
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

  /** Whether a vertex is in sight, or near enough for its label to have its say in the others. */
  boolean isNear(int v) {
    return near.holds(view.screenX(scene.x(v)), view.screenY(scene.y(v)));
  }

  /** Whether the middle of the shortest label would be free anywhere; in a crowd it rarely is. */
  boolean hasRoom(int v, double radius, double size) {
    double x = view.screenX(scene.x(v));
    double y = view.screenY(scene.y(v));
    double r = radius + GAP;
    for (double[] direction : DIRECTIONS) {
      double middleX = x + r * direction[0] + size * ADVANCE * Math.signum(direction[0]);
      double middleY = y + r * direction[1] + size * HALF_HEIGHT * Math.signum(direction[1]);
      if (taken.isFree(middleX, middleY)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Takes the best place for a label; without one it is left out.
   *
   * @param radius of the dot or ring at the vertex
   * @param size of the letters
   * @param pen what writes it
   */
  void label(int v, String text, double radius, double size, Pen pen) {
    double x = view.screenX(scene.x(v));
    double y = view.screenY(scene.y(v));
    double[] out = outwards.of(v);
    Place best = null;
    double least = Double.POSITIVE_INFINITY;
    for (double[] direction : DIRECTIONS) {
      Place place = place(x, y, radius, direction, size, text.length());
      double cost = place.isFree() ? cost(place, direction, out) : Double.POSITIVE_INFINITY;
      if (cost < least) {
        least = cost;
        best = place;
      }
    }
    if (best != null) {
      best.take();
      if (screen.holds(best.x, best.y)) {
        pen.text(best.x, best.y + size * BASELINE, Anchor.MIDDLE, size, text);
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

  /** The place of a label of so many letters, in a direction from its dot or ring. */
  private Place place(
      double x, double y, double radius, double[] direction, double size, int letters) {
    double r = radius + GAP;
    double dx = direction[0];
    double dy = direction[1];
    double halfWidth = size * ADVANCE * letters;
    double halfHeight = size * HALF_HEIGHT;
    return new Place(
        x + r * dx + halfWidth * Math.signum(dx),
        y + r * dy + halfHeight * Math.signum(dy),
        halfWidth,
        halfHeight);
  }

  /** A place of a label, by its middle. */
  private final class Place {
    private final double x;
    private final double y;
    private final double halfWidth;
    private final double halfHeight;

    Place(double x, double y, double halfWidth, double halfHeight) {
      this.x = x;
      this.y = y;
      this.halfWidth = halfWidth;
      this.halfHeight = halfHeight;
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
      return 4 * halfWidth * halfHeight / (Cells.SIDE * Cells.SIDE);
    }

    private double left() {
      return x - halfWidth;
    }

    private double right() {
      return x + halfWidth;
    }

    private double upper() {
      return y - halfHeight;
    }

    private double lower() {
      return y + halfHeight;
    }
  }
}
