package dct.experiment.generate;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.HilbertOrder;
import dct.core.geometry.Points;
import java.util.ArrayDeque;

/**
 * Random points made a simple polygon by 2-opt moves: as long as two edges ab and cd of the closed
 * tour meet, they are replaced by ac and bd (J. van Leeuwen and A. Schoone, "Untangling a traveling
 * salesman tour in the plane", 1981; as a generator in T. Auer and M. Held, "Heuristics for the
 * generation of random polygons", 1996).
 *
 * <p>The tour begins in random order, or along a Hilbert curve, which leaves little to do and gives
 * long winding polygons of short edges.
 *
 * <p><b>It ends.</b> If ab and cd meet in a point and not all four lie on one line, then the move
 * makes the tour shorter by the triangle inequality. If they do, it is made only if it makes the
 * tour shorter, or keeps its length and makes the sum of the squared lengths smaller; on a line
 * both are compared exactly. So no tour comes twice. <b>The end is simple.</b> Edges on one line
 * that overlap in the same direction, or of which one contains the other, allow a move. If two
 * overlap otherwise, then the edge that follows in either direction meets one of the two: it leaves
 * the line, allows a move, or reaches further along the line, where the same holds again; and both
 * ends of the line cannot be reached without leaving it unless all points lie on it. Hence if no
 * move is left, no two edges meet.
 *
 * <p>Order of moves: edges wait in a queue; one is taken out and moved against the first edge that
 * it meets, and both new edges join the queue. A grid of cells finds what an edge may meet; the
 * shorter part of the tour is turned round. About n log n moves.
 */
final class Untangling {
  private static final int PATIENCE = 1 << 10;

  private final Places p;
  private final int n;
  private final int[] ring; // vertices in the order of the tour
  private final int[] position; // of each vertex in the ring
  private final int[] end; // the ends of edge e are end[2 e] and end[2 e + 1], in no order
  private final EdgeCells cells;
  private final ArrayDeque<Integer> waiting = new ArrayDeque<>();
  private final boolean[] waits;

  private Untangling(Places places, int[] tour) {
    this.p = places;
    n = places.size();
    ring = tour;
    position = new int[n];
    end = new int[2 * n];
    cells = new EdgeCells(places);
    waits = new boolean[n];
    for (int k = 0; k < n; k++) {
      position[ring[k]] = k;
      set(k, ring[k], ring[(k + 1) % n]);
    }
  }

  /** A counter-clockwise polygon of n vertices, from a random tour. */
  static Points fromRandomTour(int n, Area area, SeededRandom random, Progress progress) {
    Places places = Places.spread(n, area.grid(), random);
    int[] tour = new int[n];
    for (int i = 0; i < n; i++) {
      tour[i] = i;
    }
    return places.points(new Untangling(places, tour).run(progress));
  }

  /** A counter-clockwise polygon of n vertices, from the tour along a Hilbert curve. */
  static Points fromHilbertTour(int n, Area area, SeededRandom random, Progress progress) {
    Places places = Places.spread(n, area.grid(), random);
    int[] tour = HilbertOrder.of(places.points(), progress);
    return places.points(new Untangling(places, tour).run(progress));
  }

  private int[] run(Progress progress) {
    boolean moved = true;
    while (moved) { // until a round over all edges finds nothing to do
      moved = round(progress);
    }
    return isClockwise() ? reversed() : ring;
  }

  private boolean round(Progress progress) {
    boolean moved = false;
    for (int e = 0; e < n; e++) {
      await(e);
    }
    for (int steps = 0; !waiting.isEmpty(); steps++) {
      if (steps % PATIENCE == 0) {
        progress.checkCancelled();
      }
      int e = waiting.remove();
      waits[e] = false;
      int f = cells.find(end[2 * e], end[2 * e + 1], candidate -> isMove(e, candidate));
      if (f != EdgeCells.NONE) {
        move(e, f);
        moved = true;
      }
    }
    return moved;
  }

  private void await(int e) {
    if (!waits[e]) {
      waits[e] = true;
      waiting.add(e);
    }
  }

  private void set(int e, int a, int b) {
    end[2 * e] = a;
    end[2 * e + 1] = b;
    cells.add(e, a, b);
  }

