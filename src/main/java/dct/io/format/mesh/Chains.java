package dct.io.format.mesh;

import dct.core.geometry.Points;
import dct.io.format.PointColumns;
import dct.io.format.Shape;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Segments between numbered vertices, chained to rings where each vertex has two of them. */
final class Chains {
  private static final int NONE = -1;

  private final int[] one; // a neighbour of each vertex
  private final int[] other; // its other neighbour
  private final boolean[] many; // vertices with more than two
  private int segments;
  private int onRings;

  Chains(int vertices) {
    one = new int[vertices];
    other = new int[vertices];
    many = new boolean[vertices];
    Arrays.fill(one, NONE);
    Arrays.fill(other, NONE);
  }

  void add(int u, int v) {
    segments++;
    link(u, v);
    link(v, u);
  }

  private void link(int u, int v) {
    if (one[u] == NONE) {
      one[u] = v;
    } else if (other[u] == NONE) {
      other[u] = v;
    } else {
      many[u] = true;
    }
  }

  /**
   * The rings in the order of their first vertices, holes last. The smallest ring round a hole's
   * point is a hole.
   */
  List<Shape> rings(Points points, int[] lines, Points holes) {
    List<PointColumns> rings = new ArrayList<>();
    boolean[] seen = new boolean[one.length];
    for (int v = 0; v < one.length; v++) {
      PointColumns ring = ring(v, seen, points, lines);
      if (ring.size() > 2) {
        rings.add(ring);
        onRings += ring.size();
      }
    }
    Set<PointColumns> inner = new HashSet<>();
    for (int h = 0; h < holes.size(); h++) {
      double x = holes.x(h);
      double y = holes.y(h);
      rings.stream()
          .filter(ring -> isInside(ring.points(), x, y))
          .min(Comparator.comparingDouble(ring -> area(ring.points())))
          .ifPresent(inner::add);
    }
    List<Shape> shapes = new ArrayList<>();
    rings.stream()
        .filter(ring -> !inner.contains(ring))
        .forEach(ring -> shapes.add(Shape.of(Shape.Kind.RING, "", ring)));
    rings.stream()
        .filter(inner::contains)
        .forEach(ring -> shapes.add(Shape.of(Shape.Kind.HOLE, "", ring)));
    return shapes;
  }

  /** The ring through a vertex that has not been seen; without vertices if there is none. */
  private PointColumns ring(int start, boolean[] seen, Points points, int[] lines) {
    PointColumns ring = new PointColumns();
    int before = NONE;
    int v = start;
    while (!seen[v] && !many[v] && other[v] != NONE) {
      seen[v] = true;
      ring.add(points.x(v), points.y(v), lines[v]);
      int next = one[v] == before && before != NONE ? other[v] : one[v];
      before = v;
      v = next;
    }
    return v == start && ring.size() > 0 ? ring : new PointColumns();
  }

  /** Whether a point lies inside a ring, by the parity of the crossings of a ray. */
  private static boolean isInside(Points ring, double x, double y) {
    boolean inside = false;
    for (int v = 0, u = ring.size() - 1; v < ring.size(); u = v++) {
      boolean spans = (ring.y(v) > y) != (ring.y(u) > y);
      double slope = (ring.x(u) - ring.x(v)) / (ring.y(u) - ring.y(v));
      inside ^= spans && x < ring.x(v) + slope * (y - ring.y(v));
    }
    return inside;
  }

  private static double area(Points ring) {
    double sum = 0;
    for (int v = 0, u = ring.size() - 1; v < ring.size(); u = v++) {
      sum += ring.x(u) * ring.y(v) - ring.x(v) * ring.y(u);
    }
    return Math.abs(sum);
  }

  int verticesApart() {
    return one.length - onRings;
  }

  int looseSegments() {
    return segments - onRings;
  }
}
