package dct.problem.verify;

import java.util.List;
import java.util.Optional;

/**
 * What came of checking a result file: the checks that were made, in order; the last one is the
 * first that failed, if any did.
 */
public record Verdict(List<Check> checks) {

  /** What a check, or all of them together, can come to. */
  public enum Outcome {
    /** Everything claimed was recomputed. */
    TRUE,
    /** Something claimed is not true. */
    FALSE,
    /** Nothing claimed was found false, and something could not be recomputed. */
    OPEN
  }

  /**
   * One check.
   *
   * @param what what was checked, for a person to read
   * @param detail what was found, to be read behind {@code what} and a colon; empty where there is
   *     nothing to add
   * @param line the line of the file that a false claim stands on, from 1 on
   */
  public record Check(String what, Outcome outcome, String detail, int line) {}

  /** A verdict of these checks; the list is copied. */
  public Verdict {
    checks = List.copyOf(checks);
  }

  /** What all checks come to together. */
  public Outcome outcome() {
    return first(Outcome.FALSE)
        .or(() -> first(Outcome.OPEN))
        .map(Check::outcome)
        .orElse(Outcome.TRUE);
  }

  /** The first check with this outcome. */
  public Optional<Check> first(Outcome outcome) {
    return checks.stream().filter(check -> check.outcome() == outcome).findFirst();
  }
}
