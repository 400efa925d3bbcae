package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dct.io.FileLease;
import dct.testing.ProgramProcess;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ExperimentCommandTest {
  @TempDir Path folder;

  private static CliRun experiment(List<Object> first, Object... more) {
    return CliRun.of(
        Stream.of(Stream.of("experiment"), first.stream(), Arrays.stream(more))
            .flatMap(words -> words)
            .toArray());
  }

  private static CliRun points(Object... more) {
    return experiment(List.of("points", "--sizes", "10,30-50:20", "--sets", 3), more);
  }

  @Test
  void the_same_seed_gives_the_same_bytes_whatever_the_threads() {
    CliRun one = points("--seed", 5, "--threads", 1).done();
    assertThat(one.out()).contains("Table 4.4 again", "| Thesis: odd before |", "± ");
    assertThat(points("--seed", 5, "--threads", 4)).isEqualTo(one);
    assertThat(points("--seed", 6)).isNotEqualTo(one);
  }

  @Test
  void rows_and_tables_are_written() throws IOException {
    Path csv = folder.resolve("a.csv");
    Path md = folder.resolve("a.md");
    Path tex = folder.resolve("a.tex");
    CliRun run = points("-o", csv, "-o", md, "-o", tex).done();
    assertThat(md).hasContent(run.out());
    assertThat(tex).content().contains("\\toprule", "\\bottomrule");
    List<String> lines = Files.readAllLines(csv);
    assertThat(lines).hasSize(1 + 9);
    int columns = lines.get(0).split(",", -1).length;
    assertThat(lines).allMatch(line -> line.split(",", -1).length == columns);
    assertThat(points("-o", "-").done().out()).isEqualTo(Files.readString(csv));
  }

  @Test
  void a_row_can_be_made_again_from_its_seed() throws IOException {
    Path csv = folder.resolve("a.csv");
    points("-o", csv).done();
    for (String line : Files.readAllLines(csv).subList(1, 10)) {
      String[] cells = line.split(",", -1);
      String text =
          CliRun.of("generate", "points", "-n", cells[1], "--seed", cells[3]).done().out();
      String summary = CliRun.withInput(text, "triangulate", "-", "--flip", "--json").done().out();
      assertThat(summary)
          .contains("\"evenBefore\": " + cells[5] + ",", "\"even\": " + cells[6] + ",");
    }
  }

  private static CliRun polygons(Object... more) {
    return experiment(List.of("polygons", "--sizes", "12,100", "--sets", 3), more);
  }

  @Test
  void polygons_give_the_same_bytes_whatever_the_threads() {
    CliRun one = polygons("--threads", 1).done();
    assertThat(one.out())
        .contains("Share of even vertices of random polygons", "| two-opt ", " 3 of 3 |")
        .contains("Convex pieces for each vertex", "Reflex vertices for each vertex");
    assertThat(polygons("--threads", 3)).isEqualTo(one);
  }

  private static CliRun annuli(Object... more) {
    return experiment(List.of("annuli", "--sizes", "24,40", "--sets", 4), more);
  }

  @Test
  void annuli_give_the_same_bytes_whatever_the_threads() throws IOException {
    CliRun one = annuli("--threads", 1).done();
    assertThat(one.out())
        .contains("Share of even vertices of random regions", "| annulus ", "| courtyards ")
        .contains("Holes, and the share", "Rings whose length 3 does not divide, and the share");
    assertThat(annuli("--threads", 3)).isEqualTo(one);
    Path chart = folder.resolve("holes.svg");
    annuli("--quiet", "--chart", "holes", "-o", chart).done();
    assertThat(chart).content().contains("Even vertices and holes");
  }

  @Test
  void a_region_can_be_made_again_from_its_row() throws IOException {
    Path csv = folder.resolve("a.csv");
    annuli("-o", csv).done();
    List<String> rows = Files.readAllLines(csv);
    assertThat(rows).hasSize(1 + 24);
    for (String line : rows.subList(1, rows.size())) {
      String[] cells = line.split(",", -1);
      String text =
          CliRun.of(
                  "generate",
                  "region",
                  "--shape",
                  cells[0],
                  "-n",
                  cells[1],
                  "--holes",
                  cells[4],
                  "--seed",
                  cells[3])
              .done()
              .out();
      String summary =
          CliRun.withInput(text, "triangulate", "-", "--algorithm", "monotone", "--flip", "--json")
              .done()
              .out();
      assertThat(summary)
          .contains("\"evenBefore\": " + cells[8] + ",", "\"even\": " + cells[9] + ",");
      int missing = Integer.parseInt(cells[1]) - Integer.parseInt(cells[13]);
      assertThat(missing).as(line).isGreaterThanOrEqualTo(cells[5].equals("1") ? 2 : 0);
    }
  }

  @Test
  void real_polygons_are_studied_too() {
    Path file = Path.of("samples", "comb_polygonbased.txt");
    CliRun run = CliRun.of("experiment", "polygons", file, "--shapes", "none").done();
    assertThat(run.out()).contains("Share of even vertices of the given polygons", "| " + file);
    assertThat(CliRun.of("experiment", "polygons", file, "--shapes", "none", "-o", "-").out())
        .hasLineCount(2)
        .contains("\n" + file + ",40,1,0,");
    CliRun sites = CliRun.of("experiment", "polygons", "samples/random_50_pointbased.txt");
    assertThat(sites.status()).as(sites.err()).isEqualTo(3);
    CliRun missing = CliRun.of("experiment", "polygons", "missing.txt");
    assertThat(missing.status()).as(missing.err()).isEqualTo(3);
  }

  @Test
  void charts_are_drawn_in_every_format() throws IOException {
    Path csv = folder.resolve("a.csv");
    for (String chart : List.of("shapes", "sizes", "pieces", "reflex")) {
      for (String ending : List.of(".svg", ".png", ".pdf")) {
        Path file = folder.resolve(chart + ending);
        polygons("--quiet", "--chart", chart, "-o", csv, "-o", file).done();
        assertThat(Files.size(file)).as("%s", file).isGreaterThan(5000);
      }
    }
  }

  @Test
  void a_polygon_can_be_made_again_from_its_row() throws IOException {
    Path csv = folder.resolve("a.csv");
    CliRun.of("experiment", "polygons", "--sizes", 40, "--sets", 1, "-o", csv).done();
    List<String> lines = Files.readAllLines(csv);
    for (String line : lines.subList(1, lines.size())) {
      String[] cells = line.split(",", -1);
      String text =
          CliRun.of("generate", "polygon", "--shape", cells[0], "-n", 40, "--seed", cells[3])
              .done()
              .out();
      String summary =
          CliRun.withInput(text, "triangulate", "-", "--optimize", "even", "--json").done().out();
      assertThat(summary).as(line).contains("\"even\": " + cells[12] + ",", "\"optimal\": true");
    }
  }

  @Test
  void a_smaller_study_is_carried_on() throws IOException {
    Path grown = folder.resolve("grown.csv");
    Path whole = folder.resolve("whole.csv");
    CliRun.of("experiment", "points", "--sizes", "30", "--sets", 2, "-o", grown).done();
    List<String> before = Files.readAllLines(grown);
    points("-o", grown).done();
    points("-o", whole).done();
    assertThat(Files.readString(grown)).isEqualTo(Files.readString(whole)).contains(before);
  }

  @Test
  void times_are_kept_when_asked_for() throws IOException {
    Path csv = folder.resolve("a.csv");
    CliRun run = points("--times", "-o", csv).done();
    assertThat(run.out()).contains("Time of each step");
    assertThat(Files.readAllLines(csv).get(0))
        .endsWith("delaunay_ms,scan_flip_ms,repeated_ms,best_ms");
    CliRun mixed = points("-o", csv);
    assertThat(mixed.status()).isEqualTo(3);
    assertThat(mixed.err()).contains(csv + ":1: these are not the columns of this study");
  }

  @Test
  void a_run_that_is_interrupted_keeps_its_rows_and_goes_on() throws Exception {
    Path csv = folder.resolve("a.csv");
    String[] study = {
      "experiment", "points", "--sizes", "400,600", "--sets", "60", "--quiet", "-o", csv.toString()
    };
    Path err = folder.resolve("err.txt");
    Process process = start(err, study);
    while (process.isAlive() && (!Files.exists(csv) || lines(csv) < 5)) {
      TimeUnit.MILLISECONDS.sleep(5);
    }
    process.destroy(); // a polite request, as Ctrl+C is
    assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
    String said = Files.readString(err);
    int kept = lines(csv) - 1;
    assertThat(kept).as(said).isBetween(4, 119);
    assertThat(said).contains("stopped with " + kept + " of 120 rows; the same command goes on");
    List<String> rows = Files.readAllLines(csv);
    CliRun.of((Object[]) study).done();
    assertThat(Files.readAllLines(csv)).hasSize(121).doesNotHaveDuplicates().containsAll(rows);
  }

  private static int lines(Path file) throws IOException {
    return Files.readAllLines(file).size();
  }

  private static Process start(Path err, String... arguments) throws IOException {
    return ProgramProcess.of(List.of(), arguments)
        .redirectOutput(ProcessBuilder.Redirect.DISCARD)
        .redirectError(err.toFile())
        .start();
  }

  @Test
  void a_second_run_on_the_same_file_is_refused_and_changes_nothing() throws Exception {
    Path csv = folder.resolve("a.csv");
    String[] study = {
      "experiment", "points", "--sizes", "50", "--sets", "2", "--quiet", "-o", csv.toString()
    };
    Path err = folder.resolve("err.txt");
    try (Closeable first = FileLease.beside(csv)) {
      assertThat(first).isNotNull();
      assertThat(start(err, study).waitFor()).isEqualTo(1);
      assertThat(err)
          .hasContent(
              csv
                  + ": cannot be written, another run of the program is writing to it; nothing was"
                  + " changed, choose another place");
      assertThat(csv).doesNotExist();
    }
    assertThat(start(err, study).waitFor()).isZero();
    assertThat(lines(csv)).isEqualTo(3);
  }

  @Test
  void wrong_usage_is_said_in_one_sentence() {
    requireUsage("the study lines is unknown, use points, polygons or annuli", "lines");
    requireUsage("--sizes 2 is not from 3 to", "points", "--sizes", "2");
    requireUsage("--sizes 99999999999 is not from 3 to", "points", "--sizes", "99999999999");
    requireUsage("--sizes x is no number and no FROM-TO:STEP", "points", "--sizes", "10,x");
    requireUsage("--sizes  is no number and no FROM-TO:STEP", "points", "--sizes", "10,");
    requireUsage("--sizes 9-5:1 has no numbers in it", "points", "--sizes", "9-5:1");
    requireUsage("--sizes 5-9:0 has no numbers in it", "points", "--sizes", "5-9:0");
    requireUsage("--sets 0 is none, use 1 or more", "points", "--sets", "0");
    requireUsage("--shapes sphere is unknown, use uniform, disk", "points", "--shapes", "sphere");
    requireUsage("--shapes none is unknown", "polygons", "--shapes", "none");
    requireUsage("the study of points takes no files", "points", "a.txt");
    requireUsage("--chart x is unknown, use sizes, increase or shapes", "points", "--chart", "x");
    requireUsage("--threads 0 is not from 1 to 1024", "points", "--threads", "0");
    requireUsage("the ending of a.txt is no format of a study", "points", "-o", "a.txt");
    requireUsage("--seed one is not a whole number", "points", "--seed", "one");
  }

  private static void requireUsage(String sentence, Object... arguments) {
    Object[] all = new Object[arguments.length + 1];
    all[0] = "experiment";
    System.arraycopy(arguments, 0, all, 1, arguments.length);
    CliRun run = CliRun.of(all);
    assertThat(run.status()).as(run.err()).isEqualTo(2);
    assertThat(run.err())
        .contains(sentence)
        .endsWith("see dct experiment --help\n")
        .hasLineCount(1);
    assertThat(run.out()).isEmpty();
  }
}
