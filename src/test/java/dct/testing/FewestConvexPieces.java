package dct.testing;

import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The fewest strictly convex pieces into which diagonals can cut a small polygon, by trying all: a
 * piece that is not strictly convex has a corner of 180° or more, at which some diagonal must end.
 */
public final class FewestConvexPieces {
  /** Polygons with more vertices take too long. */
  public static final int MOST_VERTICES = 13;

  private final Points p;
  private final Map<Integer, Integer> known = new HashMap<>(); // by set of vertices

  private FewestConvexPieces(Points p) {
    this.p = p;
  }

  /** The number of pieces. */
  public static int of(SimplePolygon polygon) {
    return new FewestConvexPieces(polygon.points()).fewest(polygon.walk());
  }

  private int fewest(int[] ring) {
    int set = 0;
    for (int v : ring) {
      set |= 1 << v;
    }
    Integer before = known.get(set);
    int count = before != null ? before : tryAll(ring);
    known.put(set, count);
    return count;
  }

  private int tryAll(int[] ring) {
    int k = notConvex(ring);
    if (k < 0) {
      return 1;
    }
    int best = Integer.MAX_VALUE;
    int n = ring.length;
    for (int j = 2; j <= n - 2; j++) {
      int[] one = part(ring, k, j);
      int[] other = part(ring, (k + j) % n, n - j);
      if (isSimpleAndCounterClockwise(one) && isSimpleAndCounterClockwise(other)) {
        best = Math.min(best, fewest(one) + fewest(other));
      }
    }
    return best;
  }

  /** The place of a corner of 180° or more, or −1. */
  private int notConvex(int[] ring) {
    int n = ring.length;
    for (int k = 0; k < n; k++) {
      if (Exact.orient(p, ring[(k + n - 1) % n], ring[k], ring[(k + 1) % n]) <= 0) {
        return k;
      }
    }
    return -1;
  }

  /** The vertices from place k on, so many steps. */
  private static int[] part(int[] ring, int k, int steps) {
    List<Integer> part = new ArrayList<>();
    for (int i = 0; i <= steps; i++) {
      part.add(ring[(k + i) % ring.length]);
    }
    return part.stream().mapToInt(Integer::intValue).toArray();
  }

  /** A diagonal is one of the inside if and only if both its parts are such polygons. */
  private boolean isSimpleAndCounterClockwise(int[] ring) {
    return SimplicityOracle.isSimple(RandomPolygons.select(p, ring))
        && new ExactArea(p).ofRing(ring).signum() > 0;
  }
}
