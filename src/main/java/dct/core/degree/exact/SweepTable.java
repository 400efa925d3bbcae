package dct.core.degree.exact;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import java.util.Arrays;

/**
 * For every path through the sites from the first to the last in the order of the sweep, and for
 * all parities of the degrees on it: the least number of sites below it that miss their wish.
 *
 * <p>A path is a set of inner ranks; bit k of its parities belongs to its k-th site. A triangle is
 * added in one of two ways, each of which joins two sites a and b of the path and so turns their
 * parities:
 *
 * <pre>
 *         c                   a ───────── b
 *       ↗   ↘                   ↘       ↗
 *     a ····· b                     c
 *    c joins the path        c leaves it: finished
 * </pre>
 *
 * <p>Paths with fewer triangles below come first. Where s sites lie strictly below a path of l
 * sites, there are 2s + l triangles and a constant, so all ways to a path agree on their number.
 */
final class SweepTable {
  static final byte UNREACHED = 64;
  private static final int NO_PATH = -1;
  private static final int STATES_BETWEEN_REPORTS = 1 << 12;

  private final SweepOrder sites;
  private final ParityGoal goal;
  private final int[] offset; // by path: where its states begin in cost, or NO_PATH
  private byte[] cost; // by state: offset of the path plus parities
  private int[] order; // the paths, those with fewer triangles below first

  SweepTable(SweepOrder sites, ParityGoal goal) {
    this.sites = sites;
    this.goal = goal;
    offset = new int[1 << (sites.size() - 2)];
    Arrays.fill(offset, NO_PATH);
  }

  // ---- paths

  /** The ranks on a path, the first and the last site included. */
  int[] ranks(int path) {
    int[] ranks = new int[Integer.bitCount(path) + 2];
    int k = 1;
    for (int rest = path; rest != 0; rest &= rest - 1) {
      ranks[k++] = Integer.numberOfTrailingZeros(rest) + 1;
    }
    ranks[k] = sites.size() - 1;
    return ranks;
  }

  /** The bit of an inner rank in a path. */
  static int bit(int rank) {
    return 1 << (rank - 1);
  }

  /** The path along the lower hull, or along the upper one: no site lies beyond it. */
  int hullPath(boolean lower) {
    int path = 0;
    int a = 0;
    while (a < sites.size() - 1) {
      a = nextOnHull(a, lower);
      path |= a < sites.size() - 1 ? bit(a) : 0;
    }
    return path;
  }

  private int nextOnHull(int a, boolean lower) {
    int next = a + 1;
    for (int b = a + 2; b < sites.size(); b++) {
      if (lower ? sites.isBelow(a, next, b) : sites.isAbove(a, next, b)) {
        next = b;
      }
    }
    return next;
  }

  private void orderPaths() {
    int paths = offset.length;
    long[] byTriangles = new long[paths]; // triangles below, then path
    int count = 0;
    for (int path = 0; path < paths; path++) {
      int below = sitesBelow(path);
      if (below >= 0) {
        byTriangles[count++] = ((2L * below + Integer.bitCount(path)) << Integer.SIZE) | path;
      }
    }
    Arrays.sort(byTriangles, 0, count);
    order = new int[count];
    int states = 0;
    for (int i = 0; i < count; i++) {
      order[i] = (int) byTriangles[i];
      offset[order[i]] = states;
      states += 4 << Integer.bitCount(order[i]);
    }
    cost = new byte[states];
    Arrays.fill(cost, UNREACHED);
  }

  /** How many sites lie strictly below, or −1 if an edge runs over a site. */
  private int sitesBelow(int path) {
    int below = 0;
    int a = 0;
    for (int rest = path; a < sites.size() - 1; rest &= rest - 1) {
      int b = rest == 0 ? sites.size() - 1 : Integer.numberOfTrailingZeros(rest) + 1;
      if (!sites.sees(a, b)) {
        return -1;
      }
      for (int c = a + 1; c < b; c++) {
        below += sites.isBelow(a, b, c) ? 1 : 0;
      }
      a = b;
    }
    return below;
  }

