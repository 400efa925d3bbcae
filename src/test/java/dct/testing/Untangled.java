package dct.testing;

import dct.core.geometry.Points;
import java.util.Random;

/** A random order of random points, untangled by reversing the chain between meeting edges. */
final class Untangled {
  private static final int MOST_MOVES = 2000;

  private Untangled() {}

  /** A simple polygon of n vertices on a grid of this range; begins anew where it gets stuck. */
  static Points untangle(int n, int range, Random random) {
    int[] ring = new int[Math.max(n, 3)];
    while (true) {
      Points pool = RandomPolygons.points(RandomPolygons.distinct(ring.length, range, random));
      for (int i = 0; i < ring.length; i++) {
        ring[i] = i;
      }
      for (int moves = 0; moves < MOST_MOVES && untangleOnce(pool, ring); moves++) {}
      Points chain = RandomPolygons.select(pool, ring);
      if (SimplicityOracle.isSimple(chain)) {
        return chain;
      }
    }
  }

  /** Reverses one chain that makes the boundary shorter; false if there is none to be found. */
  private static boolean untangleOnce(Points p, int[] ring) {
    int n = ring.length;
    for (int i = 0; i < n; i++) {
      for (int j = i + 2; j < n; j++) {
        int ii = i + 1;
        int jj = (j + 1) % n;
        if (jj != i
            && SimplicityOracle.segmentsMeet(p, ring[i], ring[ii], ring[j], ring[jj])
            && shortens(p, ring[i], ring[ii], ring[j], ring[jj])) {
          reverse(ring, ii, j);
          return true;
        }
      }
    }
    return false;
  }

  private static boolean shortens(Points p, int a, int b, int c, int d) {
    return distance(p, a, c) + distance(p, b, d) < distance(p, a, b) + distance(p, c, d) - 1e-9;
  }

  private static double distance(Points p, int a, int b) {
    return Math.hypot(p.x(a) - p.x(b), p.y(a) - p.y(b));
  }

  private static void reverse(int[] ring, int from, int to) {
    for (int i = from, j = to; i < j; i++, j--) {
      int kept = ring[i];
      ring[i] = ring[j];
      ring[j] = kept;
    }
  }
}
