package dct.core.degree;

import java.util.Locale;

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

  /** What was preferred and its value, for a person: {@code smallest angle 3.21°}. */
  public String words() {
    String words =
        switch (preference.kind()) {
          case ANGLE -> String.format(Locale.ROOT, "smallest angle %.4g°", value);
          case LENGTH -> String.format(Locale.ROOT, "total length %.6g", value);
          case KEPT -> String.format(Locale.ROOT, "%.0f edges kept", value);
        };
    return isProven ? words + ", the " + superlative() + " of all equally good ones" : words;
  }

  private String superlative() {
    return switch (preference.kind()) {
      case ANGLE -> "largest";
      case LENGTH -> "least";
      case KEPT -> "most";
    };
  }
}
