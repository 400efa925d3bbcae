package dct.core.degree.colour;

import dct.core.Progress;
import dct.core.geometry.Points;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.Optional;

/**
 * Decides whether some triangulation of sites has exactly given odd vertices, and no others.
 *
 * <p>The triangles that it may consist of are coloured so that neighbours differ, but for a change
 * of colour across rays from the odd vertices ({@link SignedSides}); the rows on their edges are
 * solved ({@link PartialColouring}, {@link ColourSearch}). What is refuted is refuted again by
 * fewer rows, those of edges at the sites in a half-plane, so that it says more of other sets.
 *
 * <p>Exact. Takes time and space in proportion to the empty triangles, about 2n² of random sites,
 * for a set that is refuted at once; exponential in the worst case.
 */
public final class OddSites {
  private static final int SMALL = 12; // sites of a refutation that is good enough
  private static final int DIRECTIONS = 4;
  private static final int STEPS_A_TRIANGLE = 6; // if it can be refuted another way
  private static final long STEPS_A_WINDOW = 20_000;

  private final SignedSides sides;
  private final ColourSearch search;
  private final BitSet allEdges = new BitSet();
  private int direction; // in which the next refutation is made smaller

  private OddSites(AllTriangles triangles, HullRing ring) {
    sides = new SignedSides(triangles, ring);
    search = new ColourSearch(sides);
    allEdges.set(0, triangles.edges());
  }

  /**
   * Gets ready to decide, or is empty if there are more than so many empty triangles.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Optional<OddSites> of(HullRing ring, int mostTriangles, Progress progress) {
    Points points = ring.points();
    return AllTriangles.of(points, mostTriangles, progress).map(all -> new OddSites(all, ring));
  }

  /** What was decided. */
  public sealed interface Answer {

    /** There is one, {@link OddSites#corners}. */
    record Found() implements Answer {}

    /** There is none, for this reason. */
    record Refuted(Refutation by) implements Answer {}

    /** It would take more steps. */
    record Open() implements Answer {}
  }

  /**
   * Decides for these odd vertices, whose number is even.
   *
   * @param mostSteps give up after about so many values and looks at sides
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public Answer decide(BitSet odd, long mostSteps, Progress progress) {
    boolean isUnbalanced = isUnbalanced(odd);
    long enough = (long) STEPS_A_TRIANGLE * sides.triangles().count();
    long most = isUnbalanced ? Math.min(mostSteps, enough) : mostSteps;
    return switch (search.search(odd.stream().toArray(), allEdges, most, progress)) {
      case FOUND -> new Answer.Found();
      case REFUTED ->
          new Answer.Refuted(
              smaller(Refutation.of(search.refutation(), sides, odd), odd, progress));
      case GIVEN_UP ->
          isUnbalanced
              ? new Answer.Refuted(Refutation.exactly(sides.ring().points().size(), odd))
              : new Answer.Open();
    };
  }

  /** After Found: the triangulation, three sites a triangle, counter-clockwise. */
  public int[] corners() {
    return search.corners();
  }

  /** All steps so far. */
  public long steps() {
    return search.steps();
  }

  /**
   * Whether no odd vertex is inside the hull and the black and white hull edges, the colour
   * changing at odd vertices, differ by no multiple of 3: each triangle has three of its colour,
   * and each inner edge one of each.
   */
  private boolean isUnbalanced(BitSet odd) {
    HullRing ring = sides.ring();
    int sum = 0;
    int colour = 1;
    int onHull = 0;
    for (int k = 0; k < ring.size(); k++) {
      sum += colour;
      boolean isOdd = odd.get(ring.site(k + 1));
      colour = isOdd ? -colour : colour;
      onHull += isOdd ? 1 : 0;
    }
    return onHull == odd.cardinality() && sum % 3 != 0;
  }

  // ---- fewer rows

  /** Refutes the same by the edges at as few sites on one side as can be found by bisection. */
  private Refutation smaller(Refutation whole, BitSet odd, Progress progress) {
    if (whole.support().cardinality() <= SMALL) {
      return whole;
    }
    Integer[] order = whole.support().stream().boxed().toArray(Integer[]::new);
    Arrays.sort(order, nextDirection());
    Core best = null;
    int held = 0; // so few are not enough
    int enough = order.length;
    while (enough - held > 1) {
      int middle = (held + enough) >>> 1;
      BitSet edges = edgesAt(order, middle);
      if (search.search(odd.stream().toArray(), edges, STEPS_A_WINDOW, progress)
          == ColourSearch.Outcome.REFUTED) {
        enough = middle;
        best = search.refutation();
      } else {
        held = middle;
      }
    }
    return best == null ? whole : Refutation.of(best, sides, odd);
  }

  private Comparator<Integer> nextDirection() {
    Points points = sides.ring().points();
    Comparator<Integer> byX = Comparator.comparingDouble(points::x);
    Comparator<Integer> byY = Comparator.comparingDouble(points::y);
    Comparator<Integer> order =
        direction % 2 == 0 ? byX.thenComparing(byY) : byY.thenComparing(byX);
    boolean isReversed = direction >= DIRECTIONS / 2;
    direction = (direction + 1) % DIRECTIONS;
    return isReversed ? order.reversed() : order;
  }

  private BitSet edgesAt(Integer[] order, int size) {
    BitSet edges = new BitSet();
    for (int i = 0; i < size; i++) {
      for (int end : sides.triangles().endsAt(order[i])) {
        edges.set(end >> 1);
      }
    }
    return edges;
  }
}
