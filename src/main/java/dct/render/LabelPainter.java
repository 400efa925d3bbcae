package dct.render;

import dct.render.Pen.Anchor;
import java.util.HashSet;
import java.util.Set;

/**
 * Writes labels beside the vertices, away from their edges, and leaves out those that would cover
 * one written before.
 */
final class LabelPainter {
  private static final double SIZE = 11;
  private static final double CELL_WIDTH = 16;
  private static final double CELL_HEIGHT = 12;

  private final Scene scene;
  private final double[] x;
  private final double[] y;
  private final Box screen;
  private final double distance;
  private final Set<Long> taken = new HashSet<>();

  LabelPainter(Scene scene, double[] x, double[] y, Box screen, double dot) {
    this.scene = scene;
    this.x = x;
    this.y = y;
    this.screen = screen;
    this.distance = dot + SIZE * 0.75;
  }

  void paint(Pen pen) {
    double[] awayX = new double[x.length];
    double[] awayY = new double[x.length];
    pointAway(awayX, awayY);
    pen.style(Stroke.fill(Ink.LABEL));
    for (int v = 0; v < x.length; v++) {
      if (screen.holds(x[v], y[v])) {
        double length = Math.hypot(awayX[v], awayY[v]);
        boolean anywhere = length < 0.2;
        double dx = anywhere ? 0.7 : awayX[v] / length;
        double dy = anywhere ? -0.7 : awayY[v] / length;
        label(pen, v, dx, dy);
      }
    }
  }

  /** For each vertex, the reverse of the mean direction of its edges. */
  private void pointAway(double[] awayX, double[] awayY) {
    for (EdgeLayer layer : scene.layers()) {
      for (int k = 0; k < layer.size(); k++) {
        int a = layer.from(k);
        int b = layer.to(k);
        double length = Math.max(Math.hypot(x[a] - x[b], y[a] - y[b]), 1e-9);
        double dx = (x[a] - x[b]) / length;
        double dy = (y[a] - y[b]) / length;
        awayX[a] += dx;
        awayY[a] += dy;
        awayX[b] -= dx;
        awayY[b] -= dy;
      }
    }
  }

  private void label(Pen pen, int v, double dx, double dy) {
    String text = scene.label(v);
    double halfWidth = text.length() * SIZE * 0.3;
    double atX = x[v] + dx * (distance + halfWidth / 2);
    double atY = y[v] + dy * distance;
    if (!text.isEmpty() && take(atX, atY, halfWidth)) {
      pen.text(atX, atY + SIZE * 0.36, Anchor.MIDDLE, SIZE, text);
    }
  }

  /** Claims the cells under a label, unless one of them is taken. */
  private boolean take(double atX, double atY, double halfWidth) {
    Set<Long> cells = new HashSet<>();
    long row = Math.round(atY / CELL_HEIGHT);
    long last = (long) Math.floor((atX + halfWidth) / CELL_WIDTH);
    for (long column = (long) Math.floor((atX - halfWidth) / CELL_WIDTH);
        column <= last;
        column++) {
      cells.add((row << 32) ^ (column & 0xFFFF_FFFFL));
    }
    if (cells.stream().anyMatch(taken::contains)) {
      return false;
    }
    return taken.addAll(cells);
  }
}
