package dct.docs;

import static org.assertj.core.api.Assertions.assertThat;

import dct.cli.CommandLineProgram;
import dct.cli.Console;
import dct.testing.ForeignDataTest;
import dct.testing.SharedData;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Rows of the tables of docs/optimum.md, computed again; the times aside. */
class OptimumTablesTest {
  @TempDir Path folder;

  private final OptimumTables tables = new OptimumTables(OptimumTablesTest::here, "60");

  private static String here(List<String> arguments) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    Console console =
        new Console(
            new ByteArrayInputStream(new byte[0]),
            out,
            new PrintStream(out, true, StandardCharsets.UTF_8));
    CommandLineProgram.run(console, arguments.toArray(String[]::new));
    return out.toString(StandardCharsets.UTF_8);
  }

  @Test
  void allLattices() throws IOException, InterruptedException {
    assertThat(withoutTimes(tables.lattices(folder, OptimumTables.LATTICES)))
        .isEqualTo(withoutTimes(page("lattices")));
  }

  @ForeignDataTest
  void smallSitesAndPolygons() throws IOException, InterruptedException {
    assertThat(withoutTimes(page("sites")))
        .containsAll(withoutTimes(tables.table(named("points", "j.*|de.*collinear"), "points")));
    assertThat(withoutTimes(page("polygons")))
        .containsAll(withoutTimes(tables.table(named("polygons", "glyph.*|p2t_d.*"), "polygon")));
  }

  private static List<Path> named(String kind, String pattern) {
    return SharedData.files(kind).stream()
        .filter(file -> file.getFileName().toString().matches("(" + pattern + ")\\.txt"))
        .toList();
  }

  private static String page(String part) throws IOException {
    return Page.read(Path.of("docs", "optimum.md")).part(part);
  }

  private static List<String> withoutTimes(String table) {
    return table.lines().map(line -> line.replaceFirst(" \\d+ \\|$", "")).toList();
  }
}
