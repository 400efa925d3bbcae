package dct.core.degree.best;

import dct.core.Deadline;
import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ScanFlip;
import dct.core.degree.SearchLimits;
import dct.core.degree.bound.SiteBounds;
import dct.core.degree.exact.ExactSites;
import dct.core.triangulate.Triangulation;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Supplier;

/**
 * A triangulation of sites with as few unmet vertices as can be found: near-exact, and proven
 * optimal where it attains a lower bound.
 *
 * <p>Takes any triangulation of sites, the Delaunay triangulation being a good one to begin with,
 * and a proven lower bound. The stages, each only if the bound is not attained yet:
 *
 * <ol>
 *   <li>Scan-Flip, the thesis's method: what comes back is never worse, however early it ends.
 *   <li>Up to 16 sites: {@link ExactSites}. Others: small regions, and walks that pair up what is
 *       left ({@link SiteSearch}).
 *   <li>An exact method, if one applies: the table of the polygon that the sites are the corners of
 *       ({@link HullPolygon}), or {@link ExactSites}.
 *   <li>The bounds that take longer ({@link SiteBounds}), and against them the beam search over
 *       strips; after a few strips {@link ProvingSearch}. Of a lattice, other walks come before the
 *       strips: where its rows do not fill the hull one walk in dozens succeeds.
 * </ol>
 *
 * <p>The same triangulation, goal, seed and effort give the same result unless a limit of time or
 * the user ends the search. Then the best so far is returned at once. Scan-Flip and the bounds may
 * take a tenth of a second where the limit is shorter, and the bounds as much after a longer one.
 */
public final class SiteOptimizer {
  private static final int PATIENCE = 300; // rounds of a search that have not helped
  private static final int LITTLE_PATIENCE = 30; // the same for one of many searches
  private static final double LITTLE_EFFORT = 0.02; // for strips, before the slowest bound
  private static final int FEW = 4; // triangulations of a lattice from which searches begin anew
  private static final int ANEW = 1 << 16; // sites of all those searches together

  private final Triangulation start;
  private final ParityGoal goal;
  private final SearchLimits limits;
  private final Deadline clock;
  private final Deadline early; // for what comes first, however short the limit is
  private final Deadline late; // for what follows when the limit has struck
  private Triangulation best;
  private int unmet;
  private SiteSearch search; // the best one
  private LowerBound bound;

  private SiteOptimizer(
      Triangulation start,
      ParityGoal goal,
      LowerBound known,
      SearchLimits limits,
      Progress progress) {
    this.start = start;
    this.goal = goal;
    this.limits = limits;
    clock = new Deadline(progress, limits.seconds());
    early = new Deadline(progress, Math.max(SearchLimits.GRACE, limits.seconds()));
    late = new Deadline(progress, limits.seconds() + SearchLimits.GRACE);
    bound = known == null ? SiteBounds.quick(start, goal, early) : known;
    best = start;
    unmet = goal.unmet(start);
  }

  /**
   * The best triangulation found: one that attains the bound, or the best so far when the search
   * has done all it does for this effort, the time is up or the user has cancelled.
   *
   * @param start a triangulation of sites; it is returned if it attains the bound and there are
   *     more than 16, or if they lie on one line
   * @param bound proven by the caller
   * @param progress is told the best count so far; cancelling ends the search with the best so far
   */
  public static Optimum optimize(
      Triangulation start,
      ParityGoal goal,
      LowerBound bound,
      SearchLimits limits,
      Progress progress) {
    return new SiteOptimizer(start, goal, bound, limits, progress).run();
  }

  /** The same with the bound of {@link SiteBounds#quick}, found within the limits. */
  static Optimum optimize(
      Triangulation start, ParityGoal goal, SearchLimits limits, Progress progress) {
    return new SiteOptimizer(start, goal, null, limits, progress).run();
  }

