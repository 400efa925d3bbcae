package dct.core.degree.search;

import java.util.Arrays;

/**
 * Shakes a {@link SearchMesh} near its unsatisfied vertices, for sites in regular patterns where
 * plain descent stops early.
 *
 * <p>Each step cuts out a region, most often a few edges away from an unsatisfied vertex, and draws
 * its triangulation at random with probability z to the power of its unsatisfied vertices ({@link
 * RegionSampler}): Gibbs sampling in blocks. While z falls, from where some vertices more are
 * readily put up with to where hardly any is, the unsatisfied vertices wander, meet and vanish;
 * then it rises again, each cycle longer than the one before it. The best mesh seen is kept. A step
 * costs the same whatever the number of sites.
 */
final class AnnealedSearch {
  private static final int COOL_EVERY = 1000; // steps between two changes of z
  private static final int CHECK_EVERY = 16; // steps between two looks at the clock
  private static final int SMALLEST = 6; // vertices of a region
  private static final int AWAY = 6; // fewer steps than this from an unsatisfied vertex

  private final SearchMesh mesh;
  private final SearchMesh best;
  private final SearchRandom random;
  private final SearchClock clock;
  private final MeshRegion region;
  private final Schedule schedule;
  private final int[] place; // by vertex: its place in the list if it is unsatisfied, or NONE
  private int[] list = new int[64]; // the unsatisfied vertices
  private int count; // of them
  private int bestCount;
  private long cycle; // steps of this cycle
  private long step; // of this cycle
  private double z;
  private double zOnHull;

  /**
   * How one search goes about it.
   *
   * @param largest the most vertices of a region
   * @param highest z at the start of a cycle
   * @param lowest z at its end
   * @param anywhere the share of regions that are anywhere, not near an unsatisfied vertex
   * @param cycle the steps of the first cycle
   * @param growth the ratio of a cycle to the one before it
   * @param hullPower the factor of an unsatisfied vertex on the hull is z to this power: below 1,
   *     unsatisfied vertices pass more easily along the hull
   */
  record Schedule(
      int largest,
      double highest,
      double lowest,
      double anywhere,
      int cycle,
      int growth,
      double hullPower) {}

  /** A search on a copy of this mesh. */
  AnnealedSearch(SearchMesh start, SearchRandom random, SearchClock clock, Schedule schedule) {
    mesh = start.copy();
    best = start.copy();
    this.random = random;
    this.clock = clock;
    this.schedule = schedule;
    cycle = schedule.cycle();
    region = new MeshRegion(mesh, random, schedule.largest(), 0, mesh.size());
    place = new int[mesh.size()];
    restart(start);
  }

  /** Goes on from this mesh. */
  void restart(SearchMesh start) {
    mesh.set(start);
    best.set(start);
    count = 0;
    Arrays.fill(place, SearchMesh.NONE);
    for (int v = 0; v < place.length; v++) {
      update(v);
    }
    bestCount = count;
  }

  /** How many vertices of the best mesh seen are unsatisfied. */
  int unsatisfied() {
    return bestCount;
  }

  /** The best mesh seen. */
  SearchMesh best() {
    return best;
  }

  /** Goes on for some steps, or until no more than {@code enough} vertices are unsatisfied. */
  void run(int enough, int steps) {
    for (int s = 0; s < steps && bestCount > enough; s++) {
      if (s % CHECK_EVERY == 0 && clock.isOver()) {
        return;
      }
      cool();
      shake();
      if (count < bestCount) {
        bestCount = count;
        best.set(mesh);
      }
    }
  }

  private void cool() {
    if (step == cycle) {
      step = 0;
      cycle *= schedule.growth();
    }
    if (step % COOL_EVERY == 0) {
      double fall = schedule.lowest() / schedule.highest();
      z = schedule.highest() * Math.pow(fall, (double) step / cycle);
      zOnHull = Math.pow(z, schedule.hullPower());
    }
    step++;
  }

  private void shake() {
    int e = mesh.halfEdgeAt(centre(), random);
    for (int r = random.below(AWAY); r > 0; r--) {
      e = mesh.halfEdgeAt(mesh.corner[SearchMesh.next(e)], random);
    }
    if (region.open(e)) {
      // Small regions more often: the cost of one grows with the third power of its size.
      region.grow(SMALLEST + random.below(random.below(schedule.largest() - SMALLEST) + 1));
      region.fillAtRandom(z, zOnHull);
      for (int i = 0; i < region.size(); i++) {
        update(region.vertex(i));
      }
    }
  }

  private int centre() {
    boolean anywhere = count == 0 || random.fraction() < schedule.anywhere();
    return anywhere ? random.below(mesh.size()) : list[random.below(count)];
  }

  /** Puts v on the list or takes it off, as it is now. */
  private void update(int v) {
    boolean isListed = place[v] != SearchMesh.NONE;
    if (isListed == mesh.isUnsatisfied(v)) {
      return;
    }
    if (isListed) {
      int last = list[--count];
      list[place[v]] = last;
      place[last] = place[v];
      place[v] = SearchMesh.NONE;
    } else {
      list = count == list.length ? Arrays.copyOf(list, 2 * count) : list;
      place[v] = count;
      list[count++] = v;
    }
  }
}
