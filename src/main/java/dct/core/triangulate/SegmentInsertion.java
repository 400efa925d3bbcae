package dct.core.triangulate;

import dct.core.Progress;
import dct.core.dcel.HalfEdges;
import dct.core.geometry.Predicates;
import java.util.Arrays;

/**
 * Makes a segment between two vertices an edge of a constrained Delaunay triangulation, which stays
 * one (Anglada 1997): the edges that cross it are taken out, and what is left on either side of it
 * is filled anew. Works on the links between the places of a {@link KdOrder}, since near vertices
 * are then near in memory.
 *
 * <p>The edges that cross the segment leave a <em>cavity</em> on either side: the segment is its
 * base, and its other vertices, the chain, are ends of edges that were crossed. Where edges were
 * crossed on both sides of an edge, that edge hangs into the cavity, and the chain runs along it
 * twice. So there may be several corners of the chain at one vertex, but each corner <em>is
 * seen</em> from the base: along an edge that was crossed. The triangle on the base ab has the apex
 * c of the chain in whose circle with a and b there is no other vertex of the chain:
 *
 * <ul>
 *   <li>The triangle is free. No vertex of the chain is inside it, and none is on the line of the
 *       base or beyond it. So an edge of the chain that met its inside would cut it into a part
 *       with the base and one with c, and c would not be seen.
 *   <li>There is one corner at c. Between two of them the chain runs round what hangs from c,
 *       between the lines along which both are seen; so that is inside the triangle, and in the
 *       circle.
 *   <li>The rest is again a cavity on ac and one on cb: what is seen from ab through the triangle
 *       is seen from that side through which its line leaves the triangle, and is beyond it.
 * </ul>
 *
 * <p>No orientation is tested for that; of several apexes on the same circle the first along the
 * chain is taken. A cavity with k vertices takes O(k²) time at worst, and O(k log k) where apexes
 * are in the middle of chains more often than near their ends. It is read once into arrays, in
 * which each part of it is a range.
 */
final class SegmentInsertion {
  private final HalfEdges links;
  private final int[] next;
  private final int[] prev;
  private final int[] origin;
  private final double[] x;
  private final double[] y;
  private final int[] out; // by place: a half-edge that leaves it
  private final HalfEdgeList free = new HalfEdgeList(); // the edges that were crossed
  private final HalfEdgeList waiting = new HalfEdgeList(); // cavities: a base, two chain places

  // The cavity being filled, copied, since it is read often: from the end of its base to the start.
  private int[] chain = new int[32]; // the half-edge that leaves the vertex along the chain
  private double[] chainX = new double[32];
  private double[] chainY = new double[32];

  private final Progress progress;
  private long steps; // edges crossed and circles looked at
  private long due; // so many before it is asked again whether to stop

  /** Every place must have an edge. */
  SegmentInsertion(HalfEdges links, KdOrder order, Progress progress) {
    this.progress = progress;
    this.links = links;
    next = links.next();
    prev = links.prev();
    origin = links.origin();
    x = order.x;
    y = order.y;
    out = new int[x.length];
    for (int e = 0; e < origin.length; e++) {
      if (next[e] != HalfEdges.NONE) {
        out[origin[e]] = e;
      }
    }
  }

  /** A half-edge that leaves v. */
  int out(int v) {
    return out[v];
  }

  /** How many edges were crossed and circles looked at so far. */
  long steps() {
    return steps;
  }

  /** The next half-edge counter-clockwise around the origin of e. */
  int rotate(int e) {
    return prev[e] ^ 1;
  }

  /** Takes an edge out, whose ends have others. */
  void remove(int e) {
    out[origin[e]] = next[e ^ 1];
    out[origin[e ^ 1]] = next[e];
    links.remove(e);
  }

  /** Whether u and v have an edge; in as many steps as the one with fewer edges has. */
  boolean has(int u, int v) {
    int atU = out[u];
    int atV = out[v];
    do {
      if (origin[atU ^ 1] == v || origin[atV ^ 1] == u) {
        return true;
      }
      atU = rotate(atU);
      atV = rotate(atV);
    } while (atU != out[u] && atV != out[v]);
    return false;
  }

