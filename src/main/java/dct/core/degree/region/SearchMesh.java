package dct.core.degree.region;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.dcel.Dcel;
import dct.core.degree.ParityGoal;
import dct.core.geometry.HilbertOrder;
import dct.core.geometry.Predicates;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * A triangulation as a search works on it: bare arrays, nothing allocated after the start.
 *
 * <p>Vertices are numbered along a Hilbert curve. Triangle t has the half-edges 4t, 4t + 1, 4t + 2
 * counter-clockwise. The number of triangles and their numbers never change; a {@link MeshRegion}
 * rewrites the triangles of a region in place. Regions without a vertex in common may be rewritten
 * by different threads at once: none of the array elements they touch is the same.
 *
 * <p>Beyond a fixed edge there is a triangle, but no search may cross it: the twin of a half-edge e
 * on one is {@code fixed(t)}, a negative number, t being the half-edge on the other side. So growth
 * stops there as it does at the hull, by one comparison with 0.
 */
public final class SearchMesh {
  /** In place of a half-edge: there is none beyond the hull. */
  public static final int NONE = -1;

  private static final int TURNS = 8; // at most, around a vertex

  public final double[] x;
  public final double[] y;
  public final int[] corner; // by half-edge: the vertex that it leaves
  public final int[] twin; // by half-edge: the same edge from the other side, fixed(…), or NONE
  public final int[] out; // by vertex: a half-edge that leaves it
  public final byte[] wrong; // by vertex: 1 if its degree has not the parity wished
  public final int[] weight; // by vertex: the cost of it being wrong; 0 if any parity will do
  private final int[] free; // the vertices of which nothing is wished, in order
  final int[] site; // by vertex: its number among the sites
  final Hops hops; // distances in a region; null for sites
  private final boolean plain; // determinants in floating point have no rounding error

  /**
   * The triangulation, which has at least one triangle, with what is wished of it.
   *
   * @param unit the weight of a vertex of which something is wished
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public SearchMesh(Triangulation start, ParityGoal goal, int unit, Progress progress) {
    site = HilbertOrder.of(start.points(), progress);
    int n = site.length;
    x = new double[n];
    y = new double[n];
    out = new int[n];
    wrong = new byte[n];
    weight = new int[n];
    int[] place = new int[n];
    for (int v = 0; v < n; v++) {
      Progress.check(progress, v);
      place[site[v]] = v;
      x[v] = start.points().x(site[v]);
      y[v] = start.points().y(site[v]);
      ParityGoal.Wish wish = goal.wish(site[v]);
      weight[v] = wish == ParityGoal.Wish.ANY ? 0 : unit;
      wrong[v] = (byte) ((start.degree(site[v]) + (wish == ParityGoal.Wish.ODD ? 1 : 0)) & 1);
    }
    free = IntStream.range(0, n).filter(v -> weight[v] == 0).toArray();
    plain = ExactGrid.holds(x, y);
    progress.checkCancelled();
    corner = new int[4 * start.triangleCount()];
    twin = new int[corner.length];
    readTriangles(start, place, progress);
    hops = start.domain() == Domain.REGION ? new Hops(n, this::collectNeighbours) : null;
  }

  private void readTriangles(Triangulation start, int[] place, Progress progress) {
    Dcel dcel = start.dcel();
    int[] slot = new int[2 * dcel.edgeBound()];
    int e = 0;
    for (int f = 1; f < dcel.faceBound(); f++, e += 4) {
      Progress.check(progress, f);
      int h = dcel.faceEdge(f);
      for (int i = 0; i < 3; i++) {
        slot[h] = e + i;
        corner[e + i] = place[dcel.origin(h)];
        out[corner[e + i]] = e + i;
        h = dcel.next(h);
      }
    }
    for (int h = 0; h < slot.length; h++) {
      Progress.check(progress, h);
      if (dcel.face(h) != Dcel.OUTER) {
        twin[slot[h]] = dcel.face(h ^ 1) == Dcel.OUTER ? NONE : slot[h ^ 1];
      }
    }
    for (int h = 0; start.domain() == Domain.REGION && h < slot.length; h++) {
      if (start.kind(h >> 1) == EdgeKind.FIXED) {
        twin[slot[h]] = fixed(slot[h ^ 1]);
      }
    }
  }

  /** In place of a half-edge: that one, beyond a fixed edge. Its own inverse. */
  private static int fixed(int e) {
    return NONE - 1 - e;
  }

  /** The half-edge beyond e, also if the edge is fixed; NONE at the boundary. */
  int across(int e) {
    return twin[e] < NONE ? fixed(twin[e]) : twin[e];
  }

  /** The number of vertices. */
  public int size() {
    return x.length;
  }

  /** The half-edge after e around its triangle. */
  public static int next(int e) {
    return (e & ~3) | ((0b001001 >> ((e & 3) << 1)) & 3);
  }

  /** The half-edge before e around its triangle. */
  public static int prev(int e) {
    return (e & ~3) | ((0b010010 >> ((e & 3) << 1)) & 3);
  }

