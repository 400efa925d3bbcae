package dct.bench;

import earcut4j.Earcut;

/** Earcut4j, ear clipping with a z-order curve. */
final class EarcutPeer {
  private EarcutPeer() {}

  static int[] polygon(double[] x, double[] y) {
    double[] flat = new double[2 * x.length];
    for (int i = 0; i < x.length; i++) {
      flat[2 * i] = x[i];
      flat[2 * i + 1] = y[i];
    }
    return Earcut.earcut(flat).stream().mapToInt(Integer::intValue).toArray();
  }
}
