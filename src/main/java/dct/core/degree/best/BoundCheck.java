package dct.core.degree.best;

import dct.core.Progress;
import dct.core.degree.LocalBound;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.degree.bound.PolygonBounds;
import dct.core.degree.bound.RegionBounds;
import dct.core.degree.bound.SiteBounds;
import dct.core.geometry.Region;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import java.util.List;

/**
 * What can be said of a lower bound that someone claims, from the input alone.
 *
 * <p>The bounds that take linear time come first. Where they do not reach the claim, the input is
 * solved anew with a small effort: exactly if it is small enough for that ({@link SearchLimits}),
 * or else by a search together with all the bounds. An exact optimum decides every claim. Otherwise
 * a claim is recomputed if a bound reaches it, and false if a triangulation was found that has
 * fewer unmet vertices; what is between the two stays open and must not be believed.
 *
 * @param verdict what became of the claim
 * @param recomputed the best bound that was computed; for a false claim the number of unmet
 *     vertices of the triangulation that refutes it
 */
public record BoundCheck(Verdict verdict, LowerBound recomputed) {
  private static final double EFFORT = 0.1; // of the usual

  /** What became of the claim. */
  public enum Verdict {
    /** It was proven again. */
    RECOMPUTED,
    /** Some triangulation does better. */
    FALSE,
    /** It may hold; what could be recomputed is less. */
    OPEN
  }

  /**
   * Checks a bound for sites.
   *
   * @param claimed the number that no triangulation is said to go below
   * @param windows whose sum it may be; they are checked first
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static BoundCheck of(
      Sites sites, ParityGoal goal, int claimed, List<LocalBound> windows, Progress progress) {
    Triangulation start = Delaunay.triangulate(sites, progress);
    LowerBound quick = SiteBounds.quick(start, goal, progress);
    if (quick.value() < claimed && !windows.isEmpty()) {
      quick = quick.max(SiteBounds.ofWindows(start, goal, windows, progress));
    }
    return quick.value() >= claimed
        ? new BoundCheck(Verdict.RECOMPUTED, quick)
        : judge(SiteOptimizer.optimize(start, goal, quick, limits(), progress), claimed, progress);
  }

  /**
   * Checks a bound for a simple polygon.
   *
   * @param claimed the number that no triangulation is said to go below
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static BoundCheck of(
      SimplePolygon polygon, ParityGoal goal, int claimed, Progress progress) {
    LowerBound quick = PolygonBounds.of(polygon.size(), goal);
    return quick.value() >= claimed
        ? new BoundCheck(Verdict.RECOMPUTED, quick)
        : judge(BestTriangulation.of(polygon, goal, limits(), progress), claimed, progress);
  }

  /**
   * Checks a bound for a region.
   *
   * @param claimed the number that no triangulation is said to go below
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static BoundCheck of(Region region, ParityGoal goal, int claimed, Progress progress) {
    LowerBound quick = RegionBounds.of(region, goal);
    if (quick.value() >= claimed) {
      return new BoundCheck(Verdict.RECOMPUTED, quick);
    }
    Triangulation start = MonotoneTriangulation.triangulate(region, progress);
    Optimum found = RegionOptimizer.optimize(region, start, goal, limits(), progress);
    return judge(found, claimed, progress);
  }

  private static SearchLimits limits() {
    return new SearchLimits(SearchLimits.DEFAULT.seed(), EFFORT, Double.POSITIVE_INFINITY);
  }

  private static BoundCheck judge(Optimum found, int claimed, Progress progress) {
    progress.checkCancelled();
    int unmet = found.unmet();
    if (unmet < claimed) {
      String reason = found.isProven() ? found.bound().reason() : "a triangulation found";
      return new BoundCheck(Verdict.FALSE, new LowerBound(unmet, reason));
    }
    boolean isReached = found.bound().value() >= claimed;
    return new BoundCheck(isReached ? Verdict.RECOMPUTED : Verdict.OPEN, found.bound());
  }
}
