package dct.core.triangulate;

import dct.core.geometry.Points;
import java.util.concurrent.RecursiveAction;

/**
 * Sites in the order of a balanced kd-tree: every part [lo, hi) with more than {@link #LEAF} sites
 * is cut at {@link #middle} so that those before it precede those after it, by x and then y on even
 * levels, by y and then x on odd ones. The sites of smaller parts are sorted by x and then y.
 *
 * <p>Quickselect with a median of three from fixed places, O(n log n) expected time.
 */
final class KdOrder {
  static final int LEAF = 8; // parts of so many sites or fewer are not cut
  private static final int PARALLEL = 1 << 10; // parts of at least this size are cut in parallel

  final double[] x; // coordinates in kd-order
  final double[] y;
  final int[] site; // the number of the site at each place

  KdOrder(Points points) {
    x = points.xs();
    y = points.ys();
    site = new int[x.length];
    for (int i = 0; i < site.length; i++) {
      site[i] = i;
    }
    new Cut(0, site.length, true).invoke();
  }

  /** Where the part [lo, hi) is cut. */
  static int middle(int lo, int hi) {
    return (lo + hi) >>> 1;
  }

  /** Whether the point at place i precedes that at place j, by x first or by y first. */
  boolean precedes(int i, int j, boolean byX) {
    return precedes(x[i], y[i], x[j], y[j], byX);
  }

  private static boolean precedes(double px, double py, double qx, double qy, boolean byX) {
    return byX ? px < qx || (px == qx && py < qy) : py < qy || (py == qy && px < qx);
  }

  private final class Cut extends RecursiveAction {
    private static final long serialVersionUID = 1L;
    private final int lo;
    private final int hi;
    private final boolean byX;

    Cut(int lo, int hi, boolean byX) {
      this.lo = lo;
      this.hi = hi;
      this.byX = byX;
    }

    @Override
    protected void compute() {
      if (hi - lo < PARALLEL) {
        cut(lo, hi, byX);
        return;
      }
      int middle = middle(lo, hi);
      select(lo, hi - 1, middle, byX);
      invokeAll(new Cut(lo, middle, !byX), new Cut(middle, hi, !byX));
    }
  }

  private void cut(int lo, int hi, boolean byX) {
    if (hi - lo <= LEAF) {
      sortFew(lo, hi);
      return;
    }
    int middle = middle(lo, hi);
    select(lo, hi - 1, middle, byX);
    cut(lo, middle, !byX);
    cut(middle, hi, !byX);
  }

  /** Sorts a few sites by x and then y, by insertion. */
  private void sortFew(int lo, int hi) {
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

  /** Puts the site that belongs at {@code place} of [first, last] there, smaller ones before it. */
  private void select(int first, int last, int place, boolean byX) {
    int lo = first;
    int hi = last;
    while (lo < hi) {
      int pivot = medianOfThree(lo, (lo + hi) >>> 1, hi, byX);
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
        return;
      }
    }
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
