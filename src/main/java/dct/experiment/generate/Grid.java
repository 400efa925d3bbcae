package dct.experiment.generate;

import dct.core.geometry.Points;

/**
 * The places where a generator may put points: (x, y) with 0 ≤ x &lt; columns and 0 ≤ y &lt; rows,
 * which stand for the coordinates (x, y) / 2^fraction.
 */
record Grid(long columns, long rows, int fraction) {

  /** How many places there are, as far as 64 bits can count them. */
  long places() {
    return Math.multiplyHigh(columns, rows) == 0 ? columns * rows : Long.MAX_VALUE;
  }

  /** The points at these places. */
  Points points(long[] x, long[] y) {
    return Points.of(scaled(x), scaled(y));
  }

  private double[] scaled(long[] places) {
    double step = Math.scalb(1.0, -fraction);
    double[] coordinates = new double[places.length];
    for (int i = 0; i < places.length; i++) {
      coordinates[i] = places[i] * step;
    }
    return coordinates;
  }
}
