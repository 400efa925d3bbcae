package dct.core.degree.bound;

import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.colour.EmptyFan;
import dct.core.degree.colour.HullRing;
import java.util.Optional;

/**
 * The bound from the triangles along the hull.
 *
 * <p>Walk round the hull. Each of its edges is a side of one triangle, whose third corner is its
 * apex. At a hull vertex the triangles from the apex of the edge before it to the apex of the edge
 * after it are a path of empty triangles round the vertex, or the two edges have one triangle in
 * common. How many there are decides the parity of its degree.
 *
 * <p>Claim: the least number of missed wishes over all closed walks, where every apex and every
 * path of empty triangles is allowed, is a bound. Proof: every triangulation uses empty triangles
 * only and gives one such walk, which misses as many wishes as the triangulation misses on the
 * hull. ∎ The walk is not asked that its triangles at different vertices do not cross.
 *
 * <p>Coloured: where even is wished of all sites inside the hull, either one of them misses its
 * wish, and the bound is one more than that of the walk; or they are all even and the triangles can
 * be two-coloured ({@link BoundaryColouring}), so that only walks count that change the colour at
 * each vertex of odd degree and close with as many black edges as white, modulo 3. The smaller of
 * the two is a bound.
 *
 * <p>Strips: along the straight sides only, from any apex to any apex. Sites inside different sides
 * are different, so the sum over the sides is a bound; never more than that of the closed walk.
 *
 * <p>All empty triangles at the hull are looked at: about 6n at each hull vertex of random sites,
 * n²/2 of sites in convex position. The closed walk is repeated for each apex of its first edge,
 * the one with the fewest. What costs too much is left out and said to be.
 */
final class HullWalkBound {
  private static final long MOST_SIGHTS = 4_000_000; // hull vertices times sites
  private static final int MOST_SITES = 50_000;
  private static final int MOST_TRIANGLES = 16_000_000;
  private static final long MOST_STEPS = 2_000_000_000L;

  private final HullRing ring;
  private final ParityGoal goal;
  private final Handshake handshake;
  private final int known; // a bound up to this is of no use
  private final Progress progress;

  private HullWalkBound(HullRing ring, ParityGoal goal, int known, Progress progress) {
    this.ring = ring;
    this.goal = goal;
    this.known = known;
    this.progress = progress;
    handshake = new Handshake(goal);
  }

  /**
   * The bound of the closed walk, rounded up; or some number up to {@code known} if it is no better
   * than that.
   *
   * @return empty if that is too much to compute
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static Optional<LowerBound> ofWalk(HullRing ring, ParityGoal goal, int known, Progress progress) {
    return new HullWalkBound(ring, goal, known, progress).closedWalk();
  }

  /**
   * The bound of the strips, rounded up.
   *
   * @return empty if that is too much to compute
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static Optional<LowerBound> ofStrips(HullRing ring, ParityGoal goal, Progress progress) {
    return new HullWalkBound(ring, goal, 0, progress).strips();
  }

  private boolean isCheap(int hullVertices) {
    int n = ring.points().size();
    return n <= MOST_SITES && (long) hullVertices * n <= MOST_SIGHTS;
  }

  // ---- the whole hull

  private Optional<LowerBound> closedWalk() {
    return isCheap(ring.size())
        ? fans().flatMap(this::leastOf).map(value -> new LowerBound(value, "hull walk"))
        : Optional.empty();
  }

  /**
   * The least cost of the closed walks, and one that has it.
   *
   * @param cost of the walks that count: the coloured ones where {@code isColoured}
   * @param plain the least cost of walks that are not coloured
   * @param plusInside whether a site inside adds one to it
   * @param route empty if it would take too much memory
   */
  record Least(
      int cost, int plain, boolean isColoured, boolean plusInside, Optional<HullRoute> route) {}

