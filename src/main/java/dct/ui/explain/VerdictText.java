package dct.ui.explain;

import dct.problem.verify.Verdict;
import dct.problem.verify.Verdict.Check;
import dct.problem.verify.Verdict.Outcome;
import java.util.StringJoiner;

/** What came of checking a result, as lines of text with a tick for each check. */
final class VerdictText {
  private VerdictText() {}

  /** What all checks came to. */
  static String heading(Verdict verdict) {
    return switch (verdict.outcome()) {
      case TRUE -> "All that the result says of itself is true";
      case FALSE -> "The result says something of itself that is not true";
      case OPEN -> "Not all that the result says of itself could be computed again";
    };
  }

  /** A line for each check, and how they were made. */
  static String of(Verdict verdict) {
    StringJoiner lines = new StringJoiner("\n");
    for (Check check : verdict.checks()) {
      lines.add(line(check));
    }
    lines.add("");
    lines.add(
        "The result was written as its file would be and read back. Everything was checked against"
            + " its points and edges alone.");
    return lines.toString();
  }

  private static String line(Check check) {
    String what = Character.toUpperCase(check.what().charAt(0)) + check.what().substring(1);
    String detail = check.detail().isEmpty() ? "" : ": " + check.detail();
    return tick(check.outcome()) + "  " + what + detail;
  }

  private static String tick(Outcome outcome) {
    return switch (outcome) {
      case TRUE -> "✓";
      case FALSE -> "✗ false";
      case OPEN -> "? open";
    };
  }
}
