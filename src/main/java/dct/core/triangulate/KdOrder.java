package dct.core.triangulate;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Points;

/**
 * Sites in an order in which near ones stand near each other, and a tree of parts over it: every
 * part [lo, hi) is cut so that all before the cut precede all after it, by x and then y on even
 * levels, by y and then x on odd ones.
 *
 * <p>The upper part of the tree is that of the cells of a grid over the bounding box, halved in
 * turn along both axes and numbered from left to right, into which the sites are counted in linear
 * time. A part is cut at its median where the cells end, or where they would leave a single site on
 * one side: by quickselect with a median of three from fixed places, and where these do badly with
 * the median of medians, so that every order of the sites takes O(n log n) time in all. Where the
 * sites end does not depend on the pivots, since no two are equal and the last few are sorted.
 */
final class KdOrder {
  static final int LEAF = 8; // parts of so many sites or fewer are not cut
  static final int ROOT = 1; // the node of all cells; the halves of node k are 2k and 2k + 1
  static final int MEDIANS = 0; // in place of a node: from here on, cuts are at medians
  private static final int PER_CELL = 9; // sites at least, on average
  private static final int MOST_LEVELS = 24;
  private static final int FEW_LOOKS = 8; // for each site; twice what a median takes on average

  final double[] x; // coordinates, by place
  final double[] y;
  final int[] site; // the number of the site at each place
  private final int cells; // a power of two; nodes from here on are single cells
  private final int[] start; // by cell: the place of its first site; and the end of the last

  KdOrder(Points points, Progress progress) {
    int n = points.size();
    x = new double[n];
    y = new double[n];
    site = new int[n];
    int levels = Math.min(MOST_LEVELS, log2(n / PER_CELL));
    cells = 1 << levels;
    start = new int[cells + 1];
    fill(points, new CellNumbers(points, levels), progress);
  }

  /** Rounded down; 0 of 0. */
  private static int log2(int number) {
    return 31 - Integer.numberOfLeadingZeros(number | 1);
  }

  /** Counts the sites into their cells. */
  private void fill(Points points, CellNumbers numbers, Progress progress) {
    int[] cell = new int[x.length];
    for (int i = 0; i < cell.length; i++) {
      Progress.check(progress, i);
      cell[i] = numbers.of(points.x(i), points.y(i));
      start[cell[i]]++;
    }
    int end = 0;
    for (int c = 0; c < cells; c++) {
      end += start[c];
      start[c] = end;
    }
    start[cells] = end;
    for (int i = cell.length - 1; i >= 0; i--) {
      Progress.check(progress, i);
      int place = --start[cell[i]];
      x[place] = points.x(i);
      y[place] = points.y(i);
      site[place] = i;
    }
  }

  /** Where the node's cells are halved, or {@link Dcel#NONE} if it has no two halves. */
  int cellCut(int node) {
    if (node == MEDIANS || node >= cells) {
      return Dcel.NONE;
    }
    int right = 2 * node + 1;
    int below = Integer.numberOfLeadingZeros(right) - Integer.numberOfLeadingZeros(cells);
    return start[(right << below) - cells];
  }

  /** Cuts [lo, hi) at its median; returns where that is. */
  int cutAtMedian(int lo, int hi, boolean byX) {
    int middle = (lo + hi) >>> 1;
    select(lo, hi - 1, middle, byX);
    return middle;
  }

  /** Whether the point at place i precedes that at place j, by x first or by y first. */
  boolean precedes(int i, int j, boolean byX) {
    return precedes(x[i], y[i], x[j], y[j], byX);
  }

  private static boolean precedes(double px, double py, double qx, double qy, boolean byX) {
    return byX ? px < qx || (px == qx && py < qy) : py < qy || (py == qy && px < qx);
  }

  /**
   * Sorts a few sites by x and then y, by insertion: a constant order, since this runs in every
   * leaf.
   */
  void sortFew(int lo, int hi) {
    for (int i = lo + 1; i < hi; i++) {
      double px = x[i];
      double py = y[i];
      int s = site[i];
      int j = i;
      for (; j > lo && precedes(px, py, x[j - 1], y[j - 1], true); j--) {
        x[j] = x[j - 1];
        y[j] = y[j - 1];
        site[j] = site[j - 1];
      }
      x[j] = px;
      y[j] = py;
      site[j] = s;
    }
  }

  /**
   * Puts the site that belongs at {@code place} of [first, last] there, smaller ones before it.
   *
   * @return how many places were looked at, at most 60 for each site
   */
  long select(int first, int last, int place, boolean byX) {
    long budget = FEW_LOOKS * (last - first + 1L);
    long looks = 0;
    int lo = first;
    int hi = last;
    while (lo < hi) {
      int pivot;
      if (looks <= budget) {
        pivot = medianOfThree(lo, (lo + hi) >>> 1, hi, byX);
      } else { // an order made against the medians of three
        looks += medianOfMedians(lo, hi, byX);
        pivot = lo;
      }
      looks += hi - lo + 1;
      double px = x[pivot];
      double py = y[pivot];
      int i = lo;
      int j = hi;
      while (i <= j) {
        while (precedes(x[i], y[i], px, py, byX)) {
          i++;
        }
        while (precedes(px, py, x[j], y[j], byX)) {
          j--;
        }
        if (i <= j) {
          swap(i++, j--);
        }
      }
      if (place <= j) {
        hi = j;
      } else if (place >= i) {
        lo = i;
      } else {
        break;
      }
    }
    return looks;
  }

  private void sortFive(int lo, int hi, boolean byX) {
    for (int i = lo + 1; i < hi; i++) {
      for (int j = i; j > lo && precedes(x[j], y[j], x[j - 1], y[j - 1], byX); j--) {
        swap(j, j - 1);
      }
    }
  }

  /**
   * Puts a site at lo that three tenths of [lo, hi] precede and three tenths follow: the median of
   * the medians of five (Blum, Floyd, Pratt, Rivest and Tarjan 1973).
   *
   * @return how many places were looked at
   */
  private long medianOfMedians(int lo, int hi, boolean byX) {
    int medians = lo;
    for (int five = lo; five <= hi; five += 5) {
      int end = Math.min(five + 5, hi + 1);
      sortFive(five, end, byX);
      swap(medians++, (five + end - 1) >>> 1);
    }
    int middle = (lo + medians - 1) >>> 1;
    long looks = select(lo, medians - 1, middle, byX);
    swap(lo, middle);
    return looks + hi - lo + 1;
  }

  private int medianOfThree(int a, int b, int c, boolean byX) {
    if (precedes(a, b, byX)) {
      return precedes(b, c, byX) ? b : precedes(a, c, byX) ? c : a;
    }
    return precedes(a, c, byX) ? a : precedes(b, c, byX) ? c : b;
  }

  private void swap(int i, int j) {
    double px = x[i];
    x[i] = x[j];
    x[j] = px;
    double py = y[i];
    y[i] = y[j];
    y[j] = py;
    int s = site[i];
    site[i] = site[j];
    site[j] = s;
  }
}
