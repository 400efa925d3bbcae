package dct.core.degree.search;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.degree.region.PartSearch;
import dct.core.degree.region.SearchClock;
import dct.core.degree.region.SearchMesh;
import dct.core.triangulate.Triangulation;
import java.util.function.Consumer;
import java.util.stream.IntStream;

/**
 * A triangulation of sites with as few unsatisfied vertices as can be found: near-exact, and proven
 * optimal where it attains a lower bound.
 *
 * <p>Takes any triangulation of sites, the Delaunay triangulation being a good one to begin with,
 * and a proven lower bound. One routine does all the work: a small region, a simple polygon with no
 * vertex inside, is cut out and triangulated anew by an exact table ({@link RegionTable}), the
 * parities outside it being given. So the number of unsatisfied vertices never grows. First a
 * region around each unsatisfied vertex is solved in spatial order, three times; then the vertices
 * that are left are walked towards each other until they meet and vanish ({@link PartSearch}).
 *
 * <p>Many sites are searched in parts, unbroken stretches of a Hilbert curve, on all cores; the
 * parts depend on the number of sites alone and each has random choices of its own, so that the
 * result does not depend on threads. The parts are then moved by half their length, and what is
 * left is paired over the whole.
 *
 * <p>Where that stops short of the bound, as it does for sites in regular patterns and on long
 * straight sides of the hull, larger parts with vertices inside, up to whole strips along a side,
 * are solved anew by a beam search ({@link StripSearch}). Rectangles of two triangles have their
 * diagonals aligned beforehand, which solves full lattices at once ({@link RectangleDiagonals}).
 *
 * <p>Each step costs the same however many sites there are; on random sites about O(n) steps are
 * taken, and the bound is attained. Space O(n). The same triangulation, goal, seed and effort give
 * the same result unless a limit of time or the user ends the search.
 */
public final class SiteOptimizer {
  private static final int WEIGHT = 1 << 20; // of an unsatisfied vertex, against pull and noise
  private static final int PART = 1 << 13; // vertices of a part
  private static final int SWEEPS = 3;
  private static final int PART_PATIENCE = 3; // rounds that have not helped
  private static final int PATIENCE = 300;

  private final Triangulation start;
  private final ParityGoal goal;
  private final LowerBound bound;
  private final SearchLimits limits;
  private final SearchClock clock;
  private final SearchMesh mesh;
  private int passes;

  private SiteOptimizer(
      Triangulation start,
      ParityGoal goal,
      LowerBound bound,
      SearchLimits limits,
      SearchClock clock) {
    this.start = start;
    this.goal = goal;
    this.bound = bound;
    this.limits = limits;
    this.clock = clock;
    mesh = new SearchMesh(start, goal, WEIGHT);
  }

  /**
   * The best triangulation found: one that attains the bound, or the best so far when the search
   * has done all it does for this effort, the time is up or the user has cancelled.
   *
   * @param start a triangulation of sites; it is returned if it attains the bound, or if the sites
   *     lie on one line
   * @param bound proven by the caller; the search stops where it is attained
   * @param progress is told the best count so far; cancelling ends the search with the best so far
   */
  public static Optimum optimize(
      Triangulation start,
      ParityGoal goal,
      LowerBound bound,
      SearchLimits limits,
      Progress progress) {
    SearchClock clock = new SearchClock(limits, progress);
    int before = goal.unsatisfied(start);
    if (before <= bound.value() || start.triangleCount() == 0 || clock.isOver()) {
      return new Optimum(start, goal, before, bound, clock.struck());
    }
    return new SiteOptimizer(start, goal, bound, limits, clock).run();
  }

  private Optimum run() {
    RectangleDiagonals.align(mesh);
    if (mesh.size() > 2 * PART) {
      searchInParts();
    }
    searchWhole();
    Triangulation best = mesh.toTriangulation(start);
    int unsatisfied = goal.unsatisfied(best);
    boolean isWorse = unsatisfied > goal.unsatisfied(start); // aligned and then interrupted
    boolean interrupted = clock.struck() && unsatisfied > bound.value();
    return isWorse
        ? new Optimum(start, goal, goal.unsatisfied(start), bound, interrupted)
        : new Optimum(best, goal, unsatisfied, bound, interrupted);
  }

  private void searchInParts() {
    for (int pass = 0; pass < SWEEPS; pass++) {
      inParts(part -> part.sweep(0));
    }
    for (int pass = 0; pass < 2; pass++) {
      inParts(part -> part.pairUp(0, PART_PATIENCE));
    }
  }

  /** One pass over all parts at the same time; every other pass moves them by half their length. */
  private void inParts(Consumer<PartSearch> task) {
    int shift = (passes & 1) * (PART / 2);
    int parts = (mesh.size() + shift + PART - 1) / PART;
    IntStream.range(0, parts).parallel().forEach(p -> task.accept(part(p, p * PART - shift)));
    passes++;
    clock.report(0.15 * passes, mesh.unsatisfied());
  }

  private PartSearch part(int index, int from) {
    int lo = Math.max(0, from);
    int hi = Math.min(mesh.size(), from + PART);
    SeededRandom random = SeededRandom.of(limits.seed(), passes, index);
    return new PartSearch(mesh, random, clock, lo, hi);
  }

  private void searchWhole() {
    SeededRandom random = SeededRandom.of(limits.seed(), passes, 0);
    PartSearch whole = new PartSearch(mesh, random, clock, 0, mesh.size());
    for (int pass = passes; pass < SWEEPS; pass++) {
      whole.sweep(bound.value());
    }
    clock.report(0.8, whole.unsatisfied());
    whole.pairUp(bound.value(), PATIENCE);
    if (whole.unsatisfied() > bound.value()) {
      new StripSearch(mesh, clock, limits.seed()).run(bound.value(), limits.effort());
    }
  }
}
