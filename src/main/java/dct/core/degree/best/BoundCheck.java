package dct.core.degree.best;

import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.degree.bound.PolygonBounds;
import dct.core.degree.bound.SiteBounds;
import dct.core.degree.exact.ExactSites;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;

/**
 * What can be said of a lower bound that someone claims, from the input alone.
 *
 * <p>The bounds are computed anew, those of linear time first, and no further than the claim. Where
 * they do not reach it the exact optimum decides, if it can be found in a few seconds: up to 16
 * sites, and some sets of up to 22; polygons of up to 1500 vertices.
 *
 * @param verdict what became of the claim
 * @param recomputed the best bound that was computed
 */
public record BoundCheck(Verdict verdict, LowerBound recomputed) {
  private static final int MOST_VERTICES = 1500; // of a polygon whose optimum is computed

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
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static BoundCheck of(Sites sites, ParityGoal goal, int claimed, Progress progress) {
    Triangulation start = Delaunay.triangulate(sites, progress);
    LowerBound quick = SiteBounds.quick(start, goal);
    if (quick.value() >= claimed) {
      return new BoundCheck(Verdict.RECOMPUTED, quick);
    }
    if (ExactSites.canSolve(start)) {
      return exact(ExactSites.optimize(start, goal, progress).bound(), claimed);
    }
    return inexact(SiteBounds.of(start, goal), claimed);
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
    if (quick.value() >= claimed || polygon.size() > MOST_VERTICES) {
      return inexact(quick, claimed);
    }
    Optimum best = PolygonOptimizer.optimize(polygon, goal, SearchLimits.DEFAULT, progress);
    progress.checkCancelled();
    return best.isProven() ? exact(best.bound(), claimed) : inexact(best.bound(), claimed);
  }

  private static BoundCheck exact(LowerBound optimum, int claimed) {
    return new BoundCheck(optimum.value() >= claimed ? Verdict.RECOMPUTED : Verdict.FALSE, optimum);
  }

  private static BoundCheck inexact(LowerBound bound, int claimed) {
    return new BoundCheck(bound.value() >= claimed ? Verdict.RECOMPUTED : Verdict.OPEN, bound);
  }
}
