package dct.testing;

import dct.core.geometry.Points;

/** Whether a closed chain is simple, by looking at every pair of edges: quadratic and exact. */
public final class SimplicityOracle {
  private final Points p;
  private final int n;

  public SimplicityOracle(Points points) {
    this.p = points;
    this.n = points.size();
  }

  /** Whether the closed chain through these points bounds a simple polygon. */
  public static boolean isSimple(Points points) {
    return new SimplicityOracle(points).isSimple();
  }

  private boolean isSimple() {
    if (n < 3) {
      return false;
    }
    for (int i = 0; i < n; i++) {
      if (p.same(i, after(i)) || turnsBack(after(i))) {
        return false;
      }
      for (int j = i + 2; j < n; j++) {
        if (after(j) != i && edgesMeet(i, j)) {
          return false;
        }
      }
    }
    return true;
  }

  private int after(int i) {
    return i + 1 == n ? 0 : i + 1;
  }

  /** Whether the two edges at vertex v, which differs from its neighbours, share a segment. */
  public boolean turnsBack(int v) {
    int before = (v + n - 1) % n;
    int after = after(v);
    return Exact.orient(p, before, v, after) == 0 && !isBetween(v, before, after);
  }

  /** Whether the closed edges from vertices i and j have a point in common. */
  public boolean edgesMeet(int i, int j) {
    return segmentsMeet(p, i, after(i), j, after(j));
  }

  /** Whether the edges from i and j cross in a single point inside both. */
  public boolean edgesCross(int i, int j) {
    int a = Exact.orient(p, i, after(i), j) * Exact.orient(p, i, after(i), after(j));
    int b = Exact.orient(p, j, after(j), i) * Exact.orient(p, j, after(j), after(i));
    return a < 0 && b < 0;
  }

  /** Whether the edges from i and j lie on one line and share more than a point. */
  public boolean edgesOverlap(int i, int j) {
    int ii = after(i);
    int jj = after(j);
    boolean oneLine = Exact.orient(p, i, ii, j) == 0 && Exact.orient(p, i, ii, jj) == 0;
    return oneLine
        && !p.same(i, ii)
        && !p.same(j, jj)
        && (covers(i, ii, j) || covers(i, ii, jj) || covers(j, jj, i) || sameSegment(i, j));
  }

  private boolean sameSegment(int i, int j) {
    return (p.same(i, j) && p.same(after(i), after(j)))
        || (p.same(i, after(j)) && p.same(after(i), j));
  }

  private boolean covers(int a, int b, int v) {
    return isBetween(v, a, b);
  }

  /** Whether vertex v lies strictly inside the edge from i. */
  public boolean liesInside(int v, int i) {
    return Exact.orient(p, i, after(i), v) == 0 && isBetween(v, i, after(i));
  }

  /** For v on the line ab: whether it lies strictly between them. */
  private boolean isBetween(int v, int a, int b) {
    return !p.same(v, a) && !p.same(v, b) && inBox(p, a, b, v);
  }

  private static boolean inBox(Points p, int a, int b, int v) {
    return p.x(v) >= Math.min(p.x(a), p.x(b))
        && p.x(v) <= Math.max(p.x(a), p.x(b))
        && p.y(v) >= Math.min(p.y(a), p.y(b))
        && p.y(v) <= Math.max(p.y(a), p.y(b));
  }

  /** Whether the closed segments ab and cd have a point in common. */
  static boolean segmentsMeet(Points p, int a, int b, int c, int d) {
    int abc = Exact.orient(p, a, b, c);
    int abd = Exact.orient(p, a, b, d);
    int cda = Exact.orient(p, c, d, a);
    int cdb = Exact.orient(p, c, d, b);
    if (abc * abd < 0 && cda * cdb < 0) {
      return true;
    }
    return (abc == 0 && inBox(p, a, b, c))
        || (abd == 0 && inBox(p, a, b, d))
        || (cda == 0 && inBox(p, c, d, a))
        || (cdb == 0 && inBox(p, c, d, b));
  }
}