  /**
   * Makes uv an edge, which crosses no edge that must stay, and has no vertex inside.
   *
   * <p>It starts at the end where the triangle that it leaves through is found in fewer steps.
   */
  void insert(int u, int v) {
    if (has(u, v)) {
      return;
    }
    int atU = out[u];
    int atV = out[v];
    while (true) {
      if (leavesTo(atU, v)) {
        cross(atU, v);
        return;
      }
      if (leavesTo(atV, u)) {
        cross(atV, u);
        return;
      }
      atU = rotate(atU);
      atV = rotate(atV);
    }
  }

  /** Whether the segment from the origin of e to v starts between e and the edge after it. */
  private boolean leavesTo(int e, int v) {
    int u = origin[e];
    return orient(u, origin[e ^ 1], v) > 0 && orient(u, origin[prev[e]], v) < 0;
  }

  /** Makes an edge from the origin of {@code start} to v, through the triangle of start. */
  private void cross(int start, int v) {
    int u = origin[start];
    int crossed = next[start]; // from the right of the segment to its left
    int apexCorner;
    while (true) {
      int right = next[crossed ^ 1]; // from the right end of what is crossed to the next apex
      apexCorner = next[right];
      remove(crossed);
      free.add(crossed);
      int apex = origin[apexCorner];
      if (apex == v) {
        break;
      }
      crossed = orient(u, v, apex) > 0 ? right : apexCorner;
    }
    int segment = links.connect(free.pop(), start, apexCorner);
    fillCavity(segment);
    fillCavity(segment ^ 1);
  }

  /** Fills what is on the left of a base. */
  private void fillCavity(int base) {
    int last = readChain(base);
    push(base, 0, last);
    while (waiting.size() > 0) {
      int to = waiting.pop();
      int from = waiting.pop();
      fill(waiting.pop(), from, to);
    }
  }

  /** Reads the chain from the end of the base to its start; returns the number of its edges. */
  private int readChain(int base) {
    int k = 0;
    for (int e = next[base]; ; e = next[e]) {
      if (k == chain.length) {
        chain = Arrays.copyOf(chain, 2 * k);
        chainX = Arrays.copyOf(chainX, 2 * k);
        chainY = Arrays.copyOf(chainY, 2 * k);
      }
      chain[k] = e;
      chainX[k] = x[origin[e]];
      chainY[k] = y[origin[e]];
      if (e == base) {
        return k;
      }
      k++;
    }
  }

  private void push(int base, int from, int to) {
    if (to - from > 1) {
      waiting.add(base);
      waiting.add(from);
      waiting.add(to);
    }
  }

  /**
   * Puts a triangle on the left of a base, which runs from one vertex of the chain back to an
   * earlier one.
   */
  private void fill(int base, int from, int to) {
    int apex = apex(from, to);
    int side = chain[apex]; // from the apex to the start of the base
    if (apex + 1 < to) {
      side = links.connect(free.pop(), side, base);
      push(side ^ 1, apex, to);
    }
    if (from + 1 < apex) {
      push(links.connect(free.pop(), chain[from], side) ^ 1, from, apex);
    }
  }

  /** The first vertex between these two of the chain with an empty circle. */
  private int apex(int from, int to) {
    steps += to - from;
    if (steps >= due) {
      due = steps + Progress.STRIDE;
      progress.checkCancelled();
    }
    double ax = chainX[to];
    double ay = chainY[to];
    double bx = chainX[from];
    double by = chainY[from];
    int best = from + 1;
    double cx = chainX[best];
    double cy = chainY[best];
    for (int k = from + 2; k < to; k++) {
      if (Predicates.inCircle(ax, ay, bx, by, cx, cy, chainX[k], chainY[k]) > 0) {
        best = k;
        cx = chainX[k];
        cy = chainY[k];
      }
    }
    return best;
  }

  private int orient(int a, int b, int c) {
    return Predicates.orient(x[a], y[a], x[b], y[b], x[c], y[c]);
  }
}
