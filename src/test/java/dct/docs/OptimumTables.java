package dct.docs;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * Writes the tables of docs/optimum.md: how many vertices stay odd after Scan-Flip and in the best
 * triangulation found, for the files of two folders and for square lattices. Each run of the
 * program is a process of its own.
 *
 * <pre>OptimumTables FOLDER [seconds for each input, 60 if absent]</pre>
 *
 * The folder has one of sites, {@code points}, and one of polygons, {@code polygons}.
 */
public final class OptimumTables {
  static final List<Integer> LATTICES = List.of(4, 5, 6, 7, 8, 9, 10, 12, 16, 20, 24, 32, 48, 64);
  private static final int SEEDS = 10;
  private static final String HEAD =
      """
      | input | n | on the boundary | odd after Scan-Flip | odd, best found | bound, and why | ms |
      |---|---|---|---|---|---|---|
      """;

  /** Runs the program; returns what it printed. */
  @FunctionalInterface
  interface Program {
    /** Standard output, and after it standard error. */
    String run(List<String> arguments) throws IOException, InterruptedException;
  }

  private final Program program;
  private final String seconds;
  private final List<String> open = new ArrayList<>();

  OptimumTables(Program program, String seconds) {
    this.program = program;
    this.seconds = seconds;
  }

  /** Writes the tables. */
  public static void main(String[] args) throws IOException, InterruptedException {
    OptimumTables tables =
        new OptimumTables(OptimumTables::inItsOwnProcess, args.length > 1 ? args[1] : "60");
    Path points = Path.of(args[0], "points");
    Page page = Page.read(Path.of("docs", "optimum.md"));
    page.with("sites", tables.table(files(points), "points"));
    page.with("open", "Not proven: " + tables.listOfOpen() + ".\n");
    page.with("seeds", tables.seeds(points.resolve("tsplib_p654.txt")));
    page.with("lattices", tables.lattices(Files.createTempDirectory("dct"), LATTICES));
    page.with("polygons", tables.table(files(Path.of(args[0], "polygons")), "polygon"));
    page.write();
  }

  private String listOfOpen() {
    return open.isEmpty() ? "none" : String.join(", ", open);
  }

  private static List<Path> files(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.sorted().toList();
    }
  }

  private static String inItsOwnProcess(List<String> arguments)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-cp", System.getProperty("java.class.path"), "dct.Main"));
    command.addAll(arguments);
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    process.waitFor();
    return said;
  }

  /** A row for each file, of this kind. */
  String table(List<Path> files, String kind) throws IOException, InterruptedException {
    StringBuilder out = new StringBuilder(HEAD);
    for (Path file : files) {
      out.append(row(file, kind));
    }
    return out.toString();
  }

  /** A row for each square lattice with as many sites on a side. */
  String lattices(Path folder, List<Integer> sides) throws IOException, InterruptedException {
    List<Path> files = new ArrayList<>();
    for (int side : sides) {
      Path file = folder.resolve("lattice %02d.txt".formatted(side));
      StringBuilder text = new StringBuilder();
      for (int k = 0; k < side * side; k++) {
        text.append(k % side).append(' ').append(Math.floorDiv(k, side)).append('\n');
      }
      files.add(Files.writeString(file, text));
    }
    return table(files, "points");
  }

  private String row(Path file, String kind) throws IOException, InterruptedException {
    String name = file.getFileName().toString().replace(".txt", "");
    List<String> start = new ArrayList<>(List.of("--flip"));
    if (kind.equals("polygon")) {
      start.addAll(List.of("--algorithm", "convex-even"));
    }
    String flipped = triangulate(file, kind, start);
    if (!flipped.startsWith("{")) {
      String why = flipped.strip().replace(file.toString(), "").replaceFirst("^[:0-9]*: ", "");
      return "| " + name + " | | | | | | not triangulated: " + why + " |\n";
    }
    JsonObject best = best(file, kind, 1);
    String bound = best.get("oddLowerBound") + " (" + best.get("boundReason").getAsString() + ")";
    if (!best.get("optimal").getAsBoolean()) {
      open.add(name + " (" + best.get("oddLowerBound") + " to " + best.get("odd") + ")");
    }
    return cells(
        name,
        best.get("vertices"),
        best.get("boundary"),
        json(flipped).get("odd"),
        best.get("odd"),
        bound,
        millis(best));
  }

  /** The best of one set of sites for some seeds. */
  private String seeds(Path file) throws IOException, InterruptedException {
    StringBuilder out = new StringBuilder("| seed | odd, best found | ms |\n|---|---|---|\n");
    for (int seed = 0; seed < SEEDS; seed++) {
      JsonObject best = best(file, "points", seed);
      out.append(cells(seed, best.get("odd"), millis(best)));
    }
    return out.toString();
  }

  private JsonObject best(Path file, String kind, int seed)
      throws IOException, InterruptedException {
    return json(
        triangulate(
            file,
            kind,
            List.of(
                "--optimize",
                "even",
                "--prefer",
                "none",
                "--time-limit",
                seconds,
                "--seed",
                seed + "")));
  }

  private String triangulate(Path file, String kind, List<String> options)
      throws IOException, InterruptedException {
    List<String> words = new ArrayList<>(List.of("triangulate", file.toString(), "--as", kind));
    words.addAll(options);
    words.add("--json");
    return program.run(words);
  }

  private static JsonObject json(String text) {
    return JsonParser.parseString(text).getAsJsonObject();
  }

  private static long millis(JsonObject summary) {
    return Math.round(summary.getAsJsonObject("millis").get("post").getAsDouble());
  }

  private static String cells(Object... cells) {
    StringBuilder out = new StringBuilder("|");
    for (Object cell : cells) {
      out.append(' ').append(cell).append(" |");
    }
    return out.append('\n').toString();
  }
}
