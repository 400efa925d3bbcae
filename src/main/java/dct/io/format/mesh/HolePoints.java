package dct.io.format.mesh;

import dct.core.Progress;
import dct.core.geometry.InvalidGeometryException;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.EarClipping;
import dct.io.format.CannotHold;
import java.util.Arrays;

/**
 * A point in each hole of a region: the centre of the largest triangle of the hole's triangulation,
 * that is proven to lie inside of it. O(m log m) for m vertices of holes, mostly.
 */
final class HolePoints {
  private HolePoints() {}

  /**
   * The points, in the order of the holes.
   *
   * @throws CannotHold if there is no such point for one of them
   */
  static Points of(Rings rings) throws CannotHold {
    double[] x = new double[rings.count() - 1];
    double[] y = new double[x.length];
    for (int h = 0; h < x.length; h++) {
      double[] centre = centre(rings, h + 1);
      x[h] = centre[0];
      y[h] = centre[1];
    }
    return Points.of(x, y);
  }

  private static double[] centre(Rings rings, int r) throws CannotHold {
    Points all = rings.points();
    Points hole =
        Points.of(
            Arrays.stream(rings.ring(r)).mapToDouble(all::x).toArray(),
            Arrays.stream(rings.ring(r)).mapToDouble(all::y).toArray());
    try {
      int[] t =
          EarClipping.triangulate(SimplePolygon.of(hole, Progress.NONE), Progress.NONE).triangles();
      double[] best = largest(hole, t);
      if (best.length > 0) {
        return best;
      }
    } catch (InvalidGeometryException e) {
      // the same sentence as where there is no point
    }
    throw new CannotHold(
        "it takes a point inside each hole, and there is none in that at vertex v"
            + rings.vertex(r, 0)
            + "; choose .txt or .json");
  }

  /** The centre of the largest triangle that holds its rounded centre; empty if none does. */
  private static double[] largest(Points points, int... corners) {
    double[] best = {};
    double most = 0;
    for (int t = 0; t < corners.length; t += 3) {
      double ax = points.x(corners[t]);
      double ay = points.y(corners[t]);
      double bx = points.x(corners[t + 1]) - ax;
      double by = points.y(corners[t + 1]) - ay;
      double cx = points.x(corners[t + 2]) - ax;
      double cy = points.y(corners[t + 2]) - ay;
      double area = bx * cy - by * cx;
      if (area > most) {
        double[] centre = {ax + (bx + cx) / 3, ay + (by + cy) / 3};
        if (holds(points, corners, t, centre)) {
          most = area;
          best = centre;
        }
      }
    }
    return best;
  }

  private static boolean holds(Points points, int[] corners, int t, double... place) {
    for (int k = 0; k < 3; k++) {
      int u = corners[t + k];
      int v = corners[t + (k + 1) % 3];
      Points three =
          Points.ofPairs(points.x(u), points.y(u), points.x(v), points.y(v), place[0], place[1]);
      if (three.orient(0, 1, 2) <= 0) {
        return false;
      }
    }
    return true;
  }
}
