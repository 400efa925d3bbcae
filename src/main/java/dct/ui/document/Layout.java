package dct.ui.document;

import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.function.IntUnaryOperator;
import java.util.function.Predicate;
import java.util.stream.IntStream;

/**
 * Which points of a polygon are on which ring, and which edges are fixed; immutable. It knows
 * vertices by their numbers only, so that it is the same when they move.
 *
 * <p>The first ring is the outer one, the others are holes. A vertex on no ring is a site inside.
 * The last ring is the one that is drawn; it may still be empty, and is left out then wherever
 * something is made of the rings.
 */
public final class Layout {
  /** One ring through all points in their order; of sites, which have no rings, too. */
  public static final Layout PLAIN = new Layout(null, new int[0]);

  private final List<RingRuns> rings; // null where it is plain
  private final int[] fixed; // the ends of the fixed edges, two an edge

  private Layout(List<RingRuns> rings, int[] fixed) {
    this.rings = rings;
    this.fixed = fixed;
  }

  /** The layout of these rings and fixed edges. */
  public static Layout of(Rings rings) {
    List<RingRuns> all =
        IntStream.range(0, rings.count()).mapToObj(rings::ring).map(RingRuns::of).toList();
    return of(all, rings.fixed(), rings.points().size());
  }

  /**
   * The layout of these rings and fixed edges.
   *
   * @param rings the vertices of each ring in order, the outer one first; none of them empty but
   *     the last
   * @param n the number of points
   */
  private static Layout of(List<RingRuns> rings, int[] fixed, int n) {
    boolean isPlain = rings.size() == 1 && fixed.length == 0 && isAll(rings.get(0), n);
    return isPlain ? PLAIN : new Layout(rings, fixed);
  }

  private static boolean isAll(RingRuns ring, int n) {
    return ring.equals(RingRuns.ofAll(n));
  }

  /** Whether there is but one ring through all points in their order, and nothing is fixed. */
  public boolean isPlain() {
    return rings == null;
  }

  /** These points with the rings that are not empty, and the fixed edges. */
  public Rings rings(Points points) {
    if (isPlain()) {
      return Rings.ofChain(points);
    }
    List<int[]> drawn =
        rings.stream().filter(ring -> ring.size() > 0).map(RingRuns::vertices).toList();
    return Rings.of(points, drawn.isEmpty() ? List.of(new int[0]) : drawn, fixed);
  }

  /** The vertices of the ring that is drawn, of n points. */
  private RingRuns open(int n) {
    return isPlain() ? RingRuns.ofAll(n) : rings.get(rings.size() - 1);
  }

  /** The first vertex of the ring that is drawn; −1 if it has none. */
  public int first(int n) {
    return open(n).first();
  }

  /** The last vertex of the ring that is drawn; −1 if it has none. */
  public int last(int n) {
    return open(n).last();
  }

  /** How many vertices the ring has that is drawn. */
  public int openSize(int n) {
    return open(n).size();
  }

  /** Whether the ring that is drawn is a hole. */
  public boolean isHole() {
    return !isPlain() && rings.size() > 1;
  }

  /** The number that a vertex gets which is drawn: behind those of the rings, before the sites. */
  public int next(int n) {
    return isPlain() ? n : 1 + rings.stream().mapToInt(RingRuns::highest).max().orElse(-1);
  }

  /** Whether this is a fixed edge. */
  public boolean isFixed(int u, int v) {
    return fixedAt(u, v) >= 0;
  }

  private int fixedAt(int u, int v) {
    for (int j = 0; j < fixed.length; j += 2) {
      if (Rings.key(fixed[j], fixed[j + 1]) == Rings.key(u, v)) {
        return j;
      }
    }
    return -1;
  }

  /** A place on a ring: a new vertex comes before what is there now. */
  private record Place(int ring, int at) {}

  /** Between the ends of this edge of a ring; nothing if it is none. */
  private Optional<Place> placeOfEdge(int u, int v) {
    for (int r = 0; r < rings.size(); r++) {
      int[] ring = rings.get(r).vertices();
      for (int k = 0; k < ring.length; k++) {
        int after = ring[k + 1 == ring.length ? 0 : k + 1];
        if ((ring[k] == u && after == v) || (ring[k] == v && after == u)) {
          return Optional.of(new Place(r, k + 1));
        }
      }
    }
    return Optional.empty();
  }

  /** The same with a hole that is to be drawn, unless there is such a one. */
  public Layout withHole(int n) {
    if (openSize(n) == 0) {
      return this;
    }
    List<RingRuns> more = new ArrayList<>(isPlain() ? List.of(open(n)) : rings);
    more.add(RingRuns.of());
    return new Layout(more, fixed);
  }

  /** The same without rings that have no vertices. */
  Layout settled(int n) {
    return isPlain() || rings.stream().allMatch(ring -> ring.size() > 0)
        ? this
        : without(Selection.NONE, n, ring -> false);
  }

  /** With a vertex more at the end of the ring that is drawn; its number is {@link #next}. */
  Layout drawn(int n) {
    return isPlain() ? this : inserted(next(n), 1, rings.size() - 1, openSize(n), n);
  }

  /** With a site more inside; its number is n. */
  Layout withSite(int n) {
    return new Layout(isPlain() ? List.of(open(n)) : rings, fixed);
  }

  /** The number that a vertex gets which splits an edge: behind the first end, or the last. */
  public int splitNumber(int from, int to, int n) {
    if (isPlain()) {
      return Math.max(from, to) == n - 1 && Math.min(from, to) == 0 ? n : Math.max(from, to);
    }
    return placeOfEdge(from, to).map(place -> before(place) + 1).orElse(n);
  }

