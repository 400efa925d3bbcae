package dct.cli;

import dct.core.Progress;
import dct.core.degree.BoundCheck;
import dct.core.degree.ParityGoal;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Domain;
import dct.io.Result;
import dct.io.StoredResult;
import java.util.Optional;

/**
 * Checks what a stored result says of the fewest odd vertices that there can be: {@code
 * oddLowerBound} and, where it rests on more than the boundary count, {@code boundReason}.
 *
 * <p>Without a reason the bound must be that of the boundary count modulo 3. With one it is
 * computed again from the points alone; where that is not possible in reasonable time, the remark
 * says so. A bound on missed wishes is not recomputed: the file holds no wishes.
 */
final class BoundVerifier {
  private final StoredResult stored;
  private final Domain domain;
  private final int boundary;
  private final long claimed;
  private String remark = "";

  /**
   * For a result whose vertices, edges and degrees are true.
   *
   * @param boundary the number of vertices on the boundary
   * @param claimed the bound that it states
   */
  BoundVerifier(StoredResult stored, Domain domain, int boundary, long claimed) {
    this.stored = stored;
    this.domain = domain;
    this.boundary = boundary;
    this.claimed = claimed;
  }

  /** What is wrong with the bound, if anything. */
  Optional<String> lie() {
    if (stored.whole("unsatisfiedLowerBound").isPresent()) {
      remark = "; the bound on missed wishes was not recomputed, as the file holds no wishes";
    }
    int counted = Result.oddLowerBound(boundary);
    boolean hasReason = stored.text("boundReason").isPresent();
    if (claimed == counted || (hasReason && claimed > counted)) {
      return hasReason ? recomputed() : Optional.empty();
    }
    String text = "the field \"oddLowerBound\" says %d, but it is %d%s";
    return Optional.of(text.formatted(claimed, counted, hasReason ? " at least" : ""));
  }

  /** What is to be told of a true result, empty or beginning with a semicolon. */
  String remark() {
    return remark;
  }

  private Optional<String> recomputed() {
    long odd = stored.whole("odd").orElse(0);
    if (claimed > odd) {
      String text = "the field \"oddLowerBound\" says %d, but %d odd vertices are here";
      return Optional.of(text.formatted(claimed, odd));
    }
    BoundCheck check = check((int) claimed);
    String best = check.recomputed().value() + " (" + check.recomputed().reason() + ")";
    switch (check.verdict()) {
      case FALSE -> {
        return Optional.of(
            "the field \"oddLowerBound\" says %d, but the optimum is %s".formatted(claimed, best));
      }
      case OPEN ->
          remark += "; lower bound %d was not recomputed, only %s".formatted(claimed, best);
      case RECOMPUTED -> remark += "; lower bound " + claimed + " recomputed: " + best;
    }
    return Optional.empty();
  }

  private BoundCheck check(int bound) {
    ParityGoal goal = ParityGoal.allEven(stored.points().size());
    return domain == Domain.SITES
        ? BoundCheck.of(Sites.of(stored.points()), goal, bound, Progress.NONE)
        : BoundCheck.of(SimplePolygon.of(stored.points()), goal, bound, Progress.NONE);
  }
}
