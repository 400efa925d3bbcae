package dct.problem.verify;

import dct.core.Progress;
import dct.core.degree.best.BoundCheck;
import dct.core.degree.bound.BoundaryColouring;
import dct.core.triangulate.Domain;
import dct.problem.Instance;
import dct.problem.verify.Verdict.Check;
import dct.problem.verify.Verdict.Outcome;
import java.util.Optional;

/**
 * What a result file claims of the fewest odd vertices that there can be, {@code oddLowerBound},
 * and of its being optimal.
 *
 * <p>Without a {@code boundReason} the bound must be that of the boundary count modulo 3, or of a
 * region that which takes linear time. With one it is computed again from the points alone; where
 * that does not reach the claim it is refuted or left open. Where the file holds wishes, the
 * granted ones are counted and the bound on the unmet ones is checked in the same way.
 */
final class BoundClaim {
  private static final String WHAT = "the lower bound";

  private final Claims claims;
  private final StoredTriangulation stored;
  private final Progress progress;

  /** The claim of a result whose edges and degrees are true. */
  BoundClaim(Claims claims, StoredTriangulation stored, Progress progress) {
    this.claims = claims;
    this.stored = stored;
    this.progress = progress;
  }

  /** Checks it. */
  Check check() {
    try {
      return claims.text("wishes").isPresent() ? checkWishes() : checkOdd();
    } catch (FalseClaim lie) {
      return new Check(WHAT, Outcome.FALSE, lie.getMessage(), lie.line());
    }
  }

  private Check checkOdd() {
    long bound = claims.required("oddLowerBound");
    long odd = claims.required("odd");
    boolean hasReason = claims.text("boundReason").isPresent();
    checkCounted(bound, hasReason);
    checkOptimal(odd == bound);
    return hasReason
        ? recomputed("oddLowerBound", "odd vertices", stored.instance(), odd, bound)
        : new Check(WHAT, Outcome.TRUE, "", 1);
  }

  /** Checks the bound against that which takes no search, which it may exceed for a reason. */
  private void checkCounted(long bound, boolean mayExceed) {
    int counted = counted();
    FalseClaim.unless(
        bound == counted || (mayExceed && bound > counted),
        FalseClaim.wrong("oddLowerBound", bound, counted) + (mayExceed ? " at least" : ""));
  }

  private int counted() {
    Instance instance = stored.instance();
    return instance.domain() == Domain.REGION
        ? instance.quickBound(stored.triangulation()).value()
        : BoundaryColouring.allEven(stored.boundary(), "vertices").value();
  }

  private void checkOptimal(boolean optimal) {
    FalseClaim.unless(
        claims.flag("optimal").equals(Optional.of(optimal)),
        "the field \"optimal\" is not " + optimal);
  }

  private Check checkWishes() {
    checkCounted(claims.required("oddLowerBound"), false);
    int n = stored.instance().size();
    Instance instance = stored.instance().with(claims.wishes(n));
    int unmet = 0;
    for (int v = 0; v < n; v++) {
      unmet += instance.wishes().wish(v).isGrantedBy(stored.graph().degree(v)) ? 0 : 1;
    }
    claim("unsatisfied", unmet);
    claim("satisfied", n - unmet);
    long bound = claims.required("unsatisfiedLowerBound");
    checkOptimal(unmet == bound);
    return recomputed("unsatisfiedLowerBound", "unmet wishes", instance, unmet, bound);
  }

  private void claim(String field, long truth) {
    long said = claims.required(field);
    FalseClaim.unless(said == truth, FalseClaim.wrong(field, said, truth));
  }

  /** Recomputes a bound on what is here in this number. */
  private Check recomputed(String field, String what, Instance instance, long present, long bound) {
    FalseClaim.unless(
        bound >= 0 && bound <= present,
        "the field \""
            + field
            + "\" says "
            + bound
            + ", but "
            + present
            + " "
            + what
            + " are here");
    BoundCheck check = instance.check((int) bound, claims.windows(instance.size()), progress);
    int value = check.recomputed().value();
    String reason = " (" + check.recomputed().reason() + ")";
    return switch (check.verdict()) {
      case FALSE ->
          throw new FalseClaim(
              "the field \""
                  + field
                  + "\" says "
                  + bound
                  + ", but the optimum is "
                  + value
                  + reason);
      case OPEN ->
          new Check(WHAT, Outcome.OPEN, bound + " was not recomputed, only " + value + reason, 1);
      case RECOMPUTED -> {
        String more = value > bound ? ", and more: " + value : "";
        yield new Check(WHAT, Outcome.TRUE, bound + " was recomputed" + more + reason, 1);
      }
    };
  }
}
