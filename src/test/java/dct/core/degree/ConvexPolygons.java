package dct.core.degree;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.testing.RandomPolygons;
import dct.testing.Transforms;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Convex polygons for tests, and what all their triangulations can reach. */
final class ConvexPolygons {
  static final int MOST = 300;

  private ConvexPolygons() {}

  /** A convex polygon with n vertices, clockwise for odd n. */
  static SimplePolygon convex(int n) {
    Points p = RandomPolygons.convex(n, new Random(n));
    return SimplePolygon.of(n % 2 == 0 ? p : Transforms.reversed(p), Progress.NONE);
  }

  /** The least and the most odd vertices over all triangulations of a convex n-gon. */
  static int[] extremes(int n) {
    int[] best = {n, 0};
    for (int[] degrees : triangulations(0, n - 1, n)) {
      int odd = 0;
      for (int degree : degrees) {
        odd += degree & 1;
      }
      best[0] = Math.min(best[0], odd);
      best[1] = Math.max(best[1], odd);
    }
    return best;
  }

  /** The degrees in each triangulation of the vertices i … j, the side ij included. */
  private static List<int[]> triangulations(int i, int j, int n) {
    List<int[]> all = new ArrayList<>();
    if (j == i + 1) {
      int[] side = new int[n];
      side[i]++;
      side[j]++;
      all.add(side);
      return all;
    }
    for (int k = i + 1; k < j; k++) {
      for (int[] left : triangulations(i, k, n)) {
        for (int[] right : triangulations(k, j, n)) {
          int[] sum = new int[n];
          for (int v = 0; v < n; v++) {
            sum[v] = left[v] + right[v];
          }
          sum[i]++;
          sum[j]++;
          all.add(sum);
        }
      }
    }
    return all;
  }
}
