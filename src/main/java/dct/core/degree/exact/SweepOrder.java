package dct.core.degree.exact;

import dct.core.geometry.Points;
import java.util.Arrays;
import java.util.Comparator;

/**
 * A few sites in the order of a sweep, with every question that a sweep over paths asks of them
 * answered beforehand. Sites are named by their rank in the order. O(n⁴) time, O(n³) space.
 *
 * <p>Along x the order is by x, then y; along y it is by y, then −x, the same turned by a right
 * angle. Either is that of a sweep line turned by an infinitesimal angle more, so that equal
 * coordinates need no special case. "Above" is on the left of the direction of the sweep.
 */
final class SweepOrder {
  private final int[] site; // by rank
  private final int[][][] turn; // orientation of three ranks
  private final boolean[][] sees; // a < b with no site on the segment between them
  private final boolean[][][] empty; // a < c < b that span a triangle with no other site

  /** The sites in the order by x, then y. */
  static SweepOrder alongX(Points points) {
    return new SweepOrder(
        points, Comparator.<Integer>comparingDouble(points::x).thenComparingDouble(points::y));
  }

  /** The sites in the order by y, then −x. */
  static SweepOrder alongY(Points points) {
    return new SweepOrder(
        points,
        Comparator.<Integer>comparingDouble(points::y).thenComparingDouble(v -> -points.x(v)));
  }

  private SweepOrder(Points points, Comparator<Integer> direction) {
    int n = points.size();
    Integer[] order = new Integer[n];
    Arrays.setAll(order, v -> v);
    Arrays.sort(order, direction);
    site = Arrays.stream(order).mapToInt(v -> v).toArray();
    turn = new int[n][n][n];
    sees = new boolean[n][n];
    empty = new boolean[n][n][n];
    for (int a = 0; a < n; a++) {
      for (int b = a + 1; b < n; b++) {
        findTurns(points, a, b);
      }
    }
    for (int a = 0; a < n; a++) {
      for (int b = a + 1; b < n; b++) {
        sees[a][b] = isFree(a, b);
        for (int c = a + 1; c < b; c++) {
          empty[a][c][b] = turn[a][b][c] != 0 && isEmpty(a, c, b);
        }
      }
    }
  }

  private void findTurns(Points points, int a, int b) {
    for (int c = 0; c < site.length; c++) {
      turn[a][b][c] = points.orient(site[a], site[b], site[c]);
      turn[b][a][c] = -turn[a][b][c];
    }
  }

  private boolean isFree(int a, int b) {
    for (int c = a + 1; c < b; c++) {
      if (turn[a][b][c] == 0) {
        return false;
      }
    }
    return true;
  }

  private boolean isEmpty(int a, int c, int b) {
    int side = turn[a][c][b];
    for (int d = a + 1; d < b; d++) {
      boolean isInside =
          turn[a][c][d] * side >= 0 && turn[c][b][d] * side >= 0 && turn[b][a][d] * side >= 0;
      if (d != c && isInside) {
        return false;
      }
    }
    return true;
  }

  /** The number of sites. */
  int size() {
    return site.length;
  }

  /** The site with this rank. */
  int site(int rank) {
    return site[rank];
  }

  /** Whether no site lies on the segment between a &lt; b. */
  boolean sees(int a, int b) {
    return sees[a][b];
  }

  /** Whether c lies above the line from a to b. */
  boolean isAbove(int a, int b, int c) {
    return turn[a][b][c] > 0;
  }

  /** Whether c lies below the line from a to b. */
  boolean isBelow(int a, int b, int c) {
    return turn[a][b][c] < 0;
  }

  /** Whether a &lt; c &lt; b span a triangle with no other site in it or on it. */
  boolean isEmptyTriangle(int a, int c, int b) {
    return empty[a][c][b];
  }
}