  private int before(Place place) {
    return rings.get(place.ring).vertices()[place.at - 1];
  }

  /** With a vertex between the ends of an edge of a ring or of a fixed one; of others, a site. */
  Layout split(int from, int to, int n) {
    if (isPlain()) {
      return this;
    }
    int number = splitNumber(from, to, n);
    Optional<Place> place = placeOfEdge(from, to);
    if (place.isPresent()) {
      return inserted(number, 1, place.get().ring, place.get().at, n);
    }
    int j = fixedAt(from, to);
    if (j < 0) {
      return withSite(n);
    }
    int[] parts = Arrays.copyOf(fixed, fixed.length + 2);
    parts[j + 1] = number;
    parts[fixed.length] = number;
    parts[fixed.length + 1] = fixed[j + 1];
    return new Layout(rings, parts);
  }

  /**
   * With more vertices, of consecutive numbers: behind the one with the number before, on its ring
   * or as sites like it; or, with the number {@link #next}, at the end of the ring that is drawn.
   */
  Layout with(int first, int count, int n) {
    if (isPlain()) {
      return this;
    }
    int r = first == next(n) ? rings.size() - 1 : ringOf(first - 1);
    if (r < 0) {
      return inserted(first, count, -1, 0, n);
    }
    int at = first == next(n) ? rings.get(r).size() : placeOf(r, first - 1) + 1;
    return inserted(first, count, r, at, n);
  }

  private int ringOf(int v) {
    for (int r = 0; r < rings.size(); r++) {
      if (placeOf(r, v) >= 0) {
        return r;
      }
    }
    return -1;
  }

  private int placeOf(int r, int v) {
    int[] ring = rings.get(r).vertices();
    for (int k = 0; k < ring.length; k++) {
      if (ring[k] == v) {
        return k;
      }
    }
    return -1;
  }

  private Layout inserted(int first, int count, int r, int at, int n) {
    Layout moved = renumbered(v -> v < first ? v : v + count, v -> true);
    List<RingRuns> all = new ArrayList<>(moved.rings);
    if (r >= 0) {
      int[] ring = all.get(r).vertices();
      int[] longer = new int[ring.length + count];
      System.arraycopy(ring, 0, longer, 0, at);
      Arrays.setAll(
          longer, k -> k < at ? longer[k] : k < at + count ? first + k - at : ring[k - count]);
      all.set(r, RingRuns.of(longer));
    }
    return of(all, moved.fixed, n + count);
  }

  /** Without these vertices: rings of which none is left are gone, and so are their fixed edges. */
  Layout without(Selection gone, int n) {
    return isPlain() ? this : without(gone, n, ring -> ring.size() == 0);
  }

  /** The same; says also which of the rings that were empty before stay. */
  private Layout without(Selection gone, int n, Predicate<RingRuns> stays) {
    int[] number = new int[n];
    int next = 0;
    for (int v = 0; v < n; v++) {
      number[v] = gone.has(v) ? next : next++;
    }
    Layout left = renumbered(v -> number[v], v -> !gone.has(v));
    List<RingRuns> drawn =
        IntStream.range(0, rings.size())
            .filter(r -> left.rings.get(r).size() > 0 || stays.test(rings.get(r)))
            .mapToObj(left.rings::get)
            .toList();
    return of(drawn.isEmpty() ? List.of(RingRuns.of()) : drawn, left.fixed, next);
  }

  private Layout renumbered(IntUnaryOperator number, IntPredicate stays) {
    List<RingRuns> all =
        rings.stream()
            .map(ring -> Arrays.stream(ring.vertices()).filter(stays).map(number).toArray())
            .map(RingRuns::of)
            .toList();
    int[] kept =
        IntStream.range(0, fixed.length)
            .filter(j -> stays.test(fixed[j]) && stays.test(fixed[j ^ 1]))
            .map(j -> number.applyAsInt(fixed[j]))
            .toArray();
    return new Layout(all, kept);
  }

  /** With this edge fixed, or no longer. */
  public Layout toggled(int u, int v, int n) {
    List<RingRuns> all = isPlain() ? List.of(open(n)) : rings;
    int at = fixedAt(u, v);
    int[] others =
        at < 0
            ? Arrays.copyOf(fixed, fixed.length + 2)
            : IntStream.range(0, fixed.length)
                .filter(j -> j / 2 != at / 2)
                .map(j -> fixed[j])
                .toArray();
    if (at < 0) {
      others[fixed.length] = u;
      others[fixed.length + 1] = v;
    }
    return of(all, others, n);
  }

  /** The vertices on no ring, of n points. */
  public int sites(int n) {
    return isPlain() ? 0 : n - rings.stream().mapToInt(RingRuns::size).sum();
  }

  /** The number of holes that have vertices. */
  public int holes() {
    return isPlain() ? 0 : (int) rings.stream().skip(1).filter(ring -> ring.size() > 0).count();
  }

  /** The number of fixed edges. */
  public int fixedCount() {
    return fixed.length / 2;
  }

  @Override
  public boolean equals(Object other) {
    return this == other
        || (other instanceof Layout that
            && Arrays.equals(fixed, that.fixed)
            && Objects.equals(rings, that.rings));
  }

  @Override
  public int hashCode() {
    return 31 * Arrays.hashCode(fixed) + Objects.hashCode(rings);
  }

  @Override
  public String toString() {
    return isPlain() ? "plain" : holes() + " holes, " + fixedCount() + " fixed edges";
  }
}
