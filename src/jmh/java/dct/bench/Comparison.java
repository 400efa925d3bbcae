package dct.bench;

import dct.io.CannotWriteException;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;

/**
 * Prints the tables of docs/performance.md. Arguments: the parts wanted, of sites, polygons, steps
 * and program, or all of them; the largest n, as a number; files of polygons to compare on as well.
 */
public final class Comparison {
  private static final Set<String> PARTS = Set.of("sites", "polygons", "steps", "program");
  private static final int LARGEST = 1_000_000;

  private Comparison() {}

  public static void main(String[] args) throws IOException, CannotWriteException {
    Locale.setDefault(Locale.ROOT);
    Set<String> parts = new TreeSet<>();
    List<Path> files = new ArrayList<>();
    int largest = LARGEST;
    for (String argument : args) {
      if (PARTS.contains(argument)) {
        parts.add(argument);
      } else if (argument.matches("\\d+")) {
        largest = Integer.parseInt(argument);
      } else {
        files.add(Path.of(argument));
      }
    }
    print(parts.isEmpty() ? PARTS : parts, largest, files);
  }

  private static void print(Set<String> parts, int largest, List<Path> files)
      throws IOException, CannotWriteException {
    PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    machine(out);
    if (parts.contains("sites")) {
      new SiteComparison(out, largest).run();
    }
    if (parts.contains("polygons")) {
      new PolygonComparison(out, largest, files).run();
    }
    if (parts.contains("steps")) {
      new StepTable(out, largest).run();
    }
    if (parts.contains("program")) {
      new ProgramTable(out).run();
    }
  }

  private static void machine(PrintStream out) {
    out.printf(
        "%d cores, %s %s, %s, heap of %d MB.%n%n",
        Runtime.getRuntime().availableProcessors(),
        System.getProperty("java.vm.name"),
        System.getProperty("java.version"),
        System.getProperty("os.name") + " " + System.getProperty("os.arch"),
        Runtime.getRuntime().maxMemory() >> 20);
  }
}
