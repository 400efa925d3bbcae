package dct.core.degree;

import dct.core.triangulate.Triangulation;

/**
 * The best triangulation found for a goal, with what is known about how good it is.
 *
 * @param triangulation the triangulation
 * @param goal what was wished
 * @param unsatisfied how many vertices do not have the parity wished
 * @param bound the best lower bound that was proven for that number
 * @param interrupted whether a time limit or the user ended the search early
 */
public record Optimum(
    Triangulation triangulation,
    ParityGoal goal,
    int unsatisfied,
    LowerBound bound,
    boolean interrupted) {

  /** Whether no triangulation can satisfy more: the bound is attained. */
  public boolean isProven() {
    return unsatisfied == bound.value();
  }
}
