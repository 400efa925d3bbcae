package dct.core.degree.exact;

import java.util.Arrays;

/**
 * Follows a filled {@link SweepTable} back from the upper hull to the lower one: at each path some
 * triangle below it was the last to be added. O(n²) steps.
 */
final class SweepTrace {
  private final SweepTable table;
  private final SweepOrder sites;
  private int[] corners = new int[0]; // three sites a triangle, counter-clockwise
  private int path;
  private int parities;

  SweepTrace(SweepTable table) {
    this.table = table;
    sites = table.sites();
    path = table.hullPath(false);
    parities = bestParities();
  }

  private int bestParities() {
    int best = 0;
    int least = Integer.MAX_VALUE;
    for (int p = 0; p < 4 << Integer.bitCount(path); p++) {
      int cost = table.cost(path, p) + table.penalties(path, p);
      boolean isReached = table.cost(path, p) < SweepTable.UNREACHED;
      if (isReached && cost < least) {
        best = p;
        least = cost;
      }
    }
    return best;
  }

  /** The triangles of one best triangulation: three sites each, counter-clockwise. */
  int[] triangles() {
    int lower = table.hullPath(true);
    while (path != lower) {
      int[] ranks = table.ranks(path);
      if (!undoJoin(ranks) && !undoFinish(ranks)) {
        throw new IllegalStateException("no triangle leads to path " + path);
      }
    }
    return corners;
  }

  /** Takes away a triangle whose tip is on the path. */
  private boolean undoJoin(int[] ranks) {
    for (int k = 1; k + 1 < ranks.length; k++) {
      int before = path & ~SweepTable.bit(ranks[k]);
      boolean canJoin = table.canJoin(ranks[k - 1], ranks[k], ranks[k + 1]);
      int turned = parities ^ (5 << (k - 1));
      int parted = (turned & ((1 << k) - 1)) | turned >> (k + 1) << k;
      boolean isEven = (parities >> k & 1) == 0;
      if (canJoin && isEven && table.cost(before, parted) == table.cost(path, parities)) {
        add(ranks[k - 1], ranks[k + 1], ranks[k]);
        path = before;
        parities = parted;
        return true;
      }
    }
    return false;
  }

  /** Takes away a triangle whose tip lies below the path. */
  private boolean undoFinish(int[] ranks) {
    for (int k = 1; k < ranks.length; k++) {
      for (int c = ranks[k - 1] + 1; c < ranks[k]; c++) {
        boolean canLeave = table.canLeave(ranks[k - 1], c, ranks[k]);
        if (canLeave && (undoFinish(k, c, 0) || undoFinish(k, c, 1))) {
          add(ranks[k - 1], c, ranks[k]);
          return true;
        }
      }
    }
    return false;
  }

  /** Puts c back on the path at position k, with this parity, if that cost as much. */
  private boolean undoFinish(int k, int c, int parity) {
    int before = path | SweepTable.bit(c);
    int turned = parities ^ (3 << (k - 1));
    int low = turned & ((1 << k) - 1);
    int put = low | parity << k | (turned ^ low) << 1;
    boolean fits = table.cost(before, put) + table.penalty(c, parity) == table.cost(path, parities);
    if (fits) {
      path = before;
      parities = put;
    }
    return fits;
  }

  private void add(int a, int b, int c) {
    int k = corners.length;
    corners = Arrays.copyOf(corners, k + 3);
    corners[k] = sites.site(a);
    corners[k + 1] = sites.site(b);
    corners[k + 2] = sites.site(c);
  }
}
