package dct.core.geometry;

import dct.core.Progress;

/**
 * Point sites, all different: exact duplicates are merged into their first occurrence, once, here.
 *
 * <p>The sites keep the order in which they were entered; a merged duplicate has no number.
 */
public final class Sites {
  private final Points points;
  private final int merged;

  private Sites(Points points, int merged) {
    this.points = points;
    this.merged = merged;
  }

  /**
   * The different points among these, in O(n) expected time.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Sites of(Points points, Progress progress) {
    boolean[] duplicate = new boolean[points.size()];
    int merged = new FirstOccurrences(points).markOthers(duplicate, progress);
    return new Sites(merged == 0 ? points : without(points, duplicate, merged), merged);
  }

  private static Points without(Points points, boolean[] duplicate, int merged) {
    double[] x = new double[points.size() - merged];
    double[] y = new double[x.length];
    int k = 0;
    for (int i = 0; i < duplicate.length; i++) {
      if (!duplicate[i]) {
        x[k] = points.x(i);
        y[k++] = points.y(i);
      }
    }
    return Points.of(x, y);
  }

  /** The sites, all different. */
  public Points points() {
    return points;
  }

  /** Whether no three of them span a triangle, in O(n). */
  public boolean areOnOneLine() {
    for (int i = 2; i < points.size(); i++) {
      if (points.orient(0, 1, i) != 0) {
        return false;
      }
    }
    return true;
  }

  /** The number of sites, n. */
  public int size() {
    return points.size();
  }

  /** How many of the points given were duplicates of an earlier one. */
  public int merged() {
    return merged;
  }
}
