package dct.experiment.study;

import dct.render.TexText;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Tables in LaTeX, to be read in by {@code \input}; they need the packages booktabs and graphicx.
 *
 * <p>The words of a head stand below each other. A table that is wider or longer than a page takes
 * is cut into parts, each with the columns that name its rows; what is still too wide is made
 * smaller.
 */
public final class LatexText {
  /** The letters beside each other on a page of the class article, in this size. */
  private static final int WIDTH = 90;

  private static final int GAP = 3; // between columns, in letters
  private static final int LENGTH = 42; // rows of a page
  private static final String SIZE = "\\footnotesize";
  private static final String FIT =
      "\\resizebox{\\ifdim\\width>\\linewidth\\linewidth\\else\\width\\fi}{!}{%\n";

  private LatexText() {}

  /** The tables that have rows, one after the other. */
  public static String of(List<Table> tables) {
    return "% needs \\usepackage{booktabs,graphicx}\n"
        + tables.stream()
            .filter(table -> !table.rows().isEmpty())
            .flatMap(LatexText::environments)
            .collect(Collectors.joining("\n"));
  }

  /** The parts of a table. */
  private static Stream<String> environments(Table table) {
    List<int[]> parts = parts(table);
    int pages = (table.rows().size() + LENGTH - 1) / LENGTH;
    int all = parts.size() * pages;
    return IntStream.range(0, all)
        .mapToObj(
            i -> {
              int first = i / parts.size() * LENGTH;
              int end = Math.min(first + LENGTH, table.rows().size());
              return environment(
                  table,
                  parts.get(i % parts.size()),
                  table.rows().subList(first, end),
                  caption(table, i, all));
            });
  }

  /** Which columns are beside each other: groups of them, as many as fit. */
  private static List<int[]> parts(Table table) {
    List<int[]> parts = new ArrayList<>();
    int[] keys = IntStream.range(0, table.keys()).toArray();
    int[] part = keys;
    for (int c = table.keys(); c < table.columns().size(); ) {
      int end = endOfGroup(table, c);
      int[] longer = IntStream.concat(Arrays.stream(part), IntStream.range(c, end)).toArray();
      if (part.length > keys.length && width(table, longer) > WIDTH) {
        parts.add(part);
        part = keys;
      } else {
        part = longer;
        c = end;
      }
    }
    parts.add(part);
    return parts;
  }

  /** A head in small letters goes on from the one before it. */
  private static int endOfGroup(Table table, int column) {
    int end = column + 1;
    while (end < table.columns().size()
        && Character.isLowerCase(table.columns().get(end).charAt(0))) {
      end++;
    }
    return end;
  }

  private static int width(Table table, int[] columns) {
    return Arrays.stream(columns).map(c -> width(table, c) + GAP).sum() - GAP;
  }

  private static int width(Table table, int column) {
    Stream<String> words = Arrays.stream(table.columns().get(column).split(" ", -1));
    Stream<String> cells = table.rows().stream().map(row -> row.get(column));
    return Stream.concat(words, cells).mapToInt(String::length).max().orElse(0);
  }

  private static String environment(
      Table table, int[] columns, List<List<String>> rows, String caption) {
    String kinds =
        Arrays.stream(columns)
            .mapToObj(c -> table.isNumeric(c) ? "r" : "l")
            .collect(Collectors.joining());
    StringBuilder out = new StringBuilder("\\begin{table}\n\\centering\n");
    out.append("\\caption{").append(caption).append("}\n").append(SIZE).append('\n');
    out.append(FIT).append("\\begin{tabular}{").append(kinds).append("}\n\\toprule\n");
    out.append(row(Arrays.stream(columns).mapToObj(c -> head(table, c)))).append("\\midrule\n");
    for (List<String> row : rows) {
      out.append(row(Arrays.stream(columns).mapToObj(row::get).map(TexText::of)));
    }
    return out.append("\\bottomrule\n\\end{tabular}}\n\\end{table}\n").toString();
  }

  /** The words of a head below each other. */
  private static String head(Table table, int column) {
    String[] words = table.columns().get(column).split(" ", -1);
    String lines = Arrays.stream(words).map(TexText::of).collect(Collectors.joining("\\\\"));
    String side = table.isNumeric(column) ? "r" : "l";
    return words.length == 1 ? lines : "\\shortstack[" + side + "]{" + lines + "}";
  }

  /** The title, and in the first part what has to be known to read it. */
  private static String caption(Table table, int part, int parts) {
    String title = table.title() + (parts == 1 ? "" : ", part " + (part + 1) + " of " + parts);
    List<String> sentences = new ArrayList<>(List.of(title + "."));
    if (part == 0) {
      sentences.addAll(table.notes());
    }
    return TexText.of(String.join(" ", sentences));
  }

  private static String row(Stream<String> cells) {
    return cells.collect(Collectors.joining(" & ", "", " \\\\\n"));
  }
}
