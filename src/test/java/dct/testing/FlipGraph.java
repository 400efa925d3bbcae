package dct.testing;

import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Points;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.Set;

/**
 * Every triangulation of a few sites, by search along flips: the flip graph of a set of points is
 * connected. Knows nothing of the code under test but the orientation of three points.
 *
 * <p>A triangulation is a set of pairs of sites, a bit each, so that n may be up to 11.
 */
public final class FlipGraph {
  private final Points points;
  private final int n;
  private final int[] turns; // orientation of three sites, in base n
  private final Set<Long> triangulations = new HashSet<>();
  private final Set<Integer> oddSets = new HashSet<>(); // the sets of odd vertices that occur

  public FlipGraph(Points points) {
    this.points = points;
    n = points.size();
    turns = new int[n * n * n];
    for (int t = 0; t < turns.length; t++) {
      turns[t] =
          points.orient(Math.floorDiv(t, n * n), Math.floorDiv(t, n) % n, Math.floorMod(t, n));
    }
    search(first());
  }

  private int turn(int a, int b, int c) {
    return turns[(a * n + b) * n + c];
  }

  /** The number of triangulations. */
  public int triangulations() {
    return triangulations.size();
  }

  /** The least number of vertices that miss their wish. */
  public int least(ParityGoal goal) {
    int odd = 0;
    int definite = 0;
    for (int v = 0; v < n; v++) {
      odd |= (goal.wish(v) == Wish.ODD ? 1 : 0) << v;
      definite |= (goal.wish(v) == Wish.ANY ? 0 : 1) << v;
    }
    int least = n;
    for (int set : oddSets) {
      least = Math.min(least, Integer.bitCount((set ^ odd) & definite));
    }
    return least;
  }

  private void search(long start) {
    Deque<Long> open = new ArrayDeque<>();
    triangulations.add(start);
    open.add(start);
    while (!open.isEmpty()) {
      long edges = open.remove();
      oddSets.add(oddSet(edges));
      for (int a = 0; a < n; a++) {
        for (int b = a + 1; b < n; b++) {
          long flipped = has(edges, a, b) ? flipped(edges, a, b) : edges;
          if (triangulations.add(flipped)) {
            open.add(flipped);
          }
        }
      }
    }
  }

  private int oddSet(long edges) {
    int set = 0;
    for (int a = 0; a < n; a++) {
      for (int b = 0; b < n; b++) {
        set ^= a != b && has(edges, a, b) ? 1 << a : 0;
      }
    }
    return set;
  }

  /** Any maximal set of edges that do not cross. */
  private long first() {
    long edges = 0;
    for (int a = 0; a < n; a++) {
      for (int b = a + 1; b < n; b++) {
        edges |= isFree(a, b) && !crossesAny(edges, a, b) ? bit(a, b) : 0;
      }
    }
    return edges;
  }

  private boolean isFree(int a, int b) {
    for (int c = 0; c < n; c++) {
      if (c != a && c != b && turn(a, b, c) == 0 && isBetween(a, c, b)) {
        return false;
      }
    }
    return true;
  }

  private boolean isBetween(int a, int c, int b) {
    return between(points.x(a), points.x(c), points.x(b))
        && between(points.y(a), points.y(c), points.y(b));
  }

  private static boolean between(double a, double c, double b) {
    return Math.min(a, b) <= c && c <= Math.max(a, b);
  }

  private boolean crossesAny(long edges, int a, int b) {
    for (int c = 0; c < n; c++) {
      for (int d = c + 1; d < n; d++) {
        if (has(edges, c, d) && crosses(a, b, c, d)) {
          return true;
        }
      }
    }
    return false;
  }

  private boolean crosses(int a, int b, int c, int d) {
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
  }

  /** The triangulation after the flip of a b; the same if it cannot be flipped. */
  private long flipped(long edges, int a, int b) {
    int c = apex(edges, a, b);
    int d = apex(edges, b, a);
    boolean canFlip = c >= 0 && d >= 0 && crosses(a, b, c, d);
    return canFlip ? (edges & ~bit(a, b)) | bit(c, d) : edges;
  }

  /** The third corner of the triangle on the left of a b, or −1. */
  private int apex(long edges, int a, int b) {
    for (int c = 0; c < n; c++) {
      boolean isTriangle = c != a && c != b && has(edges, a, c) && has(edges, b, c);
      if (isTriangle && turn(a, b, c) > 0 && isEmpty(a, b, c)) {
        return c;
      }
    }
    return -1;
  }

  private boolean isEmpty(int a, int b, int c) {
    for (int d = 0; d < n; d++) {
      boolean isInside = turn(a, b, d) >= 0 && turn(b, c, d) >= 0 && turn(c, a, d) >= 0;
      if (isInside && d != a && d != b && d != c) {
        return false;
      }
    }
    return true;
  }

  private static boolean has(long edges, int a, int b) {
    return (edges & bit(a, b)) != 0;
  }

  private static long bit(int a, int b) {
    int high = Math.max(a, b);
    return 1L << (high * (high - 1) / 2 + Math.min(a, b));
  }
}
