package dct.core.degree.best;

import dct.core.Deadline;
import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.degree.bound.SiteBounds;
import dct.core.degree.exact.ExactSites;
import dct.core.degree.search.SiteOptimizer;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import java.util.concurrent.CancellationException;

/**
 * The triangulation in which the most vertices have the parity wished, with the best lower bound
 * known for the others: the one door to the optimizers.
 *
 * <p>Polygons go to {@link PolygonOptimizer}. Few sites go to {@link ExactSites}. Other sites go
 * from their Delaunay triangulation to {@link SiteOptimizer}, with the bounds that take linear
 * time; if these are not attained, the exact method where it can still solve them, or else the
 * bounds that take longer ({@link SiteBounds}), have the last word.
 *
 * <p>A cancel or the time limit ends the search, not the result: what comes back is a whole
 * triangulation, the best so far, marked as interrupted. Only before there is any triangulation at
 * all, a cancel throws.
 */
public final class BestTriangulation {

  private BestTriangulation() {}

  /** The best triangulation of a simple polygon. */
  public static Optimum of(
      SimplePolygon polygon, ParityGoal goal, SearchLimits limits, Progress progress) {
    return PolygonOptimizer.optimize(polygon, goal, limits, progress);
  }

  /**
   * The best triangulation of sites.
   *
   * @throws CancellationException if cancelled before the Delaunay triangulation is there
   */
  public static Optimum of(Sites sites, ParityGoal goal, SearchLimits limits, Progress progress) {
    return of(Delaunay.triangulate(sites, progress), goal, limits, progress);
  }

  /** The best triangulation of sites, from any triangulation of them. */
  public static Optimum of(
      Triangulation start, ParityGoal goal, SearchLimits limits, Progress progress) {
    Progress timed = new Deadline(progress, limits.seconds());
    LowerBound quick = SiteBounds.quick(start, goal);
    if (start.vertexCount() <= ExactSites.ALWAYS) {
      return exact(start, goal, quick, timed);
    }
    Optimum found = SiteOptimizer.optimize(start, goal, quick, limits, progress);
    if (found.isProven() || found.interrupted()) {
      return found;
    }
    return ExactSites.canSolve(start)
        ? exact(found.triangulation(), goal, quick, timed)
        : withBound(found, SiteBounds.of(start, goal));
  }

  private static Optimum exact(
      Triangulation start, ParityGoal goal, LowerBound quick, Progress progress) {
    try {
      Optimum exact = ExactSites.optimize(start, goal, progress);
      return withBound(exact, quick.max(exact.bound()));
    } catch (CancellationException e) {
      return new Optimum(start, goal, goal.unsatisfied(start), quick, true);
    }
  }

  private static Optimum withBound(Optimum found, LowerBound bound) {
    return new Optimum(
        found.triangulation(), found.goal(), found.unsatisfied(), bound, found.interrupted());
  }
}
