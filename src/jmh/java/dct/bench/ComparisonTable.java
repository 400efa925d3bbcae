package dct.bench;

import dct.bench.Contest.Outcome;
import java.io.PrintStream;
import java.util.List;

/** A table in Markdown with a column for each contender, ours first. */
final class ComparisonTable {
  private final PrintStream out;
  private final List<Contender> contenders;

  ComparisonTable(PrintStream out, List<Contender> contenders) {
    this.out = out;
    this.contenders = contenders;
  }

  void head(String what) {
    StringBuilder head = new StringBuilder("| " + what + " |");
    StringBuilder rule = new StringBuilder("|---|");
    for (Contender contender : contenders) {
      head.append(' ').append(contender.name()).append(" |");
      rule.append("---:|");
    }
    out.println(head);
    out.println(rule);
  }

  void row(String name, Outcome[] outcomes) {
    StringBuilder row = new StringBuilder("| " + name + " |");
    for (int c = 0; c < outcomes.length; c++) {
      row.append(' ').append(cell(outcomes[c], c == 0)).append(" |");
    }
    out.println(row);
  }

  private static String cell(Outcome outcome, boolean isOurs) {
    if (!outcome.isTimed()) {
      return outcome.remark();
    }
    String millis = millis(outcome.millis());
    return isOurs ? "**" + millis + "**" : "%s (%.2f)".formatted(millis, outcome.ratio());
  }

  /** Milliseconds with about three digits. */
  static String millis(double millis) {
    return millis < 1
        ? "%.3f".formatted(millis)
        : millis < 100 ? "%.1f".formatted(millis) : "%,.0f".formatted(millis);
  }
}
