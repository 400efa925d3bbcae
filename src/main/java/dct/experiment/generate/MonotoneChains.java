package dct.experiment.generate;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.PlaneOrder;
import dct.core.geometry.Points;

/**
 * A random x-monotone polygon: random points in the order of x, those below the line from the first
 * to the last as the lower chain, those above as the upper.
 *
 * <p>Simple, as the chains are monotone and that line keeps them apart. (C. Zhu, G. Sundaram, J.
 * Snoeyink and J. Mitchell, "Generating random polygons with given vertices", 1996, draw uniformly
 * from all x-monotone polygons of the points; here the split is given by the points.) Points with
 * the same x come in the order of y. O(n) time.
 */
final class MonotoneChains {
  private MonotoneChains() {}

  /** A counter-clockwise polygon of n vertices. */
  static Points polygon(int n, Area area, SeededRandom random, Progress progress) {
    Places p = Places.spread(n, area.grid(), random);
    Points points = p.points();
    int[] order = PlaneOrder.byYThenX(Points.of(points.ys(), points.xs()), progress);
    return p.points(chains(p, order));
  }

  private static int[] chains(Places p, int[] order) {
    int n = order.length;
    int first = order[0];
    int last = order[n - 1];
    boolean anyLower = false;
    for (int v : order) {
      anyLower |= p.turn(first, last, v) < 0;
    }
    int[] ring = new int[n];
    int low = 0;
    int high = n - 1;
    for (int v : order) {
      long side = p.turn(first, last, v);
      // What lies on the line goes to the chain that would be this line without it.
      boolean lower = side < 0 || v == first || (side == 0 && v != last && !anyLower);
      ring[lower ? low++ : high--] = v;
    }
    return ring;
  }
}
