package dct.docs;

import dct.cli.CommandLineProgram;
import dct.cli.Console;
import dct.experiment.study.Sample;
import dct.experiment.study.ThesisTable;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;

/**
 * Writes the tables of docs/study.md, and the one of README, from the rows that {@code dct
 * experiment} computes; that takes some minutes. The rows are kept in target/study, and go on where
 * they were.
 *
 * <pre>StudyTables [folder of the real polygons]</pre>
 */
public final class StudyTables {
  static final List<String> RANDOM_LOOKING =
      List.of(
          "two-opt",
          "steady-growth",
          "space-partitioning",
          "star-shaped",
          "x-monotone",
          "orthogonal",
          "spanning-tree",
          "tour");
  private static final List<String> SHAPES =
      Stream.concat(RANDOM_LOOKING.stream(), Stream.of("comb", "spiral", "convex", "bent-edges"))
          .toList();
  private static final List<String> METHODS =
      List.of("ear_clipping", "monotone", "partitioning_aqt");
  private static final String HEADS =
      " ear clipping → Scan-Flip | monotone → Scan-Flip | Partitioning-AQT → Scan-Flip | optimum |\n";
  private static final int FEWEST_VERTICES = 50; // of a real polygon
  private static final int BINS = 20; // for each piece a vertex

  /** One line of a study's CSV file. */
  record Row(Map<String, String> cells) {
    double value(String column) {
      return Double.parseDouble(cells.get(column));
    }

    double percent(String column) {
      return 100 * value(column) / value("n");
    }

    boolean isOf(String shape) {
      return cells.get("shape").equals(shape);
    }
  }

  private StudyTables() {}

  /** Writes the tables. */
  public static void main(String[] args) throws IOException {
    Path folder = Files.createDirectories(Path.of("target", "study"));
    List<Row> polygons = rows(folder.resolve("polygons.csv"), "polygons");
    Page page = Page.read(Path.of("docs", "study.md"));
    page.with("sites", sites(rows(folder.resolve("points.csv"), "points", "--sets", "50")))
        .with("shapes", shapes(polygons, true))
        .with("sizes", sizes(polygons))
        .with("annuli", annuli(rows(folder.resolve("annuli.csv"), "annuli")))
        .with(
            "pieces",
            pieces(
                rows(
                    folder.resolve("bent.csv"),
                    "polygons --shapes bent-edges --sizes 500 --sets 600".split(" ", -1))));
    if (args.length > 0) {
      page.with("files", files(rows(folder.resolve("real.csv"), real(Path.of(args[0])))));
    }
    page.write();
    Page.read(Path.of("README.md")).with("shapes", shapes(polygons, false)).write();
  }

