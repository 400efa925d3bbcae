package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class TriangulateCommandTest {
  private static final String HEXAGON = "2 0\n4 0\n6 2\n4 4\n2 4\n0 2\n";
  private static final String SITES = "0 0\n10 0\n10 10\n0 10\n5 5\n5 5\n3 4\n";

  @TempDir Path folder;

  private static JsonObject json(String text) {
    return JsonParser.parseString(text).getAsJsonObject();
  }

  private static JsonObject summary(String input, Object... options) {
    Object[] words = new Object[options.length + 3];
    words[0] = "triangulate";
    words[1] = "-";
    words[2] = "--json";
    System.arraycopy(options, 0, words, 3, options.length);
    CliRun run = CliRun.withInput(input, words).done();
    assertThat(run.out()).as("one line").matches("\\{[^\n]*}\n");
    return json(run.out());
  }

  @Test
  void the_summary_of_a_polygon_is_the_contract() {
    JsonObject json = summary(HEXAGON);
    assertThat(json.keySet())
        .containsExactly(
            "input",
            "kind",
            "algorithm",
            "post",
            "vertices",
            "edges",
            "triangles",
            "boundary",
            "even",
            "odd",
            "oddLowerBound",
            "optimal",
            "merged",
            "millis");
    assertThat(json.getAsJsonObject("millis").keySet())
        .containsExactly("read", "triangulate", "post");
    assertThat(json.get("input").getAsString()).isEqualTo("-");
    assertThat(json.get("kind").getAsString()).isEqualTo("polygon");
    assertThat(json.get("algorithm").getAsString()).isEqualTo("monotone");
    assertThat(json.get("post").getAsString()).isEqualTo("none");
    assertThat(json.get("vertices").getAsInt()).isEqualTo(6);
    assertThat(json.get("edges").getAsInt()).isEqualTo(9);
    assertThat(json.get("triangles").getAsInt()).isEqualTo(4);
    assertThat(json.get("boundary").getAsInt()).isEqualTo(6);
    assertThat(json.get("even").getAsInt() + json.get("odd").getAsInt()).isEqualTo(6);
    assertThat(json.get("oddLowerBound").getAsInt()).isZero();
    assertThat(json.get("optimal").getAsBoolean()).isEqualTo(json.get("odd").getAsInt() == 0);
    assertThat(json.get("merged").getAsInt()).isZero();
  }

  @Test
  void the_summary_of_sites_after_flips_is_the_contract() {
    JsonObject json = summary(SITES, "--as", "points", "--flip");
    assertThat(json.keySet())
        .containsExactly(
            "input",
            "kind",
            "algorithm",
            "post",
            "vertices",
            "edges",
            "triangles",
            "boundary",
            "even",
            "odd",
            "evenBefore",
            "oddBefore",
            "flips",
            "oddLowerBound",
            "optimal",
            "merged",
            "millis");
    assertThat(json.get("kind").getAsString()).isEqualTo("points");
    assertThat(json.get("algorithm").getAsString()).isEqualTo("delaunay");
    assertThat(json.get("post").getAsString()).isEqualTo("flip");
    assertThat(json.get("vertices").getAsInt()).isEqualTo(6);
    assertThat(json.get("boundary").getAsInt()).isEqualTo(4);
    assertThat(json.get("merged").getAsInt()).isEqualTo(1);
    assertThat(json.get("oddLowerBound").getAsInt()).isEqualTo(2);
    int gain = json.get("even").getAsInt() - json.get("evenBefore").getAsInt();
    int flips = json.get("flips").getAsInt();
    assertThat(gain).isBetween(2 * flips, 4 * flips);
  }

  @Test
  void a_result_is_optimal_exactly_where_it_attains_the_bound() {
    assertThat(summary(HEXAGON, "--algorithm", "convex-even").get("odd").getAsInt())
        .as("Lemma 3.2 leaves no odd vertex where n is 3k")
        .isZero();
    assertThat(summary(HEXAGON, "--algorithm", "convex-even").get("optimal").getAsBoolean())
        .isTrue();
    assertThat(summary(HEXAGON, "--algorithm", "convex-odd").get("optimal").getAsBoolean())
        .isFalse();
  }

  @ParameterizedTest
  @ValueSource(strings = {"ear-clipping", "monotone", "convex-even", "convex-odd"})
  void every_algorithm_gives_a_result_that_can_be_verified(String algorithm) {
    for (String flip : new String[] {"--algorithm", "--flip"}) {
      Object[] words = {"triangulate", "-", "-o", "-", "--algorithm", algorithm};
      Object[] flipped = {"triangulate", "-", "-o", "-", "--algorithm", algorithm, "--flip"};
      CliRun run = CliRun.withInput(HEXAGON, flip.equals("--flip") ? flipped : words).done();
      assertThat(json(run.out()).get("algorithm").getAsString()).isEqualTo(algorithm);
      CliRun.withInput(run.out(), "verify", "-").done();
    }
  }

  @Test
  void the_summary_for_people_tells_the_same() throws IOException {
    Path file = Files.writeString(folder.resolve("square.txt"), "0 0\n9 0\n9 9\n0 9\n");
    assertThat(CliRun.of("triangulate", file).done().out())
        .isEqualTo(
            """
            %s: 4 vertices, monotone: 5 edges, 2 triangles
            2 even, 2 odd; no triangulation has fewer odd vertices
            """
                .formatted(file));
    assertThat(CliRun.withInput(SITES, "triangulate", "-", "--as", "points", "--flip").out())
        .matches(
            """
            -: 6 sites \\(1 duplicate merged\\), delaunay: 11 edges, 6 triangles
            before: \\d even, \\d odd
            after \\d flips?: \\d even, \\d odd; [^\n]*odd vertices
            """);
  }

  @Test
  void quiet_prints_nothing_and_json_alone_prints_the_summary() {
    assertThat(CliRun.withInput(HEXAGON, "triangulate", "-", "--quiet").done().out()).isEmpty();
    assertThat(summary(HEXAGON, "--quiet").get("vertices").getAsInt()).isEqualTo(6);
  }

  @Test
  void writes_every_output_in_the_format_of_its_ending() throws IOException {
    Path file = Files.writeString(folder.resolve("hexagon_polygonbased.txt"), HEXAGON);
    Path txt = folder.resolve("again_polygonbased.txt");
    Path json = folder.resolve("result.json");
    Path png = folder.resolve("picture.PNG");
    Path svg = folder.resolve("picture.svg");
    CliRun run =
        CliRun.of(
                "triangulate",
                file,
                "--flip",
                "-o",
                txt,
                "-o",
                json,
                "-o",
                png,
                "--output",
                svg,
                "--json")
            .done();
    assertThat(txt).hasContent(HEXAGON);
    JsonObject whole = json(Files.readString(json));
    assertThat(whole.getAsJsonArray("points")).hasSize(6);
    assertThat(whole.getAsJsonArray("edgeList")).hasSize(9);
    List.of("format", "version", "points", "edgeList", "flipList").forEach(whole::remove);
    assertThat(whole).isEqualTo(json(run.out()));
    assertThat(ImageIO.read(png.toFile()).getWidth()).isEqualTo(992);
    assertThat(svg).content().contains("<svg");
  }

  @Test
  void a_failed_run_writes_nothing() throws IOException {
    Path out = folder.resolve("result.json");
    CliRun run = CliRun.withInput("0 0\n1 1\n1 0\n0 1\n", "triangulate", "-", "-o", out);
    assertThat(run.status()).isEqualTo(3);
    assertThat(Files.exists(out)).isFalse();
    Path wrong = folder.resolve("x.nix");
    assertThat(CliRun.withInput(HEXAGON, "triangulate", "-", "-o", out, "-o", wrong).status())
        .isEqualTo(2);
    assertThat(Files.exists(out)).isFalse();
  }

  @ParameterizedTest
  @CsvSource({
    "x_polygonbased.txt, '', '', polygon",
    "x_pointbased.txt, '', '', points",
    "x_pointbased.txt, '', polygon, polygon",
    "x_polygonbased.txt, '', points, points",
    "x_polygonbased.txt, # kind: points, '', polygon",
    "x.txt, # kind: points, '', points",
    "x.txt, # kind: points, polygon, polygon",
    "x.txt, '', '', polygon",
    "x.txt, '', points, points",
  })
  void the_kind_is_as_asked_or_named_or_told_inside(
      String name, String comment, String as, String kind) throws IOException {
    Path file = Files.writeString(folder.resolve(name), comment + "\n" + HEXAGON);
    Object[] words =
        as.isEmpty()
            ? new Object[] {"triangulate", file, "--json"}
            : new Object[] {"triangulate", file, "--json", "--as", as};
    assertThat(json(CliRun.of(words).done().out()).get("kind").getAsString()).isEqualTo(kind);
  }

  @Test
  void the_extension_may_be_left_out() throws IOException {
    Files.writeString(folder.resolve("x_pointbased.txt"), HEXAGON);
    for (String name : List.of("x", "x_pointbased", "x_pointbased.txt")) {
      Path typed = folder.resolve(name);
      JsonObject json = json(CliRun.of("triangulate", typed, "--json").done().out());
      assertThat(json.get("kind").getAsString()).isEqualTo("points");
      assertThat(json.get("input").getAsString()).isEqualTo(typed.toString());
    }
  }

  @Test
  void a_result_is_an_input_again() {
    CliRun first = CliRun.withInput(SITES, "triangulate", "-", "--as", "points", "-o", "-").done();
    assertThat(summary(first.out()).get("kind").getAsString()).isEqualTo("points");
    assertThat(summary(first.out()).get("vertices").getAsInt()).isEqualTo(6);
  }

  @Test
  void an_output_named_as_the_other_kind_is_refused_before_anything_is_written()
      throws IOException {
    Path out = folder.resolve("x_pointbased.txt");
    Path good = folder.resolve("y.json");
    CliRun run = CliRun.withInput(HEXAGON, "triangulate", "-", "-o", good, "-o", out);
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).contains("would be read as points", "name it " + folder, "_polygonbased");
    assertThat(folder).isEmptyDirectory();
    Path json = folder.resolve("z_POLYGONBASED.json");
    assertThat(CliRun.withInput(SITES, "triangulate", "-", "--as", "points", "-o", json).status())
        .isEqualTo(2);
    assertThat(CliRun.of("generate", "points", "-n", "9", "-o", json).status()).isEqualTo(2);
    assertThat(CliRun.withInput(HEXAGON, "convert", "-", "--as", "polygon", "-o", out).status())
        .isEqualTo(2);
    CliRun.withInput(HEXAGON, "convert", "-", "-o", out).done();
    CliRun.withInput(HEXAGON, "triangulate", "-", "-o", folder.resolve("p_pointbased.svg")).done();
  }
}
