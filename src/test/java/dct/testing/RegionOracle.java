package dct.testing;

import dct.core.geometry.Points;
import dct.core.geometry.Rings;

/** Whether rings bound a region, by looking at every pair of edges: quadratic and exact. */
public final class RegionOracle {
  private final Rings rings;
  private final Points p;
  private final int n;

  private RegionOracle(Rings rings) {
    this.rings = rings;
    this.p = rings.points();
    this.n = p.size();
  }

  /**
   * Whether these rings bound a region.
   *
   * @param rings coordinates are whole numbers, so that the middles of fixed edges are exact
   */
  public static boolean isRegion(Rings rings) {
    return new RegionOracle(rings).isRegion();
  }

  private boolean isRegion() {
    for (int r = 0; r < rings.count(); r++) {
      if (rings.size(r) < 3) {
        return false;
      }
    }
    return edgesAreApart() && holesAreInside() && insideIsInside();
  }

  private boolean edgesAreApart() {
    for (int v = 0; v < n; v++) {
      for (int w = 0; w < n; w++) {
        if (v != w && p.same(v, w)) {
          return false;
        }
      }
    }
    for (int e = 0; e < n + rings.fixedCount(); e++) {
      if (e < n && !rings.isOnRing(e)) {
        continue;
      }
      for (int v = 0; v < n; v++) {
        if (isInside(v, rings.from(e), rings.to(e))) {
          return false;
        }
      }
      for (int f = 0; f < e; f++) {
        if ((f >= n || rings.isOnRing(f)) && cross(e, f)) {
          return false;
        }
      }
    }
    return true;
  }

  private boolean isInside(int v, int a, int b) {
    return v != a && v != b && Exact.orient(p, a, b, v) == 0 && (p.yxLess(a, v) == p.yxLess(v, b));
  }

  private boolean cross(int e, int f) {
    int a = rings.from(e);
    int b = rings.to(e);
    int c = rings.from(f);
    int d = rings.to(f);
    return Exact.orient(p, a, b, c) * Exact.orient(p, a, b, d) < 0
        && Exact.orient(p, c, d, a) * Exact.orient(p, c, d, b) < 0;
  }

  private boolean holesAreInside() {
    for (int r = 1; r < rings.count(); r++) {
      int v = rings.vertex(r, 0);
      if (!isIn(0, p.x(v), p.y(v))) {
        return false;
      }
      for (int other = 1; other < rings.count(); other++) {
        if (other != r && isIn(other, p.x(v), p.y(v))) {
          return false;
        }
      }
    }
    return true;
  }

  private boolean insideIsInside() {
    for (int v = 0; v < n; v++) {
      if (!rings.isOnRing(v) && !isInRegion(p.x(v), p.y(v))) {
        return false;
      }
    }
    for (int j = 0; j < rings.fixedCount(); j++) {
      int u = rings.fixedFrom(j);
      int v = rings.fixedTo(j);
      if (!isInRegion((p.x(u) + p.x(v)) / 2, (p.y(u) + p.y(v)) / 2)) {
        return false;
      }
    }
    return true;
  }

  private boolean isInRegion(double x, double y) {
    for (int r = 0; r < rings.count(); r++) {
      if (isIn(r, x, y) != (r == 0)) {
        return false;
      }
    }
    return true;
  }

  /** Whether a place that is on no edge is inside this ring: an odd number of edges on its left. */
  private boolean isIn(int r, double x, double y) {
    boolean in = false;
    for (int k = 0; k < rings.size(r); k++) {
      int a = rings.vertex(r, k);
      int b = rings.after(a);
      int low = p.y(a) < p.y(b) ? a : b;
      int high = low == a ? b : a;
      if (p.y(low) <= y && y < p.y(high)) {
        in ^= Exact.orient(p.x(low), p.y(low), p.x(high), p.y(high), x, y) < 0;
      }
    }
    return in;
  }
}
