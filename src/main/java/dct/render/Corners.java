package dct.render;

import dct.core.geometry.Box;
import dct.core.geometry.Points;
import java.util.Arrays;

/**
 * The corners of a polygon on the screen, in order, cut off at a box: inside the box it covers what
 * it covered before.
 *
 * <p>Sutherland and Hodgman's way (1974), one side of the box after the other, in linear time.
 */
final class Corners {
  private double[] x;
  private double[] y;
  private int count;

  private Corners(Points points, Viewport view) {
    count = points.size();
    x = new double[count];
    y = new double[count];
    for (int v = 0; v < count; v++) {
      x[v] = view.screenX(points.x(v));
      y[v] = view.screenY(points.y(v));
    }
  }

  /** The corners within this part of the screen. */
  static Corners of(Points points, Viewport view, Box part) {
    Corners corners = new Corners(points, view);
    corners.cut(part.minX());
    corners.turn();
    corners.cut(part.minY());
    corners.turn();
    corners.cut(-part.maxX());
    corners.turn();
    corners.cut(-part.maxY());
    corners.turn();
    return corners;
  }

  /** Keeps what lies right of an upright line. */
  private void cut(double at) {
    double[] oldX = x;
    double[] oldY = y;
    int old = count;
    count = 0;
    x = new double[old];
    y = new double[old];
    for (int i = 0, last = old - 1; i < old; last = i, i++) {
      if (oldX[i] >= at != oldX[last] >= at) {
        double part = (at - oldX[last]) / (oldX[i] - oldX[last]);
        add(at, oldY[last] + part * (oldY[i] - oldY[last]));
      }
      if (oldX[i] >= at) {
        add(oldX[i], oldY[i]);
      }
    }
  }

  private void add(double cornerX, double cornerY) {
    if (count == x.length) {
      x = Arrays.copyOf(x, 2 * count);
      y = Arrays.copyOf(y, 2 * count);
    }
    x[count] = cornerX;
    y[count++] = cornerY;
  }

  /** Turns the plane by a quarter: what was below is on the right. */
  private void turn() {
    double[] oldX = x;
    x = y;
    y = oldX;
    for (int i = 0; i < count; i++) {
      y[i] = -y[i];
    }
  }

  /** Whether so few are left that they cover nothing, or one of them is no number. */
  boolean isEmpty() {
    double sum = 0;
    for (int i = 0; i < count; i++) {
      sum += 0 * (x[i] + y[i]);
    }
    return count < 3 || Double.isNaN(sum);
  }

  /** Their x-coordinates. */
  double[] xs() {
    return Arrays.copyOf(x, count);
  }

  /** Their y-coordinates. */
  double[] ys() {
    return Arrays.copyOf(y, count);
  }
}
