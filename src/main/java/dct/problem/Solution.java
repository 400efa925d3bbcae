package dct.problem;

import dct.core.Progress;
import dct.core.degree.DegreeCount;
import dct.core.degree.FlipResult;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.Preference;
import dct.core.degree.Preferred;
import dct.core.degree.ScanFlip;
import dct.core.degree.SearchLimits;
import dct.core.degree.bound.BoundaryColouring;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import java.util.Optional;

/**
 * A triangulation of an instance, how it came to be, and what is known of how good it is;
 * immutable. It is what the window shows, what a result file stores and what a study counts.
 *
 * @param instance what was triangulated
 * @param method the method that made the first triangulation; nothing if that was read from a file
 *     that does not tell
 * @param triangulation the final triangulation
 * @param flips the triangulations before and after the flips of Scan-Flip or by hand, if there were
 *     any asked for; the one after them is the final one
 * @param optimum what is known of the final triangulation and the instance's wishes, if the
 *     optimizer was asked; where flips came after it, the bound is still that of the optimizer
 * @param preferred how good the optimum is by what was preferred among equally good ones, if
 *     anything was, and no flips came after it
 * @param limits what the optimizer was given; the default if it was not asked
 */
public record Solution(
    Instance instance,
    Optional<Method> method,
    Triangulation triangulation,
    Optional<FlipResult> flips,
    Optional<Optimum> optimum,
    Optional<Preferred> preferred,
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
    return of(instance, Optional.of(method), made);
  }

  /** A triangulation that was read from a file which does not tell what made it. */
  public static Solution read(Instance instance, Triangulation found) {
    return of(instance, Optional.empty(), found);
  }

  /** A triangulation that a method has made, if it is known which. */
  public static Solution of(Instance instance, Optional<Method> method, Triangulation made) {
    return new Solution(
        instance,
        method,
        made,
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        SearchLimits.DEFAULT);
  }

  /**
   * The same after Scan-Flip on the final triangulation.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public Solution flipped(Progress progress) {
    return flipped(ScanFlip.run(triangulation, progress));
  }

  /**
   * The same after one more flip, by hand, in linear time. What an optimizer proved is kept: its
   * bound holds for every triangulation. An optimum is one no longer, unless the bound is attained
   * again.
   *
   * @param edge the number of an edge of the final triangulation
   * @throws IllegalArgumentException if it cannot be flipped; see {@link
   *     dct.core.degree.Flip#obstacle}
   */
  public Solution flippedAt(int edge) {
    return flipped(FlipResult.of(triangulation, edge));
  }

  /**
   * The same after these flips, which come after those that there were.
   *
   * @param result flips that begin at the final triangulation
   */
  public Solution flipped(FlipResult result) {
    FlipResult all =
        flips
            .filter(earlier -> earlier.after() == result.before())
            .map(earlier -> earlier.then(result))
            .orElse(result);
    return withFlips(all);
  }

  /**
   * The same with other flips in place of those that there were: a part of them, or more.
   *
   * @param result flips that begin where those that there were begin
   */
  public Solution withFlips(FlipResult result) {
    Optional<Optimum> known = optimum.map(best -> best.of(result.after()));
    return new Solution(
        instance, method, result.after(), Optional.of(result), known, Optional.empty(), limits);
  }

  /**
   * The same triangulation, of the same instance with other wishes. What an optimizer proved for
   * the old ones is lost; the bound of the new ones is that which takes linear time.
   */
  public Solution wishing(ParityGoal wishes) {
    Instance wished = instance.with(wishes);
    Optional<Optimum> known =
        optimum.map(
            best ->
                best.goal().equals(wishes)
                    ? best
                    : Optimum.of(triangulation, wishes, wished.quickBound(triangulation)));
    Optional<Preferred> same = preferred.filter(best -> best.optimum().goal().equals(wishes));
    return new Solution(wished, method, triangulation, flips, known, same, limits);
  }

  /** The triangulation that grants the most of the instance's wishes, or the best found. */
  public Solution optimized(SearchLimits given, Progress progress) {
    return optimized(instance.best(triangulation, given, progress), given);
  }

  /**
   * The triangulation that grants the most of the instance's wishes, and of several such ones the
   * most preferred; or the best found.
   */
  public Solution optimized(SearchLimits given, Preference preference, Progress progress) {
    return optimized(instance.best(triangulation, given, preference, progress), given);
  }

  /** The same with what the optimizer found by a preference. */
  public Solution optimized(Preferred best, SearchLimits given) {
    Solution found = optimized(best.optimum(), given);
    Preferred known =
        new Preferred(
            found.optimum().orElseThrow(), best.preference(), best.value(), best.isProven());
    return new Solution(
        instance,
        method,
        found.triangulation,
        Optional.empty(),
        found.optimum,
        Optional.of(known),
        given);
  }

  /**
   * The same with what the optimizer found. Where that rests on flips or a partition, its edges no
   * longer tell of them: they are no part of what was asked for.
   */
  public Solution optimized(Optimum best, SearchLimits given) {
    Triangulation plain = best.triangulation().plain();
    Optimum found = new Optimum(plain, best.goal(), best.unmet(), best.bound(), best.interrupted());
    return new Solution(
        instance, method, plain, Optional.empty(), Optional.of(found), Optional.empty(), given);
  }

  /** The method's word in files, {@value Method#UNKNOWN} if it is not known. */
  public String methodWord() {
    return method.map(Method::word).orElse(Method.UNKNOWN);
  }

  /** The method's title, or else from which file the triangulation was read. */
  public String methodTitle() {
    return method.map(Method::title).orElseGet(() -> "Read from " + fileName(instance.name()));
  }

  private static String fileName(String path) {
    return path.substring(Math.max(path.lastIndexOf('/'), path.lastIndexOf('\\')) + 1);
  }

  /** What came after the method. */
  public Post post() {
    return Post.of(optimum.isPresent(), flips.isPresent());
  }

  /**
   * What is known of how good it is, in a clause for a person: {@code optimal (12 hull sites, 12 ≡
   * 0 mod 3)}.
   */
  public String verdict() {
    LowerBound bound = bound();
    if (isProven()) {
      return "optimal (" + bound.reason() + ")";
    }
    if (optimum.isPresent() && flips.isEmpty()) {
      return optimum.get().verdict();
    }
    String known =
        bound.value() == 0 ? "0 not excluded" : bound.value() + " or more cannot be avoided";
    return known + " (" + bound.reason() + ")";
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
   * What is counted against the bound: vertices whose wish is not granted, if the optimizer was
   * asked, or else odd ones.
   */
  public int unmet() {
    return optimum.map(Optimum::unmet).orElseGet(() -> counts().odd());
  }

  /** A number that {@link #unmet} of no triangulation of the instance goes below. */
  public LowerBound bound() {
    return optimum.map(Optimum::bound).orElseGet(this::oddBound);
  }

  /**
   * A number of odd vertices that no triangulation of the instance goes below: what the optimizer
   * proved, or else that of the boundary count ({@link BoundaryColouring}), or of a region that
   * which takes linear time.
   */
  public LowerBound oddBound() {
    return optimum
        .filter(best -> best.goal().isAll(Wish.EVEN))
        .map(Optimum::bound)
        .orElseGet(this::quickOddBound);
  }

  private LowerBound quickOddBound() {
    return instance.domain() == Domain.REGION
        ? instance.with(ParityGoal.allEven(instance.size())).quickBound(triangulation)
        : BoundaryColouring.allEven(triangulation.boundaryCount(), "boundary vertices");
  }

  /**
   * Whether it is proven to be the best: to have the fewest odd vertices that there can be, or,
   * where the optimizer was asked for other parities, to leave the fewest wishes open.
   */
  public boolean isProven() {
    return unmet() == bound().value();
  }
}
