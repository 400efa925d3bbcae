package dct.problem.verify;

import dct.core.Progress;
import dct.core.degree.Preference;
import dct.core.degree.Preferred;
import dct.problem.Instance;
import dct.problem.verify.Verdict.Check;
import dct.problem.verify.Verdict.Outcome;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * What a result file claims of what was preferred among equally good triangulations: the value of
 * this one, computed again from its edges, and perhaps that none has a better one, for which the
 * exact table is filled again.
 */
final class PreferenceClaim {
  /** The field that names what was preferred; without it there is no claim. */
  static final String PREFERRED = "preferred";

  /** The field that says whether it is proven that no other triangulation is preferred. */
  static final String OPTIMAL = "preferenceOptimal";

  /** The field with the edges that were to be kept. */
  static final String GIVEN = "givenEdges";

  private static final String WHAT = "what was preferred";
  private static final double ROUNDING = 1e-12; // of a value that is written in all its digits

  private final Claims claims;
  private final StoredTriangulation stored;
  private final Progress progress;

  /** The claim of a result whose edges, degrees and bound are true. */
  PreferenceClaim(Claims claims, StoredTriangulation stored, Progress progress) {
    this.claims = claims;
    this.stored = stored;
    this.progress = progress;
  }

  /** The fields that only a result with a preference has. */
  static List<String> fields() {
    return List.of(
        OPTIMAL,
        GIVEN,
        Preference.Kind.ANGLE.field(),
        Preference.Kind.LENGTH.field(),
        Preference.Kind.KEPT.field());
  }

  /** Checks it. */
  Check check() {
    try {
      Preference preference = preference(claims);
      checkFields(preference.kind());
      double value = value(preference);
      boolean isOptimal =
          claims
              .flag(OPTIMAL)
              .orElseThrow(
                  () -> new FalseClaim("the field \"" + OPTIMAL + "\" is neither true nor false"));
      return isOptimal ? checkOptimal(preference, value) : new Check(WHAT, Outcome.TRUE, "", 1);
    } catch (FalseClaim lie) {
      return new Check(WHAT, Outcome.FALSE, lie.getMessage(), lie.line());
    }
  }

  /**
   * What is said to have been preferred.
   *
   * @throws FalseClaim if nothing that there is
   */
  static Preference preference(Claims claims) {
    Preference.Kind kind =
        claims
            .text(PREFERRED)
            .flatMap(Preference.Kind::of)
            .orElseThrow(
                () ->
                    new FalseClaim(
                        "the field \"" + PREFERRED + "\" is none of angle, length, kept"));
    return switch (kind) {
      case ANGLE -> Preference.ANGLE;
      case LENGTH -> Preference.LENGTH;
      case KEPT -> Preference.keeping(given(claims));
    };
  }

  private static int[] given(Claims claims) {
    int n = claims.points().size();
    return claims
        .pairs(GIVEN)
        .filter(ends -> Arrays.stream(ends).allMatch(v -> v >= 0 && v < n))
        .orElseThrow(
            () -> new FalseClaim("the field \"" + GIVEN + "\" is no list of pairs of vertices"));
  }

  private void checkFields(Preference.Kind kind) {
    for (Preference.Kind other : Preference.Kind.values()) {
      FalseClaim.unless(
          other == kind || !claims.has(other.field()),
          "the field \"" + other.field() + "\" is there, and preferred was " + kind.word());
    }
    FalseClaim.unless(
        kind == Preference.Kind.KEPT || !claims.has(GIVEN),
        "the field \"" + GIVEN + "\" is there, and preferred was " + kind.word());
  }

  private double value(Preference preference) {
    String field = preference.kind().field();
    double said = claims.number(field).orElse(Double.NaN);
    double truth = preference.value(stored.triangulation());
    FalseClaim.unless(
        said == truth || Math.abs(said - truth) <= ROUNDING * Math.abs(truth),
        "the field \"" + field + "\" is not " + truth);
    return truth;
  }

  private Check checkOptimal(Preference preference, double value) {
    FalseClaim.unless(
        claims.flag("optimal").equals(Optional.of(true)),
        "the field \"" + OPTIMAL + "\" is true, but the result is not said to be optimal");
    Optional<Preferred> best = instance().mostPreferred(preference, progress);
    if (best.isEmpty()) {
      return new Check(WHAT, Outcome.OPEN, "that none is better was not recomputed", 1);
    }
    double least = best.get().value();
    boolean isClose = Math.abs(least - value) <= Preference.TOLERANCE * Math.abs(value);
    FalseClaim.unless(
        isClose || !preference.isBetter(least, value),
        "the field \"" + OPTIMAL + "\" is true, but another has " + best.get().words());
    return new Check(WHAT, Outcome.TRUE, "that none is better was recomputed", 1);
  }

  private Instance instance() {
    Instance instance = stored.instance();
    return instance.with(claims.wishes(instance.size()));
  }
}
