package dct.bench;

import dct.core.Progress;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.degree.best.BestTriangulation;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;

/**
 * The best even triangulation of every set of sites in a file, one row a set: its name, n, the odd
 * vertices, the bound and its reason, and the seconds; then how many are proven.
 *
 * <p>A line of the file is a name, n, and the coordinates x1 y1 x2 y2 …
 *
 * <pre>SetTable FILE [seconds for a set, 10 if absent] [seed, 1 if absent]</pre>
 */
public final class SetTable {
  private final PrintStream out;
  private final SearchLimits limits;
  private int sets;
  private int proven;

  private SetTable(PrintStream out, SearchLimits limits) {
    this.out = out;
    this.limits = limits;
  }

  /** Prints the table. */
  public static void main(String[] args) throws IOException {
    double seconds = args.length > 1 ? Double.parseDouble(args[1]) : 10;
    long seed = args.length > 2 ? Long.parseLong(args[2]) : 1;
    new SetTable(System.out, new SearchLimits(seed, 1, seconds)).run(Path.of(args[0]));
  }

  private void run(Path file) throws IOException {
    out.println("| set | n | odd | bound | proven | s | why |");
    out.println("|---|---|---|---|---|---|---|");
    Files.readAllLines(file).forEach(this::row);
    out.printf(Locale.ROOT, "%nProven: %d of %d.%n", proven, sets);
  }

  private void row(String line) {
    String[] words = line.split(" ");
    double[] pairs =
        Arrays.stream(words, 2, words.length).mapToDouble(Double::parseDouble).toArray();
    Sites sites = Sites.of(Points.ofPairs(pairs), Progress.NONE);
    ParityGoal goal = ParityGoal.allEven(sites.size());
    long start = System.nanoTime();
    Optimum best = BestTriangulation.of(sites, goal, limits, Progress.NONE);
    double taken = (System.nanoTime() - start) * 1e-9;
    sets++;
    proven += best.isProven() ? 1 : 0;
    out.printf(
        Locale.ROOT,
        "| %s | %d | %d | %d | %s | %.3f | %s |%n",
        words[0],
        sites.size(),
        best.unmet(),
        best.bound().value(),
        best.isProven() ? "yes" : "no",
        taken,
        best.bound().reason());
  }
}
