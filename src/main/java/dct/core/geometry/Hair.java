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
import java.util.stream.Collectors;

/** Moves the vertices where rings touch by a hair, for {@link Touching#parted(Rings, Progress)}. */
final class Hair {
  private static final double LEAST = 0x1p-36; // of the size, that a vertex is moved
  private static final double MOST = 0x1p-12;
  private static final double STEP = 8;
  private static final double SHARPEST = 0.25; // 1 + the cosine between both normals

  private final Rings rings;
  private final Points points;
  private final Progress progress;
  private final int n;
  private final double[] inside; // by ring: 1 if the region is on its left, else -1

  /** The vertices where a ring meets one, with the ends of the edges that it meets there. */
  private final Map<Integer, Set<Integer>> met = new TreeMap<>();

  /** Which vertices stay, by attempt: none; or of each place one, as thin holes need it. */
  private final List<Set<Integer>> resting = new ArrayList<>();

  Hair(Rings rings, Progress progress) {
    this.rings = rings;
    this.progress = progress;
    points = rings.points();
    n = points.size();
    inside = new double[rings.count()];
    Arrays.setAll(inside, r -> doubleArea(r) < 0 == (r == 0) ? -1 : 1);
  }

  /** The rings apart, or nothing if no hair parts them. */
  Optional<Rings> parted() {
    Meetings meetings = Meetings.of(rings, progress);
    if (!findMet(meetings)) {
      return Optional.empty();
    }
    findResting(meetings.groups());
    int[] fixed = inSight(rings.fixed());
    for (double hair : hairs()) {
      for (Set<Integer> resting : resting) {
        Optional<Rings> moved = partedBy(hair, resting, fixed);
        if (moved.isPresent()) {
          return moved;
        }
      }
    }
    return Optional.empty();
  }

  /** From the usual one upwards, then from there downwards, as thin holes need it. */
  private List<Double> hairs() {
    List<Double> hairs = new ArrayList<>();
    double size = size();
    double finest = 64 * Math.ulp(largest());
    double usual = Math.max(LEAST * size, finest);
    for (double hair = usual; hair <= MOST * size; hair *= STEP) {
      hairs.add(hair);
    }
    for (double hair = usual / STEP; hair >= finest; hair /= STEP) {
      hairs.add(hair);
    }
    return hairs;
  }

  /** Moves more vertices as long as the check finds one that touches; nothing if it finds worse. */
  private Optional<Rings> partedBy(double hair, Set<Integer> resting, int... fixed) {
    while (true) {
      Rings moved = with(moved(hair, resting), fixed);
      Optional<Defect> defect = SimplicityCheck.firstDefect(moved, progress);
      if (defect.isEmpty()) {
        return Optional.of(moved);
      }
      if (!addMet(defect.get())) {
        return Optional.empty();
      }
    }
  }

  private Rings with(Points moved, int... fixed) {
    if (rings.isChain()) {
      return Rings.ofChain(moved);
    }
    List<int[]> all = new ArrayList<>();
    for (int r = 0; r < rings.count(); r++) {
      all.add(rings.ring(r));
    }
    return Rings.of(moved, all, fixed);
  }

  /** Whether the defect is of a vertex that was not known to meet an edge. */
  private boolean addMet(Defect defect) {
    int a = defect.first();
    int b = defect.firstEnd();
    int c = defect.second();
    int d = defect.secondEnd();
    return switch (defect.kind()) {
      case TOUCH -> addMet(a, c, d);
      case OVERLAP -> {
        boolean first = addOnEdge(a, c, d);
        boolean firstEnd = addOnEdge(b, c, d);
        boolean second = addOnEdge(c, a, b);
        boolean secondEnd = addOnEdge(d, a, b);
        yield first || firstEnd || second || secondEnd;
      }
      default -> false;
    };
  }

  /** Adds that v, if it is on a ring, meets the edge between c and d. */
  private boolean addMet(int v, int c, int d) {
    return rings.isOnRing(v)
        && met.computeIfAbsent(v, none -> new TreeSet<>()).addAll(List.of(c, d));
  }

  /** The same if v lies on that edge; whether this was not known. */
  private boolean addOnEdge(int v, int c, int d) {
    boolean between =
        (points.x(v) - points.x(c)) * (points.x(v) - points.x(d)) <= 0
            && (points.y(v) - points.y(c)) * (points.y(v) - points.y(d)) <= 0;
    return between && points.orient(c, d, v) == 0 && addMet(v, c, d);
  }

