package dct.testing;

import dct.core.geometry.Points;
import java.math.BigInteger;
import java.util.Arrays;

/** Doubled signed areas over the vertices of one point list, as integers of one common scale. */
public final class ExactArea {
  private final BigInteger[] x;
  private final BigInteger[] y;

  public ExactArea(Points points) {
    int n = points.size();
    double[] all = new double[2 * n];
    System.arraycopy(points.xs(), 0, all, 0, n);
    System.arraycopy(points.ys(), 0, all, n, n);
    BigInteger[] scaled = Exact.scaled(all);
    x = Arrays.copyOf(scaled, n);
    y = Arrays.copyOfRange(scaled, n, 2 * n);
  }

  /** Of the closed chain through these vertices: positive if counter-clockwise. */
  public BigInteger ofRing(int... ring) {
    BigInteger sum = BigInteger.ZERO;
    for (int k = 1; k + 1 < ring.length; k++) {
      sum = sum.add(ofTriangle(ring[0], ring[k], ring[k + 1]));
    }
    return sum;
  }

  private BigInteger ofTriangle(int a, int b, int c) {
    return Exact.cross(
        x[b].subtract(x[a]), y[b].subtract(y[a]), x[c].subtract(x[a]), y[c].subtract(y[a]));
  }
}