  /** Whether v counts as unmet. */
  public boolean isUnmet(int v) {
    return wrong[v] != 0 && weight[v] != 0;
  }

  /** How many vertices are unmet, in linear time. */
  public int unmet() {
    int count = 0;
    for (int v = 0; v < wrong.length; v++) {
      count += isUnmet(v) ? 1 : 0;
    }
    return count;
  }

  /** A half-edge from v, a few random steps around it. */
  public int halfEdgeAt(int v, SeededRandom random) {
    int e = out[v];
    boolean clockwise = false;
    for (int r = random.nextInt(TURNS); r > 0; r--) {
      int turned = clockwise ? twin[e] : twin[prev(e)];
      if (turned >= 0) {
        e = clockwise ? next(turned) : turned;
      } else if (turned == NONE) {
        clockwise = !clockwise;
      } else {
        e = clockwise ? next(fixed(turned)) : fixed(turned);
      }
    }
    return e;
  }

  /** Makes a list of half-edges, one for each edge at v. */
  public void collectEdges(int v, VertexList edges) {
    edges.clear();
    int first = clockwiseMost(v);
    int e = first;
    int last;
    do {
      edges.add(e);
      last = prev(e);
      e = across(last);
    } while (e != NONE && e != first);
    if (e == NONE) {
      edges.add(last);
    }
  }

  private void collectNeighbours(int v, VertexList neighbours) {
    collectEdges(v, neighbours);
    for (int i = 0; i < neighbours.size(); i++) {
      int e = neighbours.get(i);
      neighbours.set(i, corner[e] == v ? corner[next(e)] : corner[e]);
    }
  }

  /** A half-edge from v: on the hull the one with no triangle on its right. */
  private int clockwiseMost(int v) {
    int e = out[v];
    while (twin[e] != NONE && next(across(e)) != out[v]) {
      e = next(across(e));
    }
    return e;
  }

  /**
   * A vertex from lo to hi − 1, other than v, of which nothing is wished: the nearer of the two
   * that come before and after v along the curve, or NONE.
   */
  int freeVertexNear(int v, int lo, int hi) {
    if (free.length == 0) {
      return NONE;
    }
    int place = Arrays.binarySearch(free, v);
    int after = place < 0 ? -place - 1 : place + 1;
    int before = place < 0 ? after - 1 : place - 1;
    int u = before >= 0 && free[before] >= lo ? free[before] : NONE;
    int w = after < free.length && free[after] < hi ? free[after] : NONE;
    if (u == NONE || w == NONE) {
      return Math.max(u, w);
    }
    return squaredDistance(u, v) < squaredDistance(w, v) ? u : w;
  }

  /** Whether the turn from a by b to c is strictly to the left. */
  public boolean isLeftTurn(double ax, double ay, double bx, double by, double cx, double cy) {
    if (plain) {
      return (ax - cx) * (by - cy) > (ay - cy) * (bx - cx);
    }
    return Predicates.orient(ax, ay, bx, by, cx, cy) > 0;
  }

  /**
   * Turns the edge of e, which is not fixed, in the quadrilateral of its two triangles, which is
   * strictly convex.
   *
   * <pre>
   *       c                c
   *     ↗   ↖            ↗ ↑ ↖
   *   a ── e → b   →   a   e   b
   *     ↘   ↗            ↘ │ ↗
   *       d                d
   * </pre>
   */
  public void flip(int e) {
    int t = twin[e];
    int bc = next(e);
    int ca = prev(e);
    int ad = next(t);
    int db = prev(t);
    int a = corner[e];
    int b = corner[t];
    int c = corner[ca];
    int d = corner[db];
    int beyondAd = twin[ad];
    int beyondBc = twin[bc];
    // e's triangle becomes d c a, its twin's c d b.
    corner[e] = d;
    corner[bc] = c;
    corner[ca] = a;
    corner[t] = c;
    corner[ad] = d;
    corner[db] = b;
    link(bc, twin[ca]);
    link(ca, beyondAd);
    link(ad, twin[db]);
    link(db, beyondBc);
    out[a] = ca;
    out[b] = db;
    out[c] = t;
    out[d] = e;
    wrong[a] ^= 1;
    wrong[b] ^= 1;
    wrong[c] ^= 1;
    wrong[d] ^= 1;
  }

  /** Makes two half-edges twins; the second may be NONE, or stand for one beyond a fixed edge. */
  public void link(int e, int other) {
    twin[e] = other;
    if (other >= 0) {
      twin[other] = e;
    } else if (other != NONE) {
      twin[fixed(other)] = fixed(e);
    }
  }

  /**
   * What grows with the distance from v to a target: in a region that to which distances were
   * measured last.
   */
  double away(int v, int target) {
    return hops == null ? squaredDistance(v, target) : hops.distance(v);
  }

  /** The square of the distance between two vertices. */
  public double squaredDistance(int u, int v) {
    double dx = x[u] - x[v];
    double dy = y[u] - y[v];
    return dx * dx + dy * dy;
  }
}
