package dct.core.degree.bound;

import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Region;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/**
 * A lower bound for the number of vertices of a region that miss their wished parity, from the
 * wishes and the lengths of the rings alone.
 *
 * <p>One ring without sites is a polygon and has the bound of {@link PolygonBounds}. Otherwise it
 * is the boundary count modulo 3 ({@link BoundaryColouring}), carried to several rings, rounded up
 * by the {@link Handshake} lemma.
 *
 * <p>Claim: let every site be even, and the number of odd vertices on each ring as well. Then the
 * triangles can be coloured black and white so that neighbours differ, and the black boundary edges
 * less the white ones, those of all rings together, are a multiple of 3. Proof: a closed way
 * through neighbouring triangles can be put together from ways round single sites and ways along
 * whole rings. One round a site crosses as many edges as the site has. One along a ring crosses the
 * edges that leave the ring, two less at each vertex than its degree, so that the sum is even if
 * the number of odd vertices is. So every closed way has even length. An inner edge has a black and
 * a white side; counting sides, 3·black triangles − 3·white triangles = black − white boundary
 * edges. ∎
 *
 * <p>Along a ring the colour changes at odd vertices only. The first edge of the outer ring is
 * black without loss, that of each hole is black or white. So a walk round each ring gives the
 * fewest changes against the wishes for each difference modulo 3, and the differences must add up
 * to 0. With all vertices even, of rings of h₀, h₁, … vertices: h₀ ± h₁ ± … ≡ 0 for some choice of
 * signs, or else two vertices are odd. Where a ring has an odd number of odd vertices there are no
 * colours, and nothing follows but that an even number of rings are like that, since all odd
 * vertices are on rings and the handshake lemma counts them. Where a site is wished otherwise than
 * even there is no bound of this kind; and where there are sites one of them may miss its wish in
 * place of any number of ring vertices.
 *
 * <p>O(n).
 */
public final class RegionBounds {
  private static final int UNREACHED = Integer.MAX_VALUE / 4;
  private static final int RESIDUES = 3;
  private static final int ODD_RINGS = 3; // some rings without colours: an odd number of them
  private static final int EVEN_RINGS = 4; // some rings without colours: an even number of them
  private static final int STATES = 5; // the residues come first: every ring has colours
  private static final int MOST_NAMED = 4; // rings whose lengths are in the reason

  private final Region region;
  private final ParityGoal goal;
  private final Handshake handshake;

  private RegionBounds(Region region, ParityGoal goal) {
    this.region = region;
    this.goal = goal;
    handshake = new Handshake(goal);
  }

  /**
   * The best of them.
   *
   * @param goal the wish of each vertex
   * @throws IllegalArgumentException if there is not one wish for each vertex
   */
  public static LowerBound of(Region region, ParityGoal goal) {
    if (goal.size() != region.size()) {
      throw new IllegalArgumentException(goal.size() + " wishes for " + region.size());
    }
    return region.holes() == 0 && region.sites() == 0
        ? PolygonBounds.of(region.size(), alongRing(region, goal))
        : new RegionBounds(region, goal).best();
  }

  private static ParityGoal alongRing(Region region, ParityGoal goal) {
    Wish[] wishes = new Wish[region.size()];
    Arrays.setAll(wishes, k -> goal.wish(region.vertex(k)));
    return ParityGoal.of(wishes);
  }

  private LowerBound best() {
    if (goal.isAll(Wish.EVEN)) {
      return allEven();
    }
    int coloured = areSitesEven() ? coloured() : 0;
    int value = region.sites() == 0 ? coloured : Math.min(1, coloured);
    return handshake
        .bound()
        .max(handshake.roundUp(new LowerBound(value, "boundary edges two-coloured, mod 3")));
  }

  private boolean areSitesEven() {
    for (int v = 0; v < region.size(); v++) {
      if (!region.rings().isOnRing(v) && goal.wish(v) != Wish.EVEN) {
        return false;
      }
    }
    return true;
  }

  /** The fewest ring vertices that miss their wish while all sites are even. */
  private int coloured() {
    int[] least = new int[STATES];
    Arrays.fill(least, UNREACHED);
    int first = 0;
    for (int r = 0; r < region.rings().count(); r++) {
      int at = first;
      int size = region.rings().size(r);
      int[] ring = BoundaryColouring.costs(size, k -> goal.wish(region.vertex(at + k)));
      least = r == 0 ? ofOuter(ring) : withHole(least, ring);
      first += size;
    }
    return Math.min(least[0], least[EVEN_RINGS]);
  }

  private static int[] ofOuter(int[] ring) {
    int[] least = Arrays.copyOf(ring, STATES);
    least[ODD_RINGS] = withoutColours(ring);
    least[EVEN_RINGS] = UNREACHED;
    return least;
  }

  /** The least cost of a walk that comes back in the other colour. */
  private static int withoutColours(int[] ring) {
    return Math.min(ring[RESIDUES], Math.min(ring[RESIDUES + 1], ring[RESIDUES + 2]));
  }

  private static int[] withHole(int[] before, int[] ring) {
    int[] least = new int[STATES];
    Arrays.fill(least, UNREACHED);
    int changing = withoutColours(ring);
    int returning = Math.min(ring[0], Math.min(ring[1], ring[2]));
    for (int s = 0; s < RESIDUES; s++) {
      for (int d = 0; d < RESIDUES; d++) {
        lower(least, (s + d) % RESIDUES, before[s] + ring[d]);
        lower(least, (s + RESIDUES - d) % RESIDUES, before[s] + ring[d]);
      }
      lower(least, ODD_RINGS, before[s] + changing);
    }
    lower(least, ODD_RINGS, before[ODD_RINGS] + returning);
    lower(least, ODD_RINGS, before[EVEN_RINGS] + changing);
    lower(least, EVEN_RINGS, before[EVEN_RINGS] + returning);
    lower(least, EVEN_RINGS, before[ODD_RINGS] + changing);
    return least;
  }

  private static void lower(int[] least, int state, int cost) {
    least[state] = Math.min(least[state], Math.min(cost, UNREACHED));
  }

  // ---- all even

  private LowerBound allEven() {
    if (region.holes() == 0) {
      return BoundaryColouring.allEven(region.positions(), "boundary vertices");
    }
    return coloured() == 0
        ? new LowerBound(0, rings() + ", " + sum() + " ≡ 0 mod 3")
        : new LowerBound(2, rings() + ", 3 divides no " + sum());
  }

  private String rings() {
    List<String> sizes = sizes();
    return sizes.size() <= MOST_NAMED
        ? "rings of " + String.join(", ", sizes) + " vertices"
        : sizes.size() + " rings with " + region.positions() + " vertices";
  }

  private String sum() {
    List<String> sizes = sizes();
    return sizes.size() <= MOST_NAMED
        ? sizes.stream().collect(Collectors.joining(" ± "))
        : sizes.get(0) + " ± … ± " + sizes.get(sizes.size() - 1);
  }

  private List<String> sizes() {
    List<String> sizes = new ArrayList<>();
    for (int r = 0; r < region.rings().count(); r++) {
      sizes.add(Integer.toString(region.rings().size(r)));
    }
    return sizes;
  }
}
