package dct.ui.document;

import dct.problem.Solution;

/** The words for a result, the same wherever it was made or read: what was done to get it. */
public final class ResultTitle {
  /** What Scan-Flip is called, by itself and in a title. */
  public static final String FLIP = "Perform Flip";

  private ResultTitle() {}

  /** What was done last, and after what: {@code Perform Flip after Most Even Vertices}. */
  public static String of(Solution solution) {
    String made = unflipped(solution);
    return solution.flips().isPresent() ? FLIP + " after " + made : made;
  }

  /** What the optimizer was asked for, or else the method: an optimum keeps nothing of it. */
  private static String unflipped(Solution solution) {
    return solution
        .optimum()
        .map(best -> MostVertices.title(best.goal()))
        .orElseGet(solution::methodTitle);
  }
}
