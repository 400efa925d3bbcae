package dct.core.degree;

/**
 * An optimum, and how good it is by what was preferred among equally good triangulations.
 *
 * @param optimum the triangulation found
 * @param preference what was preferred
 * @param value of the triangulation: see {@link Preference}
 * @param isProven whether no triangulation that grants as many wishes has a better value, up to the
 *     rounding of {@link Preference#TOLERANCE}; only of a proven optimum
 */
public record Preferred(Optimum optimum, Preference preference, double value, boolean isProven) {

  /** An optimum with its value. */
  public static Preferred of(Optimum optimum, Preference preference, boolean isProven) {
    double value = preference.value(optimum.triangulation());
    return new Preferred(optimum, preference, value, isProven);
  }
}