  private static String[] real(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      List<String> words = new ArrayList<>(List.of("polygons", "--shapes", "none"));
      files.sorted().map(Path::toString).forEach(words::add);
      return words.toArray(String[]::new);
    }
  }

  /** The rows of a study, computed where the file does not have them yet. */
  static List<Row> rows(Path csv, String... study) throws IOException {
    List<String> words = new ArrayList<>(List.of("experiment"));
    words.addAll(List.of(study));
    words.addAll(List.of("--quiet", "-o", csv.toString()));
    Console console =
        new Console(
            new ByteArrayInputStream(new byte[0]), OutputStream.nullOutputStream(), System.err);
    int status = CommandLineProgram.run(console, words.toArray(String[]::new));
    if (status != CommandLineProgram.DONE) {
      throw new IOException("dct " + String.join(" ", words) + " ended with status " + status);
    }
    List<String> lines = Files.readAllLines(csv);
    String[] heads = lines.get(0).split(",", -1);
    return lines.stream().skip(1).map(line -> row(heads, line.split(",", -1))).toList();
  }

  private static Row row(String[] heads, String[] cells) {
    Map<String, String> map = new HashMap<>();
    for (int column = 0; column < heads.length; column++) {
      map.put(heads[column], cells[column]);
    }
    return new Row(map);
  }

  /** By the number of holes, and by how many rings have a length that 3 does not divide. */
  static String annuli(List<Row> rows) {
    StringBuilder out = new StringBuilder("| Regions | number |").append(HEADS).append(rule(1, 5));
    for (int holes = 1; holes <= 4; holes++) {
      out.append(annuli(holes == 1 ? "1 hole" : holes + " holes", rows, "holes", holes));
    }
    for (int rings = 1; rings <= 3; rings++) { // of no size studied does 3 divide all lengths
      String words = rings + (rings == 1 ? " ring" : " rings") + " not ≡ 0 mod 3";
      out.append(annuli(words, rows, "rings_not_divisible_by_3", rings));
    }
    return out.toString();
  }

  private static String annuli(String words, List<Row> rows, String column, int value) {
    List<Row> some = rows.stream().filter(row -> row.value(column) == value).toList();
    return line(words, some.size() + " | " + String.join(" | ", shares(some)));
  }

  /** The thesis's means and ours. */
  static String sites(List<Row> rows) {
    List<ThesisTable.Row> thesis = ThesisTable.read().rows();
    return "| | Delaunay | Scan-Flip | increase | Scan-Flip repeated | optimum |\n"
        + "|---|--:|--:|--:|--:|--:|\n"
        + line(
            "thesis, " + thesis.size() + " sets",
            mean(thesis, row -> 100.0 * row.evenBefore() / row.n(), 2),
            mean(thesis, row -> 100.0 * row.evenAfter() / row.n(), 2),
            mean(thesis, row -> increase(row.evenBefore(), row.evenAfter()), 1),
            "",
            "")
        + line(
            "here, " + rows.size() + " sets",
            mean(rows, row -> row.percent("even_before"), 2),
            mean(rows, row -> row.percent("even_after"), 2),
            mean(rows, row -> increase(row.value("even_before"), row.value("even_after")), 1),
            mean(rows, row -> row.percent("even_repeated"), 2),
            mean(rows, row -> row.percent("even_best"), 2));
  }

  private static double increase(double before, double after) {
    return 100 * (after - before) / before;
  }

  private static <T> String mean(List<T> rows, ToDoubleFunction<T> value, int digits) {
    Sample sample = Sample.of(rows.stream().mapToDouble(value).toArray());
    return String.format(
        Locale.ROOT,
        "%.{d}f ± %.{d}f".replace("{d}", digits + ""),
        sample.mean(),
        sample.halfWidth());
  }

  /** A line for each shape, of its polygons of 1,000 vertices. */
  static String shapes(List<Row> rows, boolean sizes) {
    StringBuilder out = new StringBuilder("| Polygons of 1,000 vertices |");
    out.append(sizes ? " reflex | pieces |" : "").append(HEADS);
    out.append(rule(1, sizes ? 6 : 4));
    for (String shape : SHAPES) {
      List<Row> mine =
          rows.stream().filter(row -> row.isOf(shape) && row.value("n") == 1000).toList();
      if (!mine.isEmpty()) {
        out.append(sizes ? withSizes(shape, mine) : line(shape, shares(mine)));
      }
    }
    return out.toString();
  }

  private static String withSizes(String name, List<Row> rows) {
    return line(
        name, number(rows, "reflex"), number(rows, "pieces"), String.join(" | ", shares(rows)));
  }

  private static String number(List<Row> rows, String column) {
    return String.format(
        Locale.ROOT,
        "%.0f",
        rows.stream().mapToDouble(row -> row.value(column)).average().orElse(0));
  }

  /** A line for each size, of all polygons of the shapes that look random. */
  static String sizes(List<Row> rows) {
    List<Row> random =
        rows.stream().filter(row -> RANDOM_LOOKING.contains(row.cells.get("shape"))).toList();
    StringBuilder out = new StringBuilder("| Vertices |").append(HEADS).append(rule(0, 5));
    random.stream()
        .map(row -> (int) row.value("n"))
        .distinct()
        .sorted()
        .forEach(
            n -> {
              List<Row> mine = random.stream().filter(row -> row.value("n") == n).toList();
              out.append(line(String.valueOf(n), shares(mine)));
            });
    return out.toString();
  }

  private static String pieces(List<Row> rows) {
    StringBuilder out = new StringBuilder("| Convex pieces a vertex | polygons |");
    out.append(HEADS).append(rule(1, 5));
    for (int bin = 0; bin < BINS; bin++) {
      int here = bin;
      List<Row> mine =
          rows.stream()
              .filter(row -> Math.floor(row.value("pieces") / row.value("n") * BINS) == here)
              .toList();
      if (!mine.isEmpty()) {
        String range =
            String.format(Locale.ROOT, "%.2f to %.2f", (double) bin / BINS, (bin + 1.0) / BINS);
        out.append(line(range, mine.size() + " | " + String.join(" | ", shares(mine))));
      }
    }
    return out.toString();
  }

  private static String files(List<Row> rows) {
    StringBuilder out = new StringBuilder("| File | n | reflex | pieces |");
    out.append(HEADS).append(rule(1, 7));
    for (Row row : rows) {
      if (row.value("n") >= FEWEST_VERTICES) {
        String name = Path.of(row.cells.get("shape")).getFileName().toString();
        out.append(withSizes(name.replace(".txt", "") + " | " + row.cells.get("n"), List.of(row)));
      }
    }
    return out.toString();
  }

  private static String[] shares(List<Row> rows) {
    Stream<String> methods =
        METHODS.stream()
            .map(m -> share(rows, "even_" + m) + " → " + share(rows, "even_" + m + "_flip"));
    return Stream.concat(methods, Stream.of(share(rows, "even_best"))).toArray(String[]::new);
  }

  private static String share(List<Row> rows, String column) {
    double[] shares = rows.stream().mapToDouble(row -> row.percent(column)).toArray();
    return String.format(Locale.ROOT, "%.1f", Sample.of(shares).mean());
  }

  private static String rule(int words, int numbers) {
    return "|" + "---|".repeat(words) + "--:|".repeat(numbers) + "\n";
  }

  private static String line(String name, String... cells) {
    StringBuilder out = new StringBuilder("| ").append(name).append(" |");
    Arrays.stream(cells).forEach(cell -> out.append(cell.isEmpty() ? " |" : " " + cell + " |"));
    return out.append('\n').toString();
  }
}
