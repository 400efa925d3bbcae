package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.triangulate.Domain;
import dct.experiment.generate.PolygonShape;
import dct.experiment.generate.RandomSites;
import dct.experiment.generate.SiteShape;
import dct.io.PointDocument;
import dct.io.PointFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** The verbs generate, convert and check. */
class PointCommandsTest {
  @TempDir Path folder;

  @Test
  void generate_writes_the_seeded_sites() {
    Path file = folder.resolve("x_pointbased.txt");
    Path json = folder.resolve("x.json");
    CliRun run =
        CliRun.of("generate", "points", "-n", 50, "--seed", 7, "-o", file, "-o", json).done();
    assertThat(run.out()).isEmpty();
    for (Path written : new Path[] {file, json}) {
      PointDocument document = PointFile.read(written, Progress.NONE);
      assertThat(document.points()).isEqualTo(RandomSites.uniform(50, 7));
      assertThat(document.declared()).contains(Domain.SITES);
    }
  }

  @Test
  void generate_prints_text_that_the_other_verbs_take() {
    CliRun run = CliRun.of("generate", "points", "-n", 30, "--shape", "uniform").done();
    assertThat(run.out().lines()).hasSize(31).startsWith("# kind: points");
    assertThat(CliRun.of("generate", "points", "-n", 30, "--seed", 1, "-o", "-")).isEqualTo(run);
    assertThat(CliRun.of("generate", "points", "-n", 30, "--seed", -1)).isNotEqualTo(run);
    assertThat(CliRun.withInput(run.out(), "check", "-").done().out())
        .isEqualTo("-: 30 usable sites\n");
    assertThat(CliRun.withInput(run.out(), "triangulate", "-", "--quiet").done().out()).isEmpty();
  }

  @Test
  void generate_makes_polygons_of_every_shape() {
    for (PolygonShape shape : PolygonShape.values()) {
      CliRun run =
          CliRun.of("generate", "polygon", "-n", 40, "--shape", shape.word(), "--seed", 3).done();
      assertThat(run.out().lines()).hasSize(41).startsWith("# kind: polygon");
      assertThat(CliRun.withInput(run.out(), "check", "-").done().out())
          .isEqualTo("-: a simple polygon with 40 vertices, counter-clockwise\n");
      assertThat(CliRun.of("generate", "--help").done().out()).contains("  " + shape.word() + " ");
    }
    for (SiteShape shape : SiteShape.values()) {
      CliRun run = CliRun.of("generate", "points", "-n", 40, "--shape", shape.word()).done();
      assertThat(CliRun.withInput(run.out(), "check", "-").done().out())
          .isEqualTo("-: 40 usable sites\n");
      assertThat(CliRun.of("generate", "--help").done().out()).contains("  " + shape.word() + " ");
    }
  }

  @Test
  void generate_stays_in_the_area_and_leaves_the_whole_numbers_when_asked() {
    CliRun whole = CliRun.of("generate", "polygon", "-n", 9, "--area", "3x3").done();
    assertThat(whole.out().lines().skip(1))
        .hasSize(9)
        .allMatch(line -> line.matches("[012] [012]"));
    CliRun real = CliRun.of("generate", "points", "-n", 9, "--area", "3x3", "--real").done();
    assertThat(real.out().lines().skip(1))
        .allMatch(line -> line.matches("[012]\\.\\d+ [012]\\.\\d+"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "polygon -n 2 | the number of vertices of a random polygon is from 3 to 10000000; 2 is not",
        "polygon -n 5 --shape ring | --shape ring is unknown, use two-opt, steady-growth,",
        "polygon -n 5 --shape orthogonal | an orthogonal polygon has an even number of vertices",
        "polygon -n 5 --area 9x1 | all places of the area lie on one line; take an area of two",
        "polygon -n 5 --area 2x2 | 5 points do not fit into 4 places; take a larger area or fewer",
        "polygon -n 5 --area wide | --area wide is not a width and a height such as 1000x700",
        "points -n 5 --area 0x9 | an area of 0 × 9 cannot be; its sides are from 1 to 67108864",
      })
  void generate_says_why_something_cannot_be_made(String words, String sentence) {
    CliRun run = CliRun.of((Object[]) ("generate " + words).split(" ", -1));
    assertThat(run.err()).startsWith("dct generate: " + sentence).hasLineCount(1);
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.out()).isEmpty();
  }

