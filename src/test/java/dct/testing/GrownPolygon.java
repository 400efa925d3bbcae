package dct.testing;

import dct.core.geometry.Points;
import java.util.Random;

/**
 * A polygon grown from a triangle by new vertices: a random grid point replaces a random edge by
 * two where nothing else is touched. On a small grid many points fall on an edge and become
 * straight vertices.
 */
final class GrownPolygon {
  private static final int TRIES = 60;

  private GrownPolygon() {}

  /** A polygon of n vertices, or fewer where a small grid gets full. */
  static Points grow(int n, int range, Random random) {
    Points p = triangle(range, random);
    for (int tries = 0; p.size() < n && tries < TRIES; tries++) {
      double x = random.nextInt(range);
      double y = random.nextInt(range);
      int edge = random.nextInt(p.size());
      for (int k = 0; k < Math.min(p.size(), 12); k++) {
        Points longer = p.inserted((edge + k) % p.size() + 1, x, y);
        if (mayInsert(longer, (edge + k) % p.size() + 1)) {
          p = longer;
          tries = 0;
          break;
        }
      }
    }
    return random.nextBoolean() ? p : Transforms.reversed(p);
  }

  private static Points triangle(int range, Random random) {
    Points p;
    do {
      p = RandomPolygons.points(RandomPolygons.distinct(3, Math.max(range, 2), random));
    } while (Exact.orient(p, 0, 1, 2) == 0);
    return p;
  }

  /** Whether the two edges at the new vertex v meet nothing but each other and their neighbours. */
  private static boolean mayInsert(Points p, int v) {
    int n = p.size();
    int before = v - 1;
    int after = (v + 1) % n;
    SimplicityOracle oracle = new SimplicityOracle(p);
    if (p.same(v, before) || p.same(v, after)) {
      return false;
    }
    if (oracle.turnsBack(before) || oracle.turnsBack(v) || oracle.turnsBack(after)) {
      return false;
    }
    for (int i = 0; i < n; i++) {
      boolean nearFirst = i == before || i == v || (i + 1) % n == before;
      boolean nearSecond = i == before || i == v || i == after;
      if ((!nearFirst && oracle.edgesMeet(before, i)) || (!nearSecond && oracle.edgesMeet(v, i))) {
        return false;
      }
    }
    return true;
  }
}
