package dct.problem;

import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.SearchLimits;
import dct.core.degree.bound.SiteBounds;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;

/**
 * A number of vertices of the wrong parity that no triangulation of the same polygon or sites goes
 * below. It holds for all of them, so that it is computed once for any number of flips.
 *
 * @param domain whether the points are the corners of a polygon or sites
 * @param points the vertices
 * @param goal the parities that are counted against it
 * @param bound the number, and why
 */
public record KnownBound(Domain domain, Points points, ParityGoal goal, LowerBound bound) {
  /** Up to so many vertices the optimum of a polygon is found in a fraction of a second. */
  private static final int MOST_EXACT = 2_000;

  /** What is known without a search, in linear time. */
  public static KnownBound quick(Solution solution) {
    return of(solution, instance(solution).quickBound(solution.triangulation()));
  }

  /**
   * The best that is known: the optimum of a polygon, unless it is large, and for sites the largest
   * of all bounds. It takes up to about a second.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static KnownBound best(Solution solution, Progress progress) {
    Instance instance = instance(solution);
    if (instance.domain() == Domain.SITES) {
      return of(solution, SiteBounds.of(solution.triangulation(), instance.wishes(), progress));
    }
    return instance.size() > MOST_EXACT
        ? quick(solution)
        : of(
            solution,
            instance.best(solution.triangulation(), SearchLimits.DEFAULT, progress).bound());
  }

  private static KnownBound of(Solution solution, LowerBound computed) {
    Instance instance = solution.instance();
    return new KnownBound(
        instance.domain(), instance.points(), goal(solution), solution.bound().max(computed));
  }

  private static Instance instance(Solution solution) {
    return solution.instance().with(goal(solution));
  }

  /** What the optimizer was asked for, or all even. */
  private static ParityGoal goal(Solution solution) {
    return solution
        .optimum()
        .map(Optimum::goal)
        .orElseGet(() -> ParityGoal.allEven(solution.instance().size()));
  }

  /** Whether it is one for this solution. */
  public boolean isOf(Solution solution) {
    return domain == solution.instance().domain()
        && goal.equals(goal(solution))
        && points.equals(solution.instance().points());
  }

  /**
   * What it says of a solution, in two or three words: {@code at least 2 odd}, {@code best
   * possible}.
   */
  public String words(Solution solution) {
    if (solution.unmet() == bound.value()) {
      return "best possible";
    }
    String counted = goal.isAll(Wish.EVEN) ? "odd" : goal.isAll(Wish.ODD) ? "even" : "unmet";
    return "at least " + bound.value() + " " + counted;
  }
}
