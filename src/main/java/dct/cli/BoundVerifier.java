package dct.cli;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.best.BoundCheck;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Domain;
import dct.io.Result;
import dct.io.StoredResult;
import dct.io.WishLetters;
import java.util.Locale;
import java.util.Optional;
import java.util.function.IntUnaryOperator;

/**
 * Checks what a stored result says of the fewest odd vertices that there can be: {@code
 * oddLowerBound} and, where it rests on more than the boundary count, {@code boundReason}.
 *
 * <p>Without a reason the bound must be that of the boundary count modulo 3. With one it is
 * computed again from the points alone; where that is not possible in reasonable time, the remark
 * says so. Where the file holds wishes, the granted ones are counted and the bound on the missed
 * ones is recomputed in the same way.
 */
final class BoundVerifier {
  private final StoredResult stored;
  private final Domain domain;
  private final int boundary;
  private final long claimed;
  private final IntUnaryOperator degree;
  private String remark = "";

  /**
   * For a result whose vertices, edges and degrees are true.
   *
   * @param boundary the number of vertices on the boundary
   * @param claimed the bound that it states
   * @param degree the degree of each vertex, recounted
   */
  BoundVerifier(
      StoredResult stored, Domain domain, int boundary, long claimed, IntUnaryOperator degree) {
    this.stored = stored;
    this.domain = domain;
    this.boundary = boundary;
    this.claimed = claimed;
    this.degree = degree;
  }

  /** Whether the result is the best for wishes that the file holds, not for all even. */
  boolean isForWishes() {
    return stored.text("wishes").isPresent();
  }

  /** What is wrong with the bound, if anything. */
  Optional<String> lie() {
    int counted = Result.oddLowerBound(boundary);
    if (isForWishes()) {
      return claimed == counted ? wishesLie() : wrongBound(counted, "");
    }
    boolean hasReason = stored.text("boundReason").isPresent();
    if (claimed == counted || (hasReason && claimed > counted)) {
      return hasReason ? recomputed("odd", evenGoal(), claimed) : Optional.empty();
    }
    return wrongBound(counted, hasReason ? " at least" : "");
  }

  private Optional<String> wrongBound(int counted, String atLeast) {
    return Optional.of(
        String.format(
            Locale.ROOT,
            "the field \"oddLowerBound\" says %d, but it is %d%s",
            claimed,
            counted,
            atLeast));
  }

  private ParityGoal evenGoal() {
    return ParityGoal.allEven(stored.points().size());
  }

  private Optional<String> wishesLie() {
    Optional<ParityGoal> goal = WishLetters.parse(stored.text("wishes").orElse(""));
    int n = stored.points().size();
    if (goal.isEmpty() || goal.get().size() != n) {
      return Optional.of("the field \"wishes\" is not " + n + " letters e, o or a");
    }
    int missed = 0;
    for (int v = 0; v < n; v++) {
      missed += goal.get().wish(v).isSatisfiedBy(degree.applyAsInt(v)) ? 0 : 1;
    }
    int granted = n - missed;
    Optional<String> count = claim("unsatisfied", missed).or(() -> claim("satisfied", granted));
    return count.isPresent()
        ? count
        : recomputed("unsatisfied", goal.get(), stored.whole("unsatisfiedLowerBound").orElse(-1));
  }

  private Optional<String> claim(String field, long truth) {
    long said = stored.whole(field).orElse(-1);
    return said == truth
        ? Optional.empty()
        : Optional.of("the field \"" + field + "\" says " + said + ", but it is " + truth);
  }

  /** What is to be told of a true result, empty or beginning with a semicolon. */
  String remark() {
    return remark;
  }

  /** Recomputes a bound on the vertices that this field counts. */
  private Optional<String> recomputed(String counts, ParityGoal goal, long bound) {
    long present = stored.whole(counts).orElse(0);
    String field = "\"" + counts + "LowerBound\"";
    if (bound < 0 || bound > present) {
      return Optional.of(
          String.format(
              Locale.ROOT,
              "the field %s says %d, but %d %s vertices are here",
              field,
              bound,
              present,
              counts));
    }
    BoundCheck check = check(goal, (int) bound);
    String best = check.recomputed().value() + " (" + check.recomputed().reason() + ")";
    switch (check.verdict()) {
      case FALSE -> {
        return Optional.of(
            String.format(
                Locale.ROOT, "the field %s says %d, but the optimum is %s", field, bound, best));
      }
      case OPEN ->
          remark +=
              String.format(
                  Locale.ROOT, "; lower bound %d was not recomputed, only %s", bound, best);
      case RECOMPUTED -> remark += "; lower bound " + bound + " recomputed: " + best;
    }
    return Optional.empty();
  }

  private BoundCheck check(ParityGoal goal, int bound) {
    return domain == Domain.SITES
        ? BoundCheck.of(Sites.of(stored.points(), Progress.NONE), goal, bound, Progress.NONE)
        : BoundCheck.of(
            SimplePolygon.of(stored.points(), Progress.NONE), goal, bound, Progress.NONE);
  }
}