  /** Whether all that meet are vertices of rings, different from those before and after them. */
  private boolean findMet(Meetings meetings) {
    for (int[] group : meetings.groups()) {
      for (int u : group) {
        if (!rings.isOnRing(u) || points.same(u, rings.after(u))) {
          return false;
        }
        for (int v : group) {
          if (u != v && rings.isOnRing(v)) {
            addMet(u, rings.before(v), v);
            addMet(u, v, rings.after(v));
          }
        }
      }
    }
    Map<Integer, int[]> together = new HashMap<>();
    meetings.groups().forEach(group -> together.put(group[0], group));
    boolean all = true;
    for (Map.Entry<Integer, List<Integer>> edge : meetings.inside().entrySet()) {
      for (int place : edge.getValue()) {
        for (int v : together.getOrDefault(place, new int[] {place})) {
          addMet(v, rings.from(edge.getKey()), rings.to(edge.getKey()));
          all &= rings.isOnRing(v);
        }
      }
    }
    return all;
  }

  private void findResting(List<int[]> groups) {
    resting.add(Set.of());
    if (!groups.isEmpty()) {
      resting.add(groups.stream().map(all -> all[all.length - 1]).collect(Collectors.toSet()));
      resting.add(groups.stream().map(all -> all[0]).collect(Collectors.toSet()));
    }
  }

  /** Fixed edges that end at one of several vertices of a place end at that which sees them. */
  private int[] inSight(int... fixed) {
    int[] ends = fixed.clone();
    for (int k = 0; k < ends.length; k++) {
      int v = ends[k];
      int other = fixed[k ^ 1];
      if (met.containsKey(v) && !isInside(v, other)) {
        ends[k] =
            met.get(v).stream()
                .filter(w -> points.same(v, w) && isInside(w, other))
                .findFirst()
                .orElse(v);
      }
    }
    return ends;
  }

  /** Whether the region at a vertex, between its edges, holds something that it meets there. */
  private boolean isMetInside(int v) {
    return met.get(v).stream().anyMatch(end -> !points.same(end, v) && isInside(v, end));
  }

  private boolean isInside(int v, int end) {
    int p = rings.before(v);
    int q = rings.after(v);
    double left = inside[rings.ringOf(v)];
    boolean leftIn = left * points.orient(p, v, end) > 0;
    boolean leftOut = left * points.orient(v, q, end) > 0;
    return left * points.orient(p, v, q) > 0 ? leftIn && leftOut : leftIn || leftOut;
  }

  private Points moved(double hair, Set<Integer> resting) {
    double[] x = points.xs();
    double[] y = points.ys();
    for (int v : met.keySet()) {
      if (resting.contains(v)) {
        continue;
      }
      int p = rings.before(v);
      int q = rings.after(v);
      double in = length(points.x(v) - points.x(p), points.y(v) - points.y(p));
      double out = length(points.x(q) - points.x(v), points.y(q) - points.y(v));
      double inX = (points.x(v) - points.x(p)) / in;
      double inY = (points.y(v) - points.y(p)) / in;
      double outX = (points.x(q) - points.x(v)) / out;
      double outY = (points.y(q) - points.y(v)) / out;
      double alike = 1 + inX * outX + inY * outY;
      double far = hair / Math.max(SHARPEST, alike); // as far from both edges
      double left = inside[rings.ringOf(v)];
      double side = isMetInside(v) ? -left : left;
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

  private double doubleArea(int r) {
    int first = rings.vertex(r, 0);
    double sum = 0;
    for (int k = 0; k < rings.size(r); k++) {
      int v = rings.vertex(r, k);
      int w = rings.after(v);
      double x = points.x(v) - points.x(first);
      double y = points.y(v) - points.y(first);
      sum += x * (points.y(w) - points.y(first)) - y * (points.x(w) - points.x(first));
    }
    return sum;
  }

  private double size() {
    Box box = Box.of(points);
    return Math.max(box.maxX() - box.minX(), box.maxY() - box.minY());
  }

  private double largest() {
    double most = 0;
    for (int v = 0; v < n; v++) {
      most = Math.max(most, Math.max(Math.abs(points.x(v)), Math.abs(points.y(v))));
    }
    return most;
  }
}
