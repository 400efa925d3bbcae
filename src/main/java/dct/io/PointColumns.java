package dct.io;

import dct.core.geometry.Points;
import java.util.Arrays;

/** A growing list of points and the lines that they stand on. */
final class PointColumns {
  private double[] x = new double[16];
  private double[] y = new double[16];
  private int[] line = new int[16];
  private int size;

  void add(double px, double py, int pointLine) {
    if (size == x.length) {
      int longer = Math.multiplyExact(2, size);
      x = Arrays.copyOf(x, longer);
      y = Arrays.copyOf(y, longer);
      line = Arrays.copyOf(line, longer);
    }
    x[size] = px;
    y[size] = py;
    line[size++] = pointLine;
  }

  int size() {
    return size;
  }

  Points points() {
    return Points.of(Arrays.copyOf(x, size), Arrays.copyOf(y, size));
  }

  int[] lines() {
    return Arrays.copyOf(line, size);
  }
}
