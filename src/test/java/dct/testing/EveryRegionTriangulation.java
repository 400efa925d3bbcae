package dct.testing;

import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * The sets of odd vertices of every triangulation of a small region. All triangles are listed by
 * looking at every three vertices; then the side with the lowest number that lacks a triangle is
 * given each one that fits, until no side lacks one. Knows nothing of the code under test but the
 * orientation of three points and the rings.
 *
 * <p>Up to 30 vertices. Where no triangle is left and the area is filled, all sides are paired, so
 * nothing but the emptiness and the crossings of triangles needs to be checked.
 */
public final class EveryRegionTriangulation {
  private final Rings rings;
  private final Points p;
  private final int n;
  private final boolean[][] wall; // by directed pair: a boundary edge with the inside on its left
  private final boolean[][] edge; // by pair: they see each other, boundary and fixed ones included
  private final int[] turns; // orientation of three vertices, in base n
  private final int[][] crossing; // by pair a n + b: the pairs that cross it
  private final boolean[] isEmpty; // by three vertices, in base n: an empty triangle, to the left
  private final Set<Integer> oddSets = new HashSet<>();
  private final boolean[][] open; // by directed pair: lacks a triangle on its left
  private final boolean[][] done; // by directed pair: has one
  private int odd;
  private long steps;
  private final long most;

  /** Enumerates; {@link #isComplete} says whether so many steps were enough. */
  public EveryRegionTriangulation(Rings rings, long most) {
    this.rings = rings;
    this.most = most;
    p = rings.points();
    n = p.size();
    turns = new int[n * n * n];
    Arrays.setAll(turns, t -> p.orient(t / (n * n), (t / n) % n, t % n));
    isEmpty = new boolean[turns.length];
    crossing = new int[n * n][];
    wall = new boolean[n][n];
    edge = new boolean[n][n];
    open = new boolean[n][n];
    done = new boolean[n][n];
    ExactArea area = new ExactArea(p);
    for (int r = 0; r < rings.count(); r++) {
      boolean turned = (area.ofRing(rings.ring(r)).signum() > 0) != (r == 0);
      for (int k = 0; k < rings.size(r); k++) {
        int a = rings.vertex(r, k);
        int b = rings.after(a);
        wall[turned ? b : a][turned ? a : b] = true;
        odd ^= (1 << a) | (1 << b);
      }
    }
    for (int a = 0; a < n; a++) {
      for (int b = 0; b < n; b++) {
        edge[a][b] = a != b && isFree(a, b);
        open[a][b] = wall[a][b];
        crossing[a * n + b] = crossing(a, b);
        for (int c = 0; c < n; c++) {
          isEmpty[(a * n + b) * n + c] = turn(a, b, c) > 0 && isEmpty(a, b, c);
        }
      }
    }
    extend();
  }

  private int turn(int a, int b, int c) {
    return turns[(a * n + b) * n + c];
  }

  private boolean cross(int a, int b, int c, int d) {
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
  }

  private int[] crossing(int a, int b) {
    return IntStream.range(0, n * n).filter(q -> cross(a, b, q / n, q % n)).toArray();
  }

  /** No vertex between them, and no boundary or fixed edge crossed. */
  private boolean isFree(int a, int b) {
    for (int c = 0; c < n; c++) {
      boolean isBetween = turn(a, b, c) == 0 && p.yxLess(a, c) == p.yxLess(c, b);
      if (c != a && c != b && isBetween) {
        return false;
      }
    }
    for (int e = 0; e < n + rings.fixedCount(); e++) {
      if (e >= n || rings.isOnRing(e)) {
        int c = rings.from(e);
        int d = rings.to(e);
        if (cross(a, b, c, d)) {
          return false;
        }
      }
    }
    return true;
  }

  private void extend() {
    if (++steps > most) {
      return;
    }
    for (int a = 0; a < n; a++) {
      for (int b = 0; b < n; b++) {
        if (open[a][b]) {
          for (int c = 0; c < n; c++) {
            tryTriangle(a, b, c);
          }
          return;
        }
      }
    }
    oddSets.add(odd);
  }

  private void tryTriangle(int a, int b, int c) {
    if (!isEmpty[(a * n + b) * n + c] || !fits(b, c) || !fits(c, a)) {
      return;
    }
    int before = odd;
    List<int[]> opened = new ArrayList<>();
    close(a, b, opened);
    close(b, c, opened);
    close(c, a, opened);
    extend();
    undo(a, b);
    undo(b, c);
    undo(c, a);
    for (int[] side : opened) {
      open[side[0]][side[1]] = false;
    }
    odd = before;
  }

  /** Whether this side may be given a triangle: it is open, or new and crosses no other side. */
  private boolean fits(int a, int b) {
    if (open[a][b]) {
      return true;
    }
    if (!edge[a][b] || done[a][b] || done[b][a] || wall[a][b] || wall[b][a]) {
      return false;
    }
    for (int q : crossing[a * n + b]) {
      if (done[q / n][q % n] || open[q / n][q % n]) {
        return false;
      }
    }
    return true;
  }

  private void close(int a, int b, List<int[]> opened) {
    done[a][b] = true;
    if (open[a][b]) {
      open[a][b] = false;
      return;
    }
    open[b][a] = true;
    opened.add(new int[] {b, a});
    odd ^= (1 << a) | (1 << b);
  }

  private void undo(int a, int b) {
    done[a][b] = false;
    open[a][b] = wall[a][b] || done[b][a];
  }

  private boolean isEmpty(int a, int b, int c) {
    for (int d = 0; d < n; d++) {
      boolean isIn = turn(a, b, d) >= 0 && turn(b, c, d) >= 0 && turn(c, a, d) >= 0;
      if (isIn && d != a && d != b && d != c) {
        return false;
      }
    }
    return true;
  }

  /** Whether the enumeration came to its end. */
  public boolean isComplete() {
    return steps <= most;
  }

  /** The least number of vertices that miss their wish. */
  public int least(ParityGoal goal) {
    int wishedOdd = 0;
    int definite = 0;
    for (int v = 0; v < n; v++) {
      wishedOdd |= (goal.wish(v) == Wish.ODD ? 1 : 0) << v;
      definite |= (goal.wish(v) == Wish.ANY ? 0 : 1) << v;
    }
    int least = n;
    for (int set : oddSets) {
      least = Math.min(least, Integer.bitCount((set ^ wishedOdd) & definite));
    }
    return least;
  }
}
