package dct.problem;

import dct.core.Progress;
import dct.core.degree.DegreeCount;
import dct.core.degree.FlipResult;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.ScanFlip;
import dct.core.degree.SearchLimits;
import dct.core.degree.bound.BoundaryColouring;
import dct.core.triangulate.Triangulation;
import java.util.Optional;

/**
 * A triangulation of an instance, how it came to be, and what is known of how good it is;
 * immutable. It is what the window shows, what a result file stores and what a study counts.
 *
 * @param instance what was triangulated
 * @param method the method that made the first triangulation
 * @param triangulation the final triangulation
 * @param flips the triangulations before and after Scan-Flip, if it was run
 * @param optimum what the optimizer found for the instance's wishes, if it was asked; a solution
 *     has flips or an optimum or neither, and their triangulation is the final one
 * @param limits what the optimizer was given; the default if it was not asked
 */
public record Solution(
    Instance instance,
    Method method,
    Triangulation triangulation,
    Optional<FlipResult> flips,
    Optional<Optimum> optimum,
    SearchLimits limits) {

  /** The version of the program, for files that it writes. */
  public static String programVersion() {
    String version = Solution.class.getPackage().getImplementationVersion();
    return version == null ? "development" : version;
  }

  /**
   * Triangulates an instance by a method of its domain.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Solution of(Instance instance, Method method, Progress progress) {
    return of(instance, method, method.run(instance, progress));
  }

  /** A triangulation that the method has made. */
  public static Solution of(Instance instance, Method method, Triangulation made) {
    return new Solution(
        instance, method, made, Optional.empty(), Optional.empty(), SearchLimits.DEFAULT);
  }

  /**
   * The same after Scan-Flip on the final triangulation.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public Solution flipped(Progress progress) {
    return flipped(ScanFlip.run(triangulation, progress));
  }

  /** The same after these flips. */
  public Solution flipped(FlipResult result) {
    return new Solution(
        instance, method, result.after(), Optional.of(result), Optional.empty(), limits);
  }

  /** The same triangulation, of the same instance with other wishes. */
  public Solution wishing(ParityGoal wishes) {
    return of(instance.with(wishes), method, triangulation);
  }

  /** The triangulation that grants the most of the instance's wishes, or the best found. */
  public Solution optimized(SearchLimits given, Progress progress) {
    return optimized(instance.best(triangulation, given, progress), given);
  }

  /**
   * The same with what the optimizer found. Where that rests on flips or a partition, its edges no
   * longer tell of them: they are no part of what was asked for.
   */
  public Solution optimized(Optimum best, SearchLimits given) {
    Triangulation plain = best.triangulation().plain();
    Optimum found = new Optimum(plain, best.goal(), best.unmet(), best.bound(), best.interrupted());
    return new Solution(instance, method, plain, Optional.empty(), Optional.of(found), given);
  }

  /** The even and the odd vertices. */
  public DegreeCount counts() {
    return DegreeCount.of(triangulation);
  }

  /** The even and the odd vertices before the flips, if there were any asked for. */
  public Optional<DegreeCount> countsBefore() {
    return flips.map(result -> DegreeCount.of(result.before()));
  }

  /** What the optimizer found for wishes other than all even. */
  public Optional<Optimum> wished() {
    return optimum.filter(best -> !best.goal().isAll(Wish.EVEN));
  }

  /**
   * A number of odd vertices that no triangulation of the instance goes below: what the optimizer
   * proved, or else that of the boundary count ({@link BoundaryColouring}).
   */
  public LowerBound oddBound() {
    return optimum
        .filter(best -> best.goal().isAll(Wish.EVEN))
        .map(Optimum::bound)
        .orElseGet(
            () -> BoundaryColouring.allEven(triangulation.boundaryCount(), "boundary vertices"));
  }

  /**
   * Whether it is proven to be the best: to have the fewest odd vertices that there can be, or,
   * where the optimizer was asked for other parities, to leave the fewest wishes open.
   */
  public boolean isProven() {
    return wished().map(Optimum::isProven).orElseGet(() -> counts().odd() == oddBound().value());
  }
}
