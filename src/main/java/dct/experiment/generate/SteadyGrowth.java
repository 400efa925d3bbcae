package dct.experiment.generate;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.Points;
import java.util.Arrays;
import java.util.Collections;

/**
 * A random polygon that grows point by point (Steady Growth of T. Auer and M. Held, "Heuristics for
 * the generation of random polygons", 1996).
 *
 * <p>It begins with a triangle. Each step takes a point outside the convex hull of the polygon such
 * that no remaining point falls into the new hull, and puts it in place of a random edge of which
 * it sees every point. Here the points come by their distance from a random place: all earlier ones
 * lie in a disc, which is convex, and the next one outside. A random edge that faces the point is
 * the first candidate; if another one is in its way, that is the next candidate. Seen from outside
 * the hull, edges have an order from front to back, so that a free one is found. O(n²) time.
 */
final class SteadyGrowth {
  private static final int NONE = -1;

  private final Places p;
  private final SeededRandom random;
  private final int[] next; // the vertex after each on the polygon
  private final int[] vertices; // of the polygon, in the order in which they came
  private int size;

  private SteadyGrowth(Places places, int[] order, SeededRandom random) {
    this.p = places;
    this.random = random;
    this.vertices = order;
    next = new int[places.size()];
  }

  /** A counter-clockwise polygon of n vertices. */
  static Points polygon(int n, Area area, SeededRandom random, Progress progress) {
    Places places = Places.spread(n, area.grid(), random);
    int[] order = byDistance(places, random);
    SteadyGrowth growth = new SteadyGrowth(places, order, random);
    growth.begin();
    while (growth.size < n) {
      progress.checkCancelled();
      growth.add(order[growth.size]);
    }
    return places.points(growth.ring());
  }

  /** The points by their distance from a random one. */
  private static int[] byDistance(Places p, SeededRandom random) {
    int centre = random.nextInt(p.size());
    Integer[] order = new Integer[p.size()];
    long[] distance = new long[p.size()];
    for (int i = 0; i < order.length; i++) {
      order[i] = i;
      long dx = p.dx(centre, i);
      long dy = p.dy(centre, i);
      distance[i] = dx * dx + dy * dy;
    }
    Arrays.sort(order, (i, j) -> Long.compare(distance[i], distance[j]));
    return Arrays.stream(order).mapToInt(i -> i).toArray();
  }

  /** The first point that is not on one line with those before it makes a triangle with them. */
  private void begin() {
    int apex = 2;
    while (p.turn(vertices[0], vertices[1], vertices[apex]) == 0) {
      apex++;
    }
    size = apex + 1;
    int[] line = alongLine(Arrays.copyOf(vertices, apex), vertices[apex]);
    for (int k = 0; k < apex; k++) {
      next[line[k]] = k + 1 < apex ? line[k + 1] : vertices[apex];
    }
    next[vertices[apex]] = line[0];
  }

  /** Points on one line, from end to end so that the apex lies on their left. */
  private int[] alongLine(int[] points, int apex) {
    Integer[] order = Arrays.stream(points).boxed().toArray(Integer[]::new);
    Arrays.sort(
        order,
        (i, j) -> {
          int byX = Integer.compare(p.x(i), p.x(j));
          return byX != 0 ? byX : Integer.compare(p.y(i), p.y(j));
        });
    if (p.turn(order[0], order[1], apex) < 0) {
      Collections.reverse(Arrays.asList(order));
    }
    return Arrays.stream(order).mapToInt(i -> i).toArray();
  }

  private void add(int s) {
    int a = facing(s);
    for (int front = inFront(a, s); front != NONE; front = inFront(a, s)) {
      a = front;
    }
    next[s] = next[a];
    next[a] = s;
    size++;
  }

  /** A random vertex such that s lies on the outer side of the edge that follows it. */
  private int facing(int s) {
    int start = random.nextInt(size);
    for (int k = start; ; k = k + 1 == size ? 0 : k + 1) {
      if (faces(vertices[k], s)) {
        return vertices[k];
      }
    }
  }

  private boolean faces(int a, int s) {
    return p.turn(a, next[a], s) < 0;
  }

  /** An edge that hides a point of the edge from a, given by its first vertex, or none. */
  private int inFront(int a, int s) {
    int u = faces(a, s) ? next[a] : a; // so that s lies on the left of uv
    int v = faces(a, s) ? a : next[a];
    for (int k = size - 1; k >= 0; k--) { // the latest are the outermost
      int c = vertices[k];
      if (c != a && hides(c, next[c], u, v, s)) {
        return c;
      }
    }
    return NONE;
  }

  /**
   * Whether the edge cd enters the triangle uvs. Where cd points at s, the edge that follows at its
   * nearer end does so too, and counts.
   */
  private boolean hides(int c, int d, int u, int v, int s) {
    if (p.turn(u, v, c) <= 0 && p.turn(u, v, d) <= 0) {
      return false;
    }
    long cds = p.turn(c, d, s);
    if (cds == 0) {
      return false;
    }
    if (c == u || d == u) {
      return p.turn(u, c == u ? d : c, s) > 0;
    }
    if (c == v || d == v) {
      return p.turn(v, s, c == v ? d : c) > 0;
    }
    return !(p.turn(v, s, c) < 0 && p.turn(v, s, d) < 0)
        && !(p.turn(s, u, c) < 0 && p.turn(s, u, d) < 0)
        && !(onSide(cds, p.turn(c, d, u)) && onSide(cds, p.turn(c, d, v)));
  }

  private static boolean onSide(long side, long turn) {
    return side > 0 ? turn > 0 : turn < 0;
  }

  private int[] ring() {
    int[] ring = new int[size];
    int v = vertices[0];
    for (int k = 0; k < size; k++) {
      ring[k] = v;
      v = next[v];
    }
    return ring;
  }
}