  // ---- states

  /** The least cost of a path with these parities. */
  int cost(int path, int parities) {
    return cost[offset[path] + parities];
  }

  /** What it costs that the site with this rank has this degree: 1 if it misses its wish. */
  int penalty(int rank, int degree) {
    return goal.wish(sites.site(rank)).penalty(degree);
  }

  /** The sites. */
  SweepOrder sites() {
    return sites;
  }

  /** The cost of the sites on a path with these degrees, up to parity. */
  int penalties(int path, int parities) {
    int sum = 0;
    int[] ranks = ranks(path);
    for (int k = 0; k < ranks.length; k++) {
      sum += penalty(ranks[k], parities >> k & 1);
    }
    return sum;
  }

  /**
   * Computes all costs.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  void fill(Progress progress) {
    orderPaths();
    int lower = hullPath(true);
    // On the bare path all sites have two edges, the first and the last one.
    cost[offset[lower] + (1 | 2 << Integer.bitCount(lower))] = 0;
    long states = 0;
    for (int i = 0; i < order.length; i++) {
      long since = states / STATES_BETWEEN_REPORTS;
      states += 4L << Integer.bitCount(order[i]);
      if (i == 0 || states / STATES_BETWEEN_REPORTS > since) {
        progress.checkCancelled();
        progress.report((double) states / cost.length, "Searching every triangulation");
      }
      leave(order[i]);
    }
  }

  /** Adds every possible triangle above a path. */
  private void leave(int path) {
    int[] ranks = ranks(path);
    for (int k = 0; k + 1 < ranks.length; k++) {
      for (int c = ranks[k] + 1; c < ranks[k + 1]; c++) {
        if (canJoin(ranks[k], c, ranks[k + 1])) {
          join(path, k, c);
        }
      }
    }
    for (int k = 1; k + 1 < ranks.length; k++) {
      if (canLeave(ranks[k - 1], ranks[k], ranks[k + 1])) {
        finish(path, k, ranks[k]);
      }
    }
  }

  /** Whether c can join a path between its neighbouring sites a and b. */
  boolean canJoin(int a, int c, int b) {
    return sites.isAbove(a, b, c) && sites.isEmptyTriangle(a, c, b);
  }

  /** Whether c can leave a path on which a and b are its neighbours. */
  boolean canLeave(int a, int c, int b) {
    return sites.isBelow(a, b, c) && sites.isEmptyTriangle(a, c, b);
  }

  /** The parities after a site with an even number of edges joins at position k + 1. */
  static int joined(int parities, int k) {
    int low = parities & ((2 << k) - 1);
    return (low | (parities ^ low) << 1) ^ (5 << k);
  }

  /** The parities after the site at position k has left. */
  static int finished(int parities, int k) {
    int low = parities & ((1 << k) - 1);
    return (low | parities >> (k + 1) << k) ^ (3 << (k - 1));
  }

  private void join(int path, int k, int c) {
    int from = offset[path];
    int to = offset[path | bit(c)];
    int states = 4 << Integer.bitCount(path);
    for (int parities = 0; parities < states; parities++) {
      lower(to + joined(parities, k), cost[from + parities]);
    }
  }

  private void finish(int path, int k, int c) {
    int from = offset[path];
    int to = offset[path & ~bit(c)];
    int states = 4 << Integer.bitCount(path);
    int ifEven = penalty(c, 0);
    int ifOdd = penalty(c, 1);
    for (int parities = 0; parities < states; parities++) {
      int more = (parities >> k & 1) == 0 ? ifEven : ifOdd;
      lower(to + finished(parities, k), cost[from + parities] + more);
    }
  }

  private void lower(int state, int value) {
    if (value < cost[state]) {
      cost[state] = (byte) value;
    }
  }
}
