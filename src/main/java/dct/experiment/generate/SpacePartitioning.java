package dct.experiment.generate;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.Points;

/**
 * A random polygon through random points by Space Partitioning (T. Auer and M. Held, "Heuristics
 * for the generation of random polygons", 1996).
 *
 * <p>The line through two random points splits the others in two; either side becomes a chain from
 * one of the two to the other. For a chain, a random line through a random point of it that has the
 * chain's ends on different sides splits the others; they become a chain from one end to that
 * point, and one from there to the other end. The convex hulls of the two parts have nothing but
 * that point in common, hence the polygon is simple.
 *
 * <p>Points on the dividing line are taken apart by turning it a little about that point: those
 * before it fall on one side, those behind it on the other. O(n log n) expected time.
 */
final class SpacePartitioning {
  private static final int WEIGHTS = 32;

  private final Places p;
  private final SeededRandom random;
  private final int[] ring; // the polygon; each chain's points are in its range

  // The dividing line: the place through which it runs, and its direction.
  private int pivot;
  private long dx;
  private long dy;

  private SpacePartitioning(Places places, SeededRandom random) {
    this.p = places;
    this.random = random;
    ring = new int[places.size()];
    for (int i = 0; i < ring.length; i++) {
      ring[i] = i;
    }
  }

  /** A counter-clockwise polygon of n vertices. */
  static Points polygon(int n, Area area, SeededRandom random, Progress progress) {
    Places places = Places.spread(n, area.grid(), random);
    return places.points(new SpacePartitioning(places, random).run());
  }

  private int[] run() {
    int n = ring.length;
    int first = random.nextInt(n);
    int last = (first + 1 + random.nextInt(n - 1)) % n;
    int from = furthest(first, last);
    int to = furthest(last, from);
    int middle = split(from, to);
    chain(from, 1, middle, to);
    chain(to, middle + 1, n, from);
    return ring;
  }

  /** Of all points on the line from {@code v} through {@code away}: the last on v's side. */
  private int furthest(int v, int away) {
    int found = v;
    for (int i = 0; i < p.size(); i++) {
      if (p.turn(v, away, i) == 0 && p.isBetween(found, i, away)) {
        found = i;
      }
    }
    return found;
  }

  /**
   * Puts {@code from} first, then all points right of the line to {@code to}, then that, then those
   * on its left; returns its place. Points between the two go to a side that is empty without them,
   * so that the other side's chain does not touch them.
   */
  private int split(int from, int to) {
    boolean anyRight = false;
    for (int i = 0; i < p.size(); i++) {
      anyRight |= p.turn(from, to, i) < 0;
    }
    int low = 1;
    int high = p.size() - 1;
    ring[0] = from;
    for (int i = 0; i < p.size(); i++) {
      if (i != from && i != to) {
        long side = p.turn(from, to, i);
        boolean right = side < 0 || (side == 0 && !anyRight);
        ring[right ? low++ : high--] = i;
      }
    }
    ring[low] = to;
    return low;
  }

  /** Orders the points at ring positions low … high − 1 to a chain between these ends. */
  private void chain(int from, int low, int high, int to) {
    int start = from;
    int a = low;
    int b = high;
    int end = to;
    while (b - a > 1) {
      int middle = divide(start, a, b, end);
      if (middle - a < b - middle) { // the shorter part by recursion, so that it is not deep
        chain(start, a, middle, ring[middle]);
        start = ring[middle];
        a = middle + 1;
      } else {
        chain(ring[middle], middle + 1, b, end);
        end = ring[middle];
        b = middle;
      }
    }
  }

  /** Draws a point and a line, and sorts the others by side; returns the point's position. */
  private int divide(int from, int low, int high, int to) {
    int chosen = low + random.nextInt(high - low);
    pivot = ring[chosen];
    ring[chosen] = ring[low];
    draw(from, to);
    boolean fromIsLeft = isLeft(from);
    int a = low + 1;
    int b = high - 1;
    while (a <= b) {
      if (isLeft(ring[a]) == fromIsLeft) {
        a++;
      } else {
        int kept = ring[a];
        ring[a] = ring[b];
        ring[b--] = kept;
      }
    }
    ring[low] = ring[b];
    ring[b] = pivot;
    return b;
  }

  /** A line through the pivot and a random one of the points that divide the segment evenly. */
  private void draw(int from, int to) {
    long ux = p.dx(pivot, from);
    long uy = p.dy(pivot, from);
    long wx = p.dx(pivot, to);
    long wy = p.dy(pivot, to);
    if (p.turn(pivot, from, to) == 0) { // then the pivot lies between the two
      dx = -uy;
      dy = ux;
    } else {
      int weight = 1 + random.nextInt(WEIGHTS - 1);
      dx = weight * ux + (WEIGHTS - weight) * wx;
      dy = weight * uy + (WEIGHTS - weight) * wy;
    }
  }

  /** Whether a point lies on the left of the line, or on its hind half. */
  private boolean isLeft(int v) {
    long vx = p.dx(pivot, v);
    long vy = p.dy(pivot, v);
    long side = dx * vy - dy * vx;
    return side > 0 || (side == 0 && dx * vx + dy * vy < 0);
  }
}