  private Optimum run() {
    boolean interrupted = false;
    boolean isSmall = start.vertexCount() <= ExactSites.ALWAYS; // always solved the same way
    if (start.triangleCount() > 0 && (isSmall || unmet > bound.value())) {
      try {
        improve();
      } catch (CancellationException e) {
        interrupted = true;
        bound = bound.max(SiteBounds.walked(start, goal, bound, late));
      }
    }
    interrupted |= clock.hasStruck();
    return new Optimum(best, goal, unmet, bound, interrupted && unmet > bound.value());
  }

  private void improve() {
    take(ScanFlip.run(start, early).after());
    clock.checkCancelled();
    if (start.vertexCount() > ExactSites.ALWAYS || !solveExactly()) {
      search();
    }
  }

  private void search() {
    search = searchFrom(start, 0);
    search.alignRectangles();
    boolean solved = false;
    try {
      List<Supplier<Triangulation>> lattice = isOpen() ? LatticeStarts.of(start, clock) : List.of();
      pairUp(lattice);
      clock.checkCancelled();
      solved = isOpen() && solveExactly();
      if (isOpen() && !solved) {
        bound = bound.max(SiteBounds.walked(start, goal, bound, clock));
        pairUpAnew(lattice);
        solveStrips();
      }
    } finally {
      if (!solved && search.unmet() <= unmet) {
        take(search.triangulation());
      }
    }
  }

  private void solveStrips() {
    search.solveStrips(bound.value(), LITTLE_EFFORT * limits.effort());
    if (isOpen()) {
      ProvingSearch last = new ProvingSearch(start, goal, limits, clock, search, bound);
      last.run();
      search = last.search();
      bound = last.bound();
      clock.checkCancelled();
    }
  }

  /** A search whose random choices are others for each number. */
  private SiteSearch searchFrom(Triangulation triangulation, int number) {
    return new SiteSearch(triangulation, goal, limits.seed() + number, clock);
  }

  private boolean isOpen() {
    return search.unmet() > bound.value();
  }

  /**
   * Keeps the best of several searches, the first one and those from a lattice's triangulations.
   */
  private void pairUp(List<Supplier<Triangulation>> lattice) {
    for (Supplier<Triangulation> other : lattice) {
      Triangulation made = other.get();
      if (goal.unmet(made) <= bound.value()) {
        search = searchFrom(made, 0);
        return;
      }
    }
    SiteSearch first = search;
    for (int k = 0; k < lattice.size() && isOpen() && !clock.isCancelled(); k++) {
      pairUp(searchFrom(lattice.get(k).get(), 0), LITTLE_PATIENCE);
    }
    if (isOpen()) {
      first.pairUp(bound.value(), PATIENCE);
      search = search.unmet() < first.unmet() ? search : first;
    }
  }

  /** Begins anew from those triangulations of a lattice that leave the fewest unmet. */
  private void pairUpAnew(List<Supplier<Triangulation>> lattice) {
    double times = lattice.isEmpty() ? 0 : limits.effort() * ANEW / start.vertexCount();
    if (times > 0 && isOpen()) {
      List<Triangulation> few =
          lattice.stream()
              .map(Supplier::get)
              .sorted(Comparator.comparingInt(goal::unmet))
              .limit(FEW)
              .toList();
      for (int k = 0; k < times && isOpen() && !clock.isCancelled(); k++) {
        pairUp(searchFrom(few.get(k % few.size()), 1 + k / few.size()), PATIENCE);
      }
    }
  }

  private void pairUp(SiteSearch next, int patience) {
    next.pairUp(bound.value(), patience);
    search = next.unmet() < search.unmet() ? next : search;
  }

  private void take(Triangulation found) {
    int count = goal.unmet(found);
    if (count <= unmet) {
      best = found;
      unmet = count;
    }
  }

  private boolean solveExactly() {
    Optional<Optimum> exact =
        HullPolygon.applies(start) && start.vertexCount() > ExactSites.ALWAYS
            ? HullPolygon.of(start).optimum(goal, clock)
            : Optional.of(start)
                .filter(ExactSites::canSolve)
                .map(sites -> ExactSites.optimize(sites, goal, clock));
    exact.ifPresent(
        optimum -> {
          best = optimum.triangulation();
          unmet = optimum.unmet();
          bound = bound.max(optimum.bound());
        });
    return exact.isPresent();
  }
}
