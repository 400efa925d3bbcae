package dct.core.geometry;

import dct.core.Progress;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * What can be made of a closed chain that meets itself without crossing itself: at a vertex that it
 * comes to again, along an edge that it goes to and fro, as where a hole is tied to its outline, or
 * with a vertex on an edge.
 *
 * <p>Takes any finite points, in boundary order. Neither way is right for every purpose: {@link
 * #rings} keeps every place and gives several rings, {@link #parted} keeps the one ring and moves
 * vertices a little. In O(n) and O(n log n) expected time for each of few attempts.
 */
public final class Touching {
  private static final double LEAST = 0x1p-36; // of the size, that a vertex is moved
  private static final double MOST = 0x1p-12;
  private static final double STEP = 8;
  private static final double SHARPEST = 0.25; // 1 + the cosine between both normals

  private final Points points;
  private final Progress progress;
  private final int n;
  private final double inside; // 1 if the inside is on the left, else -1

  /** The vertices where the chain meets itself, with the ends of the edges that it meets there. */
  private final Map<Integer, Set<Integer>> met = new TreeMap<>();

  private Touching(Points points, Progress progress) {
    this.points = points;
    this.progress = progress;
    n = points.size();
    inside = doubleArea() < 0 ? -1 : 1;
  }

  /**
   * The rings into which the chain falls apart where it comes to a vertex again, each as the
   * numbers of its vertices in their order; what goes to and fro only is left out. One ring of all
   * vertices if no two coincide.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static List<int[]> rings(Points points, Progress progress) {
    List<int[]> rings = new ArrayList<>();
    Map<Place, Integer> depth = new HashMap<>(); // of the places on the way
    int[] way = new int[points.size()];
    int length = 0;
    for (int v = 0; v < points.size(); v++) {
      Progress.check(progress, v);
      Integer before = depth.get(Place.of(points, v));
      if (before != null) {
        add(rings, Arrays.copyOfRange(way, before, length), points);
        while (length > before) {
          depth.remove(Place.of(points, way[--length]));
        }
      }
      depth.put(Place.of(points, v), length);
      way[length++] = v;
    }
    add(rings, Arrays.copyOf(way, length), points);
    return rings;
  }

  /** A place by its coordinates; 0 and −0 are one. */
  private record Place(double x, double y) {
    static Place of(Points points, int v) {
      return new Place(points.x(v) + 0.0, points.y(v) + 0.0);
    }
  }

  private static void add(List<int[]> rings, int[] ring, Points points) {
    for (int k = 2; k < ring.length; k++) {
      if (points.orient(ring[0], ring[1], ring[k]) != 0) {
        rings.add(ring);
        return;
      }
    }
  }

  /**
   * The same ring with every vertex where it meets itself moved a hair, so that it is simple; into
   * the inside, but away from what it meets there. Nothing if that cannot be, because edges cross.
   * The hair is some 10⁻¹¹ of the ring's size, more where that does not do, at most 2⁻¹² of it.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Optional<Points> parted(Points points, Progress progress) {
    return points.size() < 3 ? Optional.empty() : new Touching(points, progress).parted();
  }

  private Optional<Points> parted() {
    findCoinciding();
    double size = size();
    double finest = 64 * Math.ulp(largest());
    for (double hair = Math.max(LEAST * size, finest); hair <= MOST * size; hair *= STEP) {
      Optional<Points> moved = partedBy(hair);
      if (moved.isPresent()) {
        return moved;
      }
    }
    return Optional.empty();
  }

  /** Moves more vertices as long as the check finds one that touches; nothing if it finds worse. */
  private Optional<Points> partedBy(double hair) {
    while (true) {
      Points moved = moved(hair);
      Optional<Defect> defect = SimplicityCheck.firstDefect(moved, progress);
      if (defect.isEmpty()) {
        return Optional.of(moved);
      }
      if (!addMet(defect.get())) {
        return Optional.empty();
      }
    }
  }

  /** Whether the defect is of a vertex that was not known to meet an edge. */
  private boolean addMet(Defect defect) {
    return switch (defect.kind()) {
      case TOUCH -> addMet(defect.first(), defect.second());
      case OVERLAP -> {
        boolean first = addOnEdge(defect.first(), defect.second());
        boolean second = addOnEdge(defect.second(), defect.first());
        yield first || second;
      }
      default -> false;
    };
  }

  private boolean addMet(int v, int edge) {
    return met.computeIfAbsent(v, none -> new TreeSet<>()).addAll(List.of(edge, after(edge)));
  }

  /** Adds the ends of an edge that lie on another edge; whether one was not known. */
  private boolean addOnEdge(int edge, int other) {
    boolean isNew = false;
    for (int v : new int[] {edge, after(edge)}) {
      boolean between =
          (points.x(v) - points.x(other)) * (points.x(v) - points.x(after(other))) <= 0
              && (points.y(v) - points.y(other)) * (points.y(v) - points.y(after(other))) <= 0;
      if (between && points.orient(other, after(other), v) == 0) {
        isNew |= addMet(v, other);
      }
    }
    return isNew;
  }

  private void findCoinciding() {
    int[] order = PlaneOrder.byYThenX(points, progress);
    for (int from = 0; from < n; ) {
      int to = from + 1;
      while (to < n && points.same(order[from], order[to])) {
        to++;
      }
      for (int i = from; i < to; i++) {
        for (int j = from; j < to && j != i; j++) {
          addMet(order[i], before(order[j]));
          addMet(order[i], order[j]);
          addMet(order[j], before(order[i]));
          addMet(order[j], order[i]);
        }
      }
      from = to;
    }
  }

  /** Whether the inside at a vertex, between its edges, holds something that it meets there. */
  private boolean isMetInside(int v) {
    return met.get(v).stream().anyMatch(end -> !points.same(end, v) && isInside(v, end));
  }

  private boolean isInside(int v, int end) {
    int p = before(v);
    int q = after(v);
    boolean leftIn = inside * points.orient(p, v, end) > 0;
    boolean leftOut = inside * points.orient(v, q, end) > 0;
    return inside * points.orient(p, v, q) > 0 ? leftIn && leftOut : leftIn || leftOut;
  }

  private Points moved(double hair) {
    double[] x = points.xs();
    double[] y = points.ys();
    for (int v : met.keySet()) {
      int p = before(v);
      int q = after(v);
      double in = length(points.x(v) - points.x(p), points.y(v) - points.y(p));
      double out = length(points.x(q) - points.x(v), points.y(q) - points.y(v));
      double inX = (points.x(v) - points.x(p)) / in;
      double inY = (points.y(v) - points.y(p)) / in;
      double outX = (points.x(q) - points.x(v)) / out;
      double outY = (points.y(q) - points.y(v)) / out;
      double alike = 1 + inX * outX + inY * outY;
      double far = hair / Math.max(SHARPEST, alike); // as far from both edges
      double side = isMetInside(v) ? -inside : inside;
      x[v] -= far * side * (inY + outY);
      y[v] += far * side * (inX + outX);
    }
    return Points.of(x, y);
  }

  /** Scaled, lest the squares overflow; of square roots every bit is laid down. */
  private static double length(double x, double y) {
    double scale = Math.max(Math.abs(x), Math.abs(y));
    return scale * Math.sqrt(x / scale * (x / scale) + y / scale * (y / scale));
  }

  private int after(int v) {
    return v + 1 == n ? 0 : v + 1;
  }

  private int before(int v) {
    return v == 0 ? n - 1 : v - 1;
  }

  private double doubleArea() {
    double sum = 0;
    for (int v = 0; v < n; v++) {
      int w = after(v);
      double x = points.x(v) - points.x(0);
      double y = points.y(v) - points.y(0);
      sum += x * (points.y(w) - points.y(0)) - y * (points.x(w) - points.x(0));
    }
    return sum;
  }

  private double size() {
    double[] x = points.xs();
    double[] y = points.ys();
    Arrays.sort(x);
    Arrays.sort(y);
    return Math.max(x[n - 1] - x[0], y[n - 1] - y[0]);
  }

  private double largest() {
    double most = 0;
    for (int v = 0; v < n; v++) {
      most = Math.max(most, Math.max(Math.abs(points.x(v)), Math.abs(points.y(v))));
    }
    return most;
  }
}
