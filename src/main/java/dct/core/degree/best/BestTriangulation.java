package dct.core.degree.best;

import dct.core.Deadline;
import dct.core.Progress;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.Preference;
import dct.core.degree.Preferred;
import dct.core.degree.SearchLimits;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import java.util.Optional;
import java.util.concurrent.CancellationException;

/**
 * The triangulation in which the most vertices have the parity wished, with the best lower bound
 * known for the others: the entry to the optimizers, {@link PolygonOptimizer} for polygons and
 * {@link SiteOptimizer} for sites.
 *
 * <p>A cancel or the time limit ends the search, not the result: what comes back is a whole
 * triangulation, the best so far, marked as interrupted. Only before there is any triangulation at
 * all, a cancel throws, and the time limit waits.
 */
public final class BestTriangulation {

  private BestTriangulation() {}

  /**
   * The best triangulation of a simple polygon.
   *
   * @throws CancellationException if cancelled before there is a triangulation
   */
  public static Optimum of(
      SimplePolygon polygon, ParityGoal goal, SearchLimits limits, Progress progress) {
    Triangulation start = MonotoneTriangulation.triangulate(polygon, progress);
    return of(polygon, start, goal, limits, progress);
  }

  /** The best triangulation of a simple polygon, from any triangulation of it. */
  public static Optimum of(
      SimplePolygon polygon,
      Triangulation start,
      ParityGoal goal,
      SearchLimits limits,
      Progress progress) {
    return PolygonOptimizer.optimize(polygon, start, goal, limits, progress);
  }

  /**
   * The best triangulation of a simple polygon, and among several equally good ones the most
   * preferred.
   */
  public static Preferred of(
      SimplePolygon polygon,
      Triangulation start,
      ParityGoal goal,
      SearchLimits limits,
      Preference preference,
      Progress progress) {
    return PolygonOptimizer.optimize(polygon, start, goal, limits, preference, progress);
  }

  /**
   * The most preferred of the best triangulations of a simple polygon, proven; or nothing if that
   * would take too much.
   *
   * @throws CancellationException if cancelled
   */
  public static Optional<Preferred> mostPreferred(
      SimplePolygon polygon, ParityGoal goal, Preference preference, Progress progress) {
    return PolygonOptimizer.mostPreferred(polygon, goal, preference, progress);
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
    return SiteOptimizer.optimize(start, goal, limits, progress);
  }

  /** The same, and of several equally good ones that were found the most preferred. */
  public static Preferred of(
      Triangulation start,
      ParityGoal goal,
      SearchLimits limits,
      Preference preference,
      Progress progress) {
    Deadline clock = new Deadline(progress, limits.seconds());
    Optimum best = of(start, goal, limits, progress);
    return PreferredRegions.improve(best, preference, limits, clock);
  }
}