  @Test
  void convert_goes_there_and_back() throws IOException {
    String text = "0 0\n4.5 0.25\n-1e-9 3\n";
    Path file = Files.writeString(folder.resolve("x_polygonbased.txt"), text);
    Path json = folder.resolve("x.json");
    Path back = folder.resolve("y_polygonbased.txt");
    CliRun.of("convert", file, "-o", json).done();
    assertThat(json)
        .hasContent("{\"kind\": \"polygon\", \"points\": [\n[0, 0],\n[4.5, 0.25],\n[-1e-9, 3]]}");
    CliRun.of("convert", json, "-o", back).done();
    assertThat(back).hasContent(text);
    assertThat(CliRun.of("convert", json, "-o", "-").done().out())
        .isEqualTo("# kind: polygon\n" + text);
    assertThat(CliRun.of("convert", json, "--as", "points", "-o", "-").done().out())
        .isEqualTo("# kind: points\n" + text);
  }

  @Test
  void convert_writes_the_format_asked_for_whatever_the_ending() throws IOException {
    Path file = folder.resolve("x.data");
    CliRun.withInput("0 0\n4 0\n0 4", "convert", "-", "-o", file, "-o", "-", "--to", "wkt");
    assertThat(file).hasContent("POLYGON ((0 0, 4 0, 0 4, 0 0))");
    for (String format : List.of("txt", "wkt", "geojson", "node", "poly", "off", "obj", "json")) {
      CliRun run = CliRun.of("convert", file, "-o", "-", "--to", format).done();
      CliRun back = CliRun.withInput(run.out(), "convert", "-", "-o", "-").done();
      assertThat(back.out()).as(format).endsWith("0 0\n4 0\n0 4\n");
    }
    assertThat(CliRun.of("convert", file, "-o", "-", "--to", "svg").done().out())
        .startsWith("<?xml");
    assertThat(CliRun.of("convert", file, "-o", "-", "--to", "png").done().out()).contains("PNG");
  }

  @Test
  void convert_to_a_stream_keeps_the_triangulation_or_says_that_there_is_none() {
    String square = "0 0\n4 0\n4 4\n0 4";
    CliRun result = CliRun.withInput(square, "triangulate", "-", "-o", "-").done();
    CliRun off = CliRun.withInput(result.out(), "convert", "-", "-o", "-", "--to", "off").done();
    assertThat(off.out()).startsWith("OFF\n4 2 0\n");
    CliRun json = CliRun.withInput(off.out(), "convert", "-", "-o", "-", "--to", "json").done();
    assertThat(json.out()).contains("edgeList");
    CliRun none = CliRun.withInput(square, "convert", "-", "-o", "-", "--to", "ele");
    assertThat(none.status()).isEqualTo(1);
    assertThat(none.err()).contains("-: it holds a triangulation, and there is none");
    assertThat(none.out()).isEmpty();
  }

  @Test
  void convert_takes_points_that_are_no_polygon_and_adds_no_kind() {
    CliRun run = CliRun.withInput("0;0\n4;4\n4;0\n0;4", "convert", "-", "-o", "-").done();
    assertThat(run.out()).isEqualTo("0 0\n4 4\n4 0\n0 4\n");
    Path json = folder.resolve("x.json");
    CliRun.withInput(run.out(), "convert", "-", "-o", json).done();
    assertThat(json).hasContent("{\"points\": [\n[0, 0],\n[4, 4],\n[4, 0],\n[0, 4]]}");
  }