  /** The end of an edge that comes first on the tour. */
  private int tail(int e) {
    int a = end[2 * e];
    int b = end[2 * e + 1];
    int after = position[a] + 1 == n ? 0 : position[a] + 1;
    return ring[after] == b ? a : b;
  }

  private int head(int e, int tail) {
    return end[2 * e] == tail ? end[2 * e + 1] : end[2 * e];
  }

  /** Whether two edges meet and are not neighbours, and the move brings the end nearer. */
  private boolean isMove(int e, int f) {
    int a = end[2 * e];
    int b = end[2 * e + 1];
    int c = end[2 * f];
    int d = end[2 * f + 1];
    if (a == c || a == d || b == c || b == d || areApart(a, b, c, d)) {
      return false;
    }
    long abc = Long.signum(p.turn(a, b, c));
    long abd = Long.signum(p.turn(a, b, d));
    if (abc * abd > 0) {
      return false;
    }
    if (abc == 0 && abd == 0) {
      return isMoveOnLine(e, f);
    }
    return Long.signum(p.turn(c, d, a)) * Long.signum(p.turn(c, d, b)) <= 0;
  }

  private boolean areApart(int a, int b, int c, int d) {
    return Math.max(p.x(a), p.x(b)) < Math.min(p.x(c), p.x(d))
        || Math.max(p.x(c), p.x(d)) < Math.min(p.x(a), p.x(b))
        || Math.max(p.y(a), p.y(b)) < Math.min(p.y(c), p.y(d))
        || Math.max(p.y(c), p.y(d)) < Math.min(p.y(a), p.y(b));
  }

  /**
   * For two edges on one line that overlap; lengths are measured along x, or y if it is upright.
   */
  private boolean isMoveOnLine(int e, int f) {
    int tail = tail(e);
    boolean upright = p.x(end[2 * e]) == p.x(end[2 * e + 1]);
    long a = along(upright, tail);
    long b = along(upright, head(e, tail));
    tail = tail(f);
    long c = along(upright, tail);
    long d = along(upright, head(f, tail));
    long before = Math.abs(a - b) + Math.abs(c - d);
    long after = Math.abs(a - c) + Math.abs(b - d);
    return after < before || (after == before && squares(a, c, b, d) < squares(a, b, c, d));
  }

  private int along(boolean upright, int v) {
    return upright ? p.y(v) : p.x(v);
  }

  private static long squares(long a, long b, long c, long d) {
    return (a - b) * (a - b) + (c - d) * (c - d);
  }

  /** Replaces the edges ab and cd by ac and bd. */
  private void move(int e, int f) {
    int a = tail(e);
    int b = head(e, a);
    int c = tail(f);
    int d = head(f, c);
    cells.remove(e, a, b);
    cells.remove(f, c, d);
    reverse(position[b], position[c]);
    set(e, a, c);
    set(f, b, d);
    await(e);
    await(f);
  }

  /** Turns the tour from one position to another round, or, which is the same, all the rest. */
  private void reverse(int from, int to) {
    int length = Math.floorMod(to - from, n) + 1;
    boolean inner = 2 * length <= n;
    int i = inner ? from : (to + 1) % n;
    int j = inner ? to : (from + n - 1) % n;
    for (int swaps = Math.min(length, n - length) / 2; swaps > 0; swaps--) {
      int kept = ring[i];
      put(i, ring[j]);
      put(j, kept);
      i = i + 1 == n ? 0 : i + 1;
      j = j == 0 ? n - 1 : j - 1;
    }
  }

  private void put(int k, int v) {
    ring[k] = v;
    position[v] = k;
  }

  private boolean isClockwise() {
    int lowest = 0;
    for (int k = 1; k < n; k++) {
      int dy = p.y(ring[k]) - p.y(ring[lowest]);
      if (dy < 0 || (dy == 0 && p.x(ring[k]) < p.x(ring[lowest]))) {
        lowest = k;
      }
    }
    return p.turn(ring[(lowest + n - 1) % n], ring[lowest], ring[(lowest + 1) % n]) < 0;
  }

  private int[] reversed() {
    for (int i = 0, j = n - 1; i < j; i++, j--) {
      int kept = ring[i];
      ring[i] = ring[j];
      ring[j] = kept;
    }
    return ring;
  }
}
