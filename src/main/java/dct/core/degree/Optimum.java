package dct.core.degree;

import dct.core.triangulate.Triangulation;
import java.util.Locale;

/**
 * The best triangulation found for a goal, with what is known about how good it is.
 *
 * @param triangulation the triangulation
 * @param goal what was wished
 * @param unmet how many vertices do not have the parity wished
 * @param bound the best lower bound that was proven for that number
 * @param interrupted whether a time limit or the user ended the search early
 */
public record Optimum(
    Triangulation triangulation,
    ParityGoal goal,
    int unmet,
    LowerBound bound,
    boolean interrupted) {

  /** A triangulation with a bound that was proven without a search. */
  public static Optimum of(Triangulation triangulation, ParityGoal goal, LowerBound bound) {
    return new Optimum(triangulation, goal, goal.unmet(triangulation), bound, false);
  }

  /** What the same bound says of another triangulation of the same points. */
  public Optimum of(Triangulation other) {
    return new Optimum(other, goal, goal.unmet(other), bound, interrupted);
  }

  /**
   * What is known of how good it is, in a clause for a person: {@code optimal (12 hull sites, 12 ≡
   * 0 mod 3)}.
   */
  public String verdict() {
    if (isProven()) {
      return "optimal (" + bound.reason() + ")";
    }
    return String.format(
        Locale.ROOT,
        "best found%s; %d or more cannot be avoided (%s)",
        interrupted ? " so far" : "",
        bound.value(),
        bound.reason());
  }

  /** What a search tells the user on its way. */
  public static String soFar(int unmet) {
    return "Best so far: " + unmet + " unmet";
  }

  /** Whether no triangulation can grant more: the bound is attained. */
  public boolean isProven() {
    return unmet == bound.value();
  }
}
