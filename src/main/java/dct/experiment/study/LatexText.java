package dct.experiment.study;

import dct.render.TexText;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Tables in LaTeX, to be read in by {@code \input}; they need the packages booktabs and graphicx,
 * which fits them to the width of the text.
 */
public final class LatexText {
  private LatexText() {}

  /** The tables that have rows, one after the other. */
  public static String of(List<Table> tables) {
    return "% needs \\usepackage{booktabs,graphicx}\n"
        + tables.stream()
            .filter(table -> !table.rows().isEmpty())
            .map(LatexText::environment)
            .collect(Collectors.joining("\n"));
  }

  private static String environment(Table table) {
    String kinds =
        IntStream.range(0, table.columns().size())
            .mapToObj(c -> table.isNumeric(c) ? "r" : "l")
            .collect(Collectors.joining());
    StringBuilder out = new StringBuilder("\\begin{table}\n\\centering\n");
    out.append("\\caption{").append(caption(table)).append("}\n");
    out.append("\\resizebox{\\textwidth}{!}{%\n\\begin{tabular}{")
        .append(kinds)
        .append("}\n\\toprule\n");
    out.append(row(table.columns())).append("\\midrule\n");
    table.rows().forEach(row -> out.append(row(row)));
    return out.append("\\bottomrule\n\\end{tabular}}\n\\end{table}\n").toString();
  }

  private static String caption(Table table) {
    String notes = table.notes().stream().map(note -> " " + note).collect(Collectors.joining());
    return TexText.of(table.title() + "." + notes);
  }

  private static String row(List<String> cells) {
    return cells.stream().map(TexText::of).collect(Collectors.joining(" & ", "", " \\\\\n"));
  }
}
