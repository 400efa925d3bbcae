package dct.render;

import dct.core.geometry.Box;
import java.util.HashMap;
import java.util.Map;

/**
 * For vertices, the direction on the screen in which there is the most room: out of a polygon, or
 * away from the edges of sites.
 */
final class Outwards {
  private static final double FLAT = 0.2; // shorter sums of unit vectors have no clear direction

  private final Scene scene;
  private final Viewport view;
  private final boolean polygon;
  private final double side; // +1 if the inside is on the left of the boundary as it is seen
  private final Map<Integer, double[]> away = new HashMap<>(); // by vertex: a sum of directions

  Outwards(Scene scene, Viewport view) {
    this.scene = scene;
    this.view = view;
    this.polygon = scene.isPolygon() && scene.size() > 0;
    this.side = polygon ? side() : 0;
  }

  /** The sign of the area on the screen, where y runs down: +1 for clockwise. */
  private double side() {
    Box box = scene.bounds().orElseThrow();
    double unit = Math.max(box.halfWidth(), box.halfHeight());
    double area = 0;
    for (int v = 0, last = scene.size() - 1; v < scene.size(); last = v, v++) {
      double ax = (scene.x(last) - box.centerX()) / unit;
      double ay = (scene.y(last) - box.centerY()) / unit;
      double bx = (scene.x(v) - box.centerX()) / unit;
      double by = (scene.y(v) - box.centerY()) / unit;
      area += ax * by - bx * ay;
    }
    return view.yUp() ? -Math.signum(area) : Math.signum(area);
  }

  /** Says that there is an edge of sites, from a to b on the screen. */
  void add(int from, int to, double dx, double dy) {
    if (!polygon) {
      double length = Math.max(Math.hypot(dx, dy), 1e-9);
      add(from, -dx / length, -dy / length);
      add(to, dx / length, dy / length);
    }
  }

  private void add(int v, double dx, double dy) {
    double[] sum = away.computeIfAbsent(v, key -> new double[2]);
    sum[0] += dx;
    sum[1] += dy;
  }

  /** A vector of length 1 from this vertex, or of length 0 if no direction is better. */
  double[] of(int v) {
    return polygon ? outOfPolygon(v) : unit(away.getOrDefault(v, new double[2]));
  }

  private double[] outOfPolygon(int v) {
    int n = scene.size();
    double[] in = unit(between((v + n - 1) % n, v));
    double[] out = unit(between(v, (v + 1) % n));
    // Of the boundary's left and right normals, the one that points outwards.
    double[] normal = unit(new double[] {side * (in[1] + out[1]), -side * (in[0] + out[0])});
    if (normal[0] != 0 || normal[1] != 0) {
      return normal;
    }
    double turn = side * (in[0] * out[1] - in[1] * out[0]); // positive at a convex corner
    double sign = turn >= 0 ? 1 : -1;
    return unit(new double[] {sign * (in[0] - out[0]), sign * (in[1] - out[1])});
  }

  private double[] between(int from, int to) {
    return new double[] {
      view.screenX(scene.x(to)) - view.screenX(scene.x(from)),
      view.screenY(scene.y(to)) - view.screenY(scene.y(from))
    };
  }

  private static double[] unit(double[] vector) {
    double length = Math.hypot(vector[0], vector[1]);
    return length < FLAT ? new double[2] : new double[] {vector[0] / length, vector[1] / length};
  }
}
