package dct.core.degree.colour;

import dct.core.Progress;
import dct.core.geometry.Points;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.Optional;

/**
 * Decides whether some triangulation of sites has exactly given odd vertices, and no others; or
 * whether that can be said of the sites in a window.
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
  private final BitSet listed; // the sites whose triangles are known
  private int direction; // in which the next refutation is made smaller

  private OddSites(AllTriangles triangles, HullRing ring, BitSet listed) {
    this.listed = listed;
    sides = new SignedSides(triangles, ring);
    search = new ColourSearch(sides);
  }

  /**
   * Gets ready to decide, or is empty if there are more than so many empty triangles.
   *
   * @param at the sites that windows may consist of; others matter as far as triangles at these
   *     have them as corners
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Optional<OddSites> of(
      HullRing ring, BitSet at, int mostTriangles, Progress progress) {
    return AllTriangles.of(ring.points(), at, mostTriangles, progress)
        .map(triangles -> new OddSites(triangles, ring, at));
  }

  /** The hull of the sites. */
  public HullRing ring() {
    return sides.ring();
  }

  // ---- windows

  /**
   * The sites in an open convex region, of which alone something is said.
   *
   * <p>Claim: if some triangulation has exactly the odd vertices O in the window, whatever others
   * it has elsewhere, then the rows on the edges with an end in the window have a solution for O
   * and some of the gaps. Proof: it has one for all its odd vertices, which has one on these rows.
   * Link two triangles if they share such an edge. What is between the centre of an empty triangle,
   * the midpoint of its side and a corner holds no site; so each cycle of links can be moved, over
   * no site, near the corners in the window, and goes round sites of the window only. Hence rays
   * from other sites change no sum of signs on such a cycle. Cycles that leave the hull by one run
   * of hull edges that meet in the window, and come back by another, may go round anything; but
   * whatever that is, it has the parity that the hull sites between the runs have together, and one
   * of them, a gap, can stand for it. One more gap makes the number of odd sites even. ∎
   */
  public static final class Window {
    private final BitSet sites;
    private final BitSet edges = new BitSet();
    private final BitSet gaps = new BitSet();
    private final boolean isAll;

    private Window(BitSet sites, SignedSides sides) {
      this.sites = sites;
      isAll = sites.cardinality() == sides.ring().points().size();
      sites.stream().forEach(v -> addEdges(v, sides.triangles()));
      addGaps(sides.ring());
    }

    private void addEdges(int v, AllTriangles triangles) {
      for (int end : triangles.endsAt(v)) {
        edges.set(end >> 1);
      }
    }

    private void addGaps(HullRing ring) {
      for (int k = 0; k < ring.size(); k++) {
        if (sites.get(ring.site(k)) && !sites.get(ring.site(k + 1))) {
          gaps.set(ring.site(k + 1));
        }
      }
    }

    /** The sites in it. */
    public BitSet sites() {
      return sites;
    }

    /** Hull sites that are not in it, which may be odd or not. */
    public BitSet gaps() {
      return gaps;
    }

    /** Whether the number of odd sites, gaps included, is even. */
    public boolean isEven() {
      return isAll || !gaps.isEmpty();
    }

    /** Whether all sites are in it. */
    public boolean isAll() {
      return isAll;
    }
  }

  /**
   * A window.
   *
   * @param within the sites in an open convex region, some of those whose triangles were listed
   */
  public Window window(BitSet within) {
    BitSet others = (BitSet) within.clone();
    others.andNot(listed);
    if (!others.isEmpty()) {
      throw new IllegalArgumentException("triangles at these sites are not known: " + others);
    }
    return new Window(within, sides);
  }

  /** What was decided. */
  public sealed interface Answer {

    /** There is one, {@link OddSites#corners}; or nothing was found against it in the window. */
    record Found() implements Answer {}

    /** There is none, for this reason. */
    record Refuted(Refutation by) implements Answer {}

    /** It would take more steps. */
    record Open() implements Answer {}
  }

  /**
   * Decides for these odd vertices.
   *
   * @param odd sites of the window, and some of its gaps; an even number where it must be
   * @param mostSteps give up after about so many values and looks at sides
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public Answer decide(Window window, BitSet odd, long mostSteps, Progress progress) {
    boolean isUnbalanced = window.isAll && isUnbalanced(odd);
    long enough = (long) STEPS_A_TRIANGLE * sides.triangles().count();
    long most = isUnbalanced ? Math.min(mostSteps, enough) : mostSteps;
    return switch (search.search(odd.stream().toArray(), window.edges, most, progress)) {
      case FOUND -> new Answer.Found();
      case REFUTED ->
          new Answer.Refuted(
              smaller(Refutation.of(search.refutation(), sides, odd), window, odd, progress));
      case GIVEN_UP ->
          isUnbalanced
              ? new Answer.Refuted(Refutation.exactly(sides.ring().points().size(), odd))
              : new Answer.Open();
    };
  }

  /** After Found with all sites: the triangulation, three sites a triangle, counter-clockwise. */
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
  private Refutation smaller(Refutation whole, Window window, BitSet odd, Progress progress) {
    BitSet support = (BitSet) whole.support().clone();
    support.and(window.sites);
    if (support.cardinality() <= SMALL) {
      return whole;
    }
    Integer[] order = support.stream().boxed().toArray(Integer[]::new);
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
