package dct.core.degree.colour;

import java.util.Arrays;
import java.util.BitSet;
import java.util.stream.IntStream;

/**
 * The rows on the edges between empty triangles: what each can still sum to, and which are to be
 * looked at. Row 2e + q is that of edge e and the colour q; it adds the triangles on the left of
 * the edge and subtracts those on its right. On the ring of a hole the colour of the ring counts as
 * well, on the side where there is no triangle.
 */
final class RowSums {
  private final int[] least; // by row
  private final int[] greatest; // by row
  private final int[] wanted; // by row: 0 but on the boundary
  private final int[] oneSided; // rows that settle something before any value is known
  private final int[] queue; // a ring of rows to look at, first come, first served
  private final boolean[] isQueued; // by row
  private int end; // where the next one goes
  private int waiting;
  private BitSet used = new BitSet(); // edges

  RowSums(AllTriangles triangles) {
    int rows = 2 * triangles.edges();
    least = new int[rows];
    greatest = new int[rows];
    wanted = new int[rows];
    queue = new int[rows];
    isQueued = new boolean[rows];
    for (int e = 0; e < triangles.edges(); e++) {
      int left = (int) Arrays.stream(triangles.sidesOn(e)).filter(triangles::isForward).count();
      Arrays.fill(greatest, 2 * e, 2 * e + 2, left);
      Arrays.fill(least, 2 * e, 2 * e + 2, left - triangles.sidesOn(e).length);
    }
    oneSided = IntStream.range(0, rows).filter(r -> least[r] == 0 || greatest[r] == 0).toArray();
  }

  /** One more unknown in a row, which is added or subtracted. */
  void extend(int row, boolean isAdded) {
    if (isAdded) {
      greatest[row]++;
    } else {
      least[row]--;
    }
  }

  /** The inverse of {@link #extend}, while the unknown is free. */
  void shorten(int row, boolean wasAdded) {
    if (wasAdded) {
      greatest[row]--;
    } else {
      least[row]++;
    }
  }

  /** From now on only the rows of these edges count; those that settle something are to be seen. */
  void use(BitSet edges) {
    clear();
    used = edges;
    for (int r : oneSided) {
      touch(r);
    }
  }

  boolean isUsed(int edge) {
    return used.get(edge);
  }

  /** What a row must sum to. */
  void want(int row, int sum) {
    wanted[row] = sum;
  }

  /** Whether a row must sum to something else than 0. */
  boolean isWanted(int row) {
    return wanted[row] != 0;
  }

  /** One unknown of a row becomes known: the least sum grows, or the greatest shrinks. */
  void narrow(int row, boolean raises) {
    if (raises) {
      least[row]++;
    } else {
      greatest[row]--;
    }
    touch(row);
  }

  /** The inverse of {@link #narrow}. */
  void widen(int row, boolean raised) {
    if (raised) {
      least[row]--;
    } else {
      greatest[row]++;
    }
  }

  private void touch(int row) {
    boolean isTight = least[row] >= wanted[row] || greatest[row] <= wanted[row];
    if (isTight && !isQueued[row] && used.get(row >> 1)) {
      isQueued[row] = true;
      queue[end++] = row;
      end = end == queue.length ? 0 : end;
      waiting++;
    }
  }

  boolean isWaiting() {
    return waiting > 0;
  }

  /** Takes the row that waits longest. */
  int next() {
    int first = end - waiting--;
    int row = queue[first < 0 ? first + queue.length : first];
    isQueued[row] = false;
    return row;
  }

  void clear() {
    while (waiting > 0) {
      next();
    }
  }

  boolean isBroken(int row) {
    return least[row] > wanted[row] || greatest[row] < wanted[row];
  }

  /** Whether the least sum is more than the row must have, or just that. */
  boolean isLow(int row) {
    return least[row] >= wanted[row];
  }

  boolean isSettled(int row) {
    return least[row] == greatest[row];
  }
}
