package dct.render;

import dct.core.geometry.Box;
import dct.core.triangulate.MovedSite;
import dct.render.Pen.Anchor;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Writes labels beside the vertices, away from their edges, and leaves out those that would cover
 * one written before.
 */
final class LabelPainter {
  private static final double SIZE = 11;
  private static final double CELL_WIDTH = 16;
  private static final double CELL_HEIGHT = 12;
  private static final double CROWDED =
      1.5; // dots are smaller where no label has a side of its own

  private final Scene scene;
  private final Viewport view;
  private final Box screen;
  private final double dot;
  private final double distance;
  private final Map<Integer, double[]> away = new HashMap<>(); // by vertex: the sum of directions
  private final int columns;
  private final BitSet taken = new BitSet(); // cells of the screen, row by row

  LabelPainter(Scene scene, Viewport view, Box screen, double dot) {
    this.scene = scene;
    this.view = view;
    this.screen = screen;
    this.dot = dot;
    this.distance = dot + SIZE * 0.75;
    this.columns = column(screen.maxX()) + 1;
  }

  void paint(Pen pen) {
    if (dot > CROWDED) {
      pointAway();
    }
    pen.style(Stroke.fill(Ink.LABEL));
    for (int v = 0; v < scene.size(); v++) {
      double x = view.screenX(scene.x(v));
      double y = view.screenY(scene.y(v));
      if (screen.holds(x, y)) {
        label(pen, v, x, y);
      }
    }
  }

  /** For each vertex in sight, the reverse of the mean direction of its edges. */
  private void pointAway() {
    List<IndexedEdges> layers = scene.index().layers();
    for (int layer = 0; layer < layers.size(); layer++) {
      pointAway(layers.get(layer), scene.patch().hidden(layer));
      for (MovedSite.Edge edge : scene.patch().added(layer)) {
        pointAway(edge.from(), edge.to());
      }
    }
  }

  private void pointAway(IndexedEdges edges, Few hidden) {
    SceneIndex index = scene.index();
    Blocks blocks = edges.blocks();
    int block = blocks.next(0, view, screen);
    for (; block < blocks.count(); block = blocks.next(block + 1, view, screen)) {
      for (int k = blocks.first(block); k < blocks.end(block); k++) {
        if (!hidden.holds(k)) {
          pointAway(index.vertex(edges.from(k)), index.vertex(edges.to(k)));
        }
      }
    }
  }

  private void pointAway(int u, int v) {
    double dx = view.screenX(scene.x(u)) - view.screenX(scene.x(v));
    double dy = view.screenY(scene.y(u)) - view.screenY(scene.y(v));
    double length = Math.max(Math.hypot(dx, dy), 1e-9);
    add(u, dx / length, dy / length);
    add(v, -dx / length, -dy / length);
  }

  private void add(int v, double dx, double dy) {
    double[] sum = away.computeIfAbsent(v, key -> new double[2]);
    sum[0] += dx;
    sum[1] += dy;
  }

  private void label(Pen pen, int v, double x, double y) {
    double[] sum = away.getOrDefault(v, new double[2]);
    double length = Math.hypot(sum[0], sum[1]);
    boolean anywhere = length < 0.2;
    double dx = anywhere ? 0.7 : sum[0] / length;
    double dy = anywhere ? -0.7 : sum[1] / length;
    double atY = y + dy * distance;
    if (!taken.get(cell(column(x + dx * distance), atY))) {
      label(pen, scene.label(v), x, dx, atY);
    }
  }

  private void label(Pen pen, String text, double x, double dx, double atY) {
    double halfWidth = text.length() * SIZE * 0.3;
    double atX = x + dx * (distance + halfWidth / 2);
    if (!text.isEmpty() && take(atX, atY, halfWidth)) {
      pen.text(atX, atY + SIZE * 0.36, Anchor.MIDDLE, SIZE, text);
    }
  }

  /** Claims the cells under a label, unless one of them is taken. */
  private boolean take(double atX, double atY, double halfWidth) {
    int first = cell(column(atX - halfWidth), atY);
    int last = cell(column(atX + halfWidth), atY);
    int next = taken.nextSetBit(first);
    if (next >= 0 && next <= last) {
      return false;
    }
    taken.set(first, last + 1);
    return true;
  }

  private int cell(int column, double atY) {
    int row = (int) Math.max(0, Math.round((atY - screen.minY()) / CELL_HEIGHT) + 1);
    return row * columns + column;
  }

  /** The column at this x; what lies outside the screen belongs to the first or the last. */
  private int column(double atX) {
    double inside = Math.max(screen.minX(), Math.min(screen.maxX(), atX));
    return (int) Math.floor((inside - screen.minX()) / CELL_WIDTH);
  }
}