  /**
   * What the bound of the closed walk rests on.
   *
   * @return empty if that is too much to compute
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static Optional<Least> leastWalk(HullRing ring, ParityGoal goal, Progress progress) {
    HullWalkBound bound = new HullWalkBound(ring, goal, 0, progress);
    return bound.isCheap(ring.size()) ? bound.fans().flatMap(bound::leastWalk) : Optional.empty();
  }

  private Optional<Least> leastWalk(EmptyFan[] fans) {
    Walks walks = new Walks(fans);
    boolean canColour = BoundaryColouring.areInnerEven(ring, goal);
    int plain = walks.least(false, -1);
    int plainApex = walks.bestApex;
    int coloured = canColour ? walks.least(true, -1) : HullWalk.UNREACHED;
    boolean isColoured = canColour && (ring.interior() == 0 || coloured <= plain + 1);
    if (walks.gaveUp()) {
      return Optional.empty();
    }
    int apex = isColoured ? walks.bestApex : plainApex;
    Optional<HullRoute> route =
        HullRoute.of(ring, goal, fans, walks.first, apex, isColoured, progress);
    int cost = isColoured ? coloured : plain;
    return Optional.of(new Least(cost, plain, isColoured, canColour && !isColoured, route));
  }

  private Optional<EmptyFan[]> fans() {
    EmptyFan[] fans = new EmptyFan[ring.size()];
    int left = MOST_TRIANGLES;
    for (int k = 0; k < fans.length; k++) {
      progress.checkCancelled();
      fans[k] = EmptyFan.of(ring, k, left).orElse(null);
      if (fans[k] == null) {
        return Optional.empty();
      }
      left -= fans[k].triangles();
    }
    return Optional.of(fans);
  }

  private Optional<Integer> leastOf(EmptyFan[] fans) {
    boolean canColour = BoundaryColouring.areInnerEven(ring, goal);
    boolean isAllOnHull = ring.interior() == 0;
    Walks walks = new Walks(fans);
    int least = isAllOnHull && canColour ? walks.least(true, known) : leastOf(walks, canColour);
    return walks.gaveUp() ? Optional.empty() : Optional.of(handshake.roundUp(least));
  }

  private int leastOf(Walks walks, boolean canColour) {
    // A plain walk of this cost decides, unless the colours can add one to it.
    int plain = walks.least(false, canColour ? known - 1 : known);
    if (!canColour || handshake.roundUp(plain + 1) <= known) {
      return plain;
    }
    int coloured = walks.least(true, Math.max(known, handshake.roundUp(plain)));
    return Math.min(coloured, plain + 1);
  }

  /** All closed walks over one set of fans. */
  private final class Walks {
    private final EmptyFan[] fans;
    private int first; // the walk starts on the edge before this position
    private int bestApex; // of the cheapest walk found last
    private long steps; // triangles and layers walked past

    Walks(EmptyFan[] fans) {
      this.fans = fans;
      for (int k = 1; k < fans.length; k++) {
        first = apexes(k) < apexes(first) ? k : first;
      }
    }

    private int apexes(int k) {
      return fans[k].triangles() - fans[k].firstPartner(fans[k].size() - 1);
    }

    /** Whether the walks so far were too many, so that what they found is no bound. */
    boolean gaveUp() {
      return steps > MOST_STEPS;
    }

    /** The least cost, or the first found that is no better than {@code enough} once rounded up. */
    int least(boolean coloured, int enough) {
      EmptyFan fan = fans[first];
      HullWalk walk = new HullWalk(goal.size(), coloured);
      int least = HullWalk.UNREACHED;
      int place = fan.firstPartner(fan.size() - 1);
      while (place < fan.triangles() && handshake.roundUp(least) > enough && !gaveUp()) {
        int apex = fan.site(fan.partner(place));
        int cost = closed(walk, apex);
        bestApex = cost < least ? apex : bestApex;
        least = Math.min(least, cost);
        place++;
      }
      return least;
    }

    private int closed(HullWalk walk, int apex) {
      walk.startAt(apex);
      for (int k = first; k < first + fans.length; k++) {
        progress.checkCancelled();
        int position = k % fans.length;
        walk.pass(fans[position], goal.wish(ring.site(position)));
        steps += walk.layers() * (long) fans[position].triangles();
      }
      return walk.costAt(apex);
    }
  }

  // ---- the straight sides

  private Optional<LowerBound> strips() {
    int flats = 0;
    for (int k = 0; k < ring.size(); k++) {
      flats += ring.isFlat(k) ? 1 : 0;
    }
    return isCheap(flats) ? sumOfSides() : Optional.empty();
  }

  private Optional<LowerBound> sumOfSides() {
    int corner = 0;
    while (ring.isFlat(corner)) {
      corner++;
    }
    int sum = 0;
    int k = corner + 1;
    while (k < corner + ring.size()) {
      int end = k;
      while (ring.isFlat(end)) {
        end++;
      }
      int cost = end > k ? alongSide(k, end) : 0;
      if (cost < 0) {
        return Optional.empty();
      }
      sum += cost;
      k = end + 1;
    }
    return Optional.of(new LowerBound(handshake.roundUp(sum), "strips along the hull"));
  }

  /** The least cost at the positions from … to − 1, or −1 if that is too much to compute. */
  private int alongSide(int from, int to) {
    HullWalk walk = new HullWalk(goal.size(), false);
    for (int k = from; k < to; k++) {
      progress.checkCancelled();
      Optional<EmptyFan> fan = EmptyFan.of(ring, k, MOST_TRIANGLES);
      if (fan.isEmpty()) {
        return -1;
      }
      if (k == from) {
        walk.startAnywhere(fan.get());
      }
      walk.pass(fan.get(), goal.wish(ring.site(k)));
    }
    return walk.leastCost();
  }
}
