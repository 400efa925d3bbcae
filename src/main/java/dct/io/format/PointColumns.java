package dct.io.format;

import dct.core.geometry.Points;
import java.util.Arrays;

/** A growing list of points and the lines that they stand on. */
public final class PointColumns {
  private double[] x = new double[16];
  private double[] y = new double[16];
  private int[] line = new int[16];
  private int size;

  public void add(double px, double py, int pointLine) {
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

  /** Whether the last of several points is at the place of the first. */
  public boolean isClosed() {
    return size > 1 && x[0] == x[size - 1] && y[0] == y[size - 1];
  }

  /** Removes the last point. */
  public void removeLast() {
    size--;
  }

  /** How many there are. */
  public int size() {
    return size;
  }

  public Points points() {
    return Points.of(Arrays.copyOf(x, size), Arrays.copyOf(y, size));
  }

  public int[] lines() {
    return Arrays.copyOf(line, size);
  }
}
