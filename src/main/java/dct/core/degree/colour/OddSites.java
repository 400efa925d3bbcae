package dct.core.degree.colour;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.Optional;

/**
 * Decides whether some triangulation of sites, or of a region, has exactly given odd vertices, and
 * no others; or whether that can be said of the sites in a window.
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

  private OddSites(AllTriangles triangles, Triangulation any, BitSet listed) {
    this.listed = listed;
    sides = new SignedSides(triangles, new Boundary(any));
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
        .map(triangles -> new OddSites(triangles, ring.triangulation(), at));
  }

  /**
   * Gets ready to decide for all vertices of what was triangulated, sites or a region; empty if
   * there are more than so many empty triangles.
   *
   * @param any a triangulation with a triangle
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Optional<OddSites> of(Triangulation any, int mostTriangles, Progress progress) {
    BitSet all = new BitSet();
    all.set(0, any.vertexCount());
    Optional<AllTriangles> found =
        any.domain() == Domain.SITES
            ? AllTriangles.of(any.points(), all, mostTriangles, progress)
            : RegionTriangles.of(any, mostTriangles, progress);
    return found.map(triangles -> new OddSites(triangles, any, all));
  }

  /** The triangulation that the boundary was read from. */
  public Triangulation triangulation() {
    return sides.boundary().triangulation();
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
      isAll = sites.cardinality() == sides.boundary().points().size();
      sites.stream().forEach(v -> addEdges(v, sides.triangles()));
      addGaps(sides.boundary());
    }

    private void addEdges(int v, AllTriangles triangles) {
      for (int end : triangles.endsAt(v)) {
        edges.set(end >> 1);
      }
    }

    private void addGaps(Boundary boundary) {
      for (int k = 0; k < boundary.size(); k++) {
        int next = boundary.vertex(boundary.after(k));
        if (sites.get(boundary.vertex(k)) && !sites.get(next)) {
          gaps.set(next);
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
              ? new Answer.Refuted(Refutation.exactly(triangulation().vertexCount(), odd))
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
   * Whether no odd vertex is inside, an even number are on each ring, and the black and white
   * boundary edges, the colour changing at odd vertices, differ by no multiple of 3 whatever the
   * first colour of each ring is: each triangle has three of its colour, and each inner edge one of
   * each.
   */
  private boolean isUnbalanced(BitSet odd) {
    Boundary boundary = sides.boundary();
    int[] sum = new int[boundary.rings()];
    int colour = 1;
    int onRings = 0;
    for (int k = 0; k < boundary.size(); k++) {
      sum[boundary.ring(k)] += colour;
      boolean isOdd = odd.get(boundary.vertex(boundary.after(k)));
      colour = isOdd ? -colour : colour;
      onRings += isOdd ? 1 : 0;
      boolean isEnd = boundary.after(k) <= k;
      if (isEnd && colour < 0) {
        return false;
      }
    }
    return onRings == odd.cardinality() && !canBalance(sum);
  }

  private static boolean canBalance(int... sum) {
    int residues = 1 << Math.floorMod(sum[0], 3); // a bit each
    for (int r = 1; r < sum.length; r++) {
      int step = Math.floorMod(sum[r], 3);
      int moved = (residues << step) | (residues << (3 - step));
      residues = (moved | (moved >> 3)) & 7;
    }
    return (residues & 1) != 0;
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
    Points points = triangulation().points();
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
