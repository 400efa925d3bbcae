package dct.experiment.study;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Tables in Markdown, padded so that they can be read as they are, too. */
public final class MarkdownText {

  private MarkdownText() {}

  /** The tables that have rows, one after the other, each under its title. */
  public static String of(List<Table> tables) {
    StringBuilder out = new StringBuilder();
    for (Table table : tables) {
      if (!table.rows().isEmpty()) {
        out.append(out.isEmpty() ? "" : "\n");
        append(out, table);
      }
    }
    return out.toString();
  }

  private static void append(StringBuilder out, Table table) {
    int[] widths = widths(table);
    out.append("### ").append(escaped(table.title())).append("\n\n");
    appendRow(out, table, table.columns(), widths);
    appendRow(out, table, rule(table, widths), widths);
    table.rows().forEach(row -> appendRow(out, table, row, widths));
    table.notes().forEach(note -> out.append('\n').append(escaped(note)).append('\n'));
  }

  private static int[] widths(Table table) {
    int[] widths = new int[table.columns().size()];
    Arrays.fill(widths, 3);
    List<List<String>> all = new ArrayList<>(table.rows());
    all.add(table.columns());
    for (List<String> row : all) {
      for (int c = 0; c < widths.length; c++) {
        widths[c] = Math.max(widths[c], escaped(row.get(c)).length());
      }
    }
    return widths;
  }

  private static List<String> rule(Table table, int[] widths) {
    List<String> rule = new ArrayList<>();
    for (int c = 0; c < widths.length; c++) {
      rule.add("-".repeat(widths[c] - 1) + (table.isNumeric(c) ? ":" : "-"));
    }
    return rule;
  }

  private static void appendRow(StringBuilder out, Table table, List<String> row, int[] widths) {
    for (int c = 0; c < widths.length; c++) {
      String cell = escaped(row.get(c));
      String blanks = " ".repeat(widths[c] - cell.length());
      out.append("| ").append(table.isNumeric(c) ? blanks + cell : cell + blanks).append(' ');
    }
    out.append("|\n");
  }

  private static String escaped(String text) {
    return text.replace("\\", "\\\\").replace("|", "\\|");
  }
}