  @Test
  void convert_says_that_text_holds_the_points_of_a_result_alone() {
    Path result = folder.resolve("result.json");
    CliRun.withInput("0 0\n4 0\n0 4", "triangulate", "-", "-o", result).done();
    CliRun run = CliRun.of("convert", result, "-o", "-");
    assertThat(run.status()).isZero();
    assertThat(run.out()).isEqualTo("# kind: polygon\n0 0\n4 0\n0 4\n");
    assertThat(run.err())
        .isEqualTo("-: holds the points alone; the triangulation is left out, use .json\n");
  }

  static List<List<String>> waysToMakeAResult() {
    return List.of(
        List.of(),
        List.of("--flip"),
        List.of("--algorithm", "convex-even", "--flip"),
        List.of("--optimize", "odd"),
        List.of("--as", "points"),
        List.of("--as", "points", "--flip"),
        List.of("--as", "points", "--optimize", "even"),
        List.of("--as", "points", "--optimize", "odd"));
  }

  @ParameterizedTest
  @MethodSource("waysToMakeAResult")
  void convert_draws_a_result_as_triangulate_does(List<String> options) throws IOException {
    String points = "0 0\n9 1\n20 0\n19 8\n20 20\n11 17\n0 20\n3 9\n";
    Path result = folder.resolve("result.json");
    List<Object> words = new ArrayList<>(List.of("triangulate", "-", "-o", result));
    List<String> names = List.of("a.svg", "a.tex", "a.ipe", "a.off");
    names.forEach(name -> words.addAll(List.of("-o", folder.resolve(name))));
    words.addAll(options);
    CliRun.withInput(points, words.toArray()).done();
    for (String name : names) {
      Path converted = folder.resolve("converted-" + name);
      CliRun.of("convert", result, "-o", converted).done();
      assertThat(triangles(converted)).isEqualTo(triangles(folder.resolve(name)));
    }
    Path again = folder.resolve("again.json");
    CliRun.of("convert", result, "-o", again).done();
    String millis = "\"millis\": \\{[^}]*}, "; // takes another time
    assertThat(again).hasContent(Files.readString(result).replaceFirst(millis, ""));
  }

  /** The lines of a file; triangles of an OFF file sorted, each from its least corner on. */
  private static List<String> triangles(Path file) throws IOException {
    List<String> lines = Files.readAllLines(file);
    return file.toString().endsWith(".off")
        ? lines.stream().map(PointCommandsTest::fromLeastCorner).sorted().toList()
        : lines;
  }

  private static String fromLeastCorner(String line) {
    List<String> words = new ArrayList<>(List.of(line.split(" ")));
    if (words.size() == 4) {
      int least =
          words.lastIndexOf(
              Collections.min(words.subList(1, 4), Comparator.comparing(Integer::valueOf)));
      Collections.rotate(words.subList(1, 4), 1 - least);
    }
    return String.join(" ", words);
  }

  @Test
  void a_result_that_is_no_triangulation_is_not_converted() throws IOException {
    Path result = folder.resolve("result.json");
    CliRun.withInput("0 0\n4 0\n4 4\n0 4", "triangulate", "-", "-o", result).done();
    Files.writeString(
        result,
        Files.readString(result)
            .replaceFirst("\\[\\d, \\d, \"diagonal\"]", "[0, 1, \"diagonal\"]"));
    CliRun run = CliRun.of("convert", result, "-o", folder.resolve("a.svg"));
    assertThat(run.status()).isEqualTo(3);
    assertThat(run.err()).contains("lies on another edge; make the result again from its input");
    assertThat(folder.resolve("a.svg")).doesNotExist();
  }

  @Test
  void convert_draws() throws IOException {
    for (String kind : new String[] {"polygon", "points"}) {
      Path png = folder.resolve(kind + ".png");
      CliRun.withInput("0 0\n4 0\n0 4", "convert", "-", "--as", kind, "-o", png).done();
      assertThat(ImageIO.read(png.toFile()).getWidth()).as("84 mm at 300 dpi").isEqualTo(992);
    }
  }

  @Test
  void check_says_what_was_found() {
    assertThat(CliRun.withInput("0 0\n4 0\n0 4", "check", "-").done().out())
        .isEqualTo("-: a simple polygon with 3 vertices, counter-clockwise\n");
    assertThat(CliRun.withInput("0 0\n0 4\n4 0", "check", "-").done().out())
        .isEqualTo("-: a simple polygon with 3 vertices, clockwise\n");
    assertThat(
            CliRun.withInput("0 0\n4 0\n0 4\n0 0\n4 0", "check", "-", "--as", "points")
                .done()
                .out())
        .isEqualTo("-: 3 usable sites (2 duplicates merged)\n");
    assertThat(CliRun.withInput("0 0\n4 0\n0 4", "check", "-", "--quiet").done().out()).isEmpty();
  }

  @Test
  void a_ring_that_meets_itself_is_split_or_parted_if_that_is_asked_for() {
    String tied = "0 0\n300 0\n300 300\n0 300\n0 0\n100 100\n100 200\n200 200\n200 100\n100 100\n";
    assertThat(CliRun.withInput(tied, "check", "-").err())
        .contains("v0 and v4 are both at (0, 0)")
        .contains("--touching");
    CliRun parted = CliRun.withInput(tied, "check", "-", "--touching", "hair");
    assertThat(parted.out()).contains("a simple polygon with 10 vertices");
    assertThat(parted.err())
        .isEqualTo("-: Vertices where the ring meets itself are moved a hair\n");
    assertThat(CliRun.withInput(tied, "convert", "-", "--list", "--touching", "split").done().out())
        .isEqualTo("1: 4 points\n2: 4 points\n");
    CliRun hole = CliRun.withInput(tied, "check", "-", "--touching", "split", "--pick", "2");
    assertThat(hole.out()).contains("4 vertices, clockwise");
    assertThat(hole.err()).contains("A ring meets itself and is split into 2");
    assertThat(CliRun.withInput(tied, "check", "-", "--touching", "cut").err())
        .contains("--touching");
  }

  @Test
  void shapes_are_listed_picked_and_read_as_sites() {
    Path rings = Path.of("src/test/resources/cases/two_rings.txt");
    assertThat(CliRun.of("convert", rings, "--list").done().out())
        .isEqualTo("1: 3 points\n2: 5 points\n");
    assertThat(CliRun.of("check", rings, "--pick", "2").done().out()).contains("5 vertices");
    assertThat(CliRun.of("check", rings, "--pick", "3").status()).isEqualTo(3);
    assertThat(CliRun.of("check", rings, "--pick", "3").err())
        .isEqualTo(
            rings + ": there are only 2 shapes, none with the number 3; pick one from 1 to 2\n");
    assertThat(CliRun.of("check", rings, "--as", "points").done().out()).contains("usable sites");
    CliRun none = CliRun.of("convert", rings);
    assertThat(none.status()).isEqualTo(2);
    assertThat(none.err()).contains("-o OUTPUT is missing");
  }

  @Test
  void columns_and_lines_to_skip_are_named() {
    Path three = Path.of("src/test/resources/cases/three_whole_columns.txt");
    assertThat(CliRun.of("check", three, "--columns", "2,3").done().out()).contains("4 vertices");
    assertThat(CliRun.of("check", three, "--columns", "2,3", "--skip", "1").done().out())
        .contains("3 vertices");
    assertThat(CliRun.of("check", three, "--columns", "2").status()).isEqualTo(2);
    assertThat(CliRun.of("check", three, "--skip", "-1").status()).isEqualTo(2);
  }
}
