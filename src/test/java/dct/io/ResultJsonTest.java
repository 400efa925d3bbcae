package dct.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.degree.FlipResult;
import dct.core.degree.LocalBound;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.io.text.BadInputException;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import dct.problem.verify.Claims;
import dct.problem.verify.Restoration;
import dct.problem.verify.Verdict.Outcome;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ResultJsonTest {
  private static final Points SQUARE = Points.ofPairs(0, 0, 10, 0, 10, 0.5, 0, 1e30);
  private static final Optional<ResultJson.Millis> MILLIS =
      Optional.of(new ResultJson.Millis(3.14, 1.96, 0));

  private static Solution square() {
    Instance square = Instance.of(Domain.POLYGON, "a \"b\".txt", SQUARE, Progress.NONE);
    return Solution.of(square, Method.MONOTONE, triangulation(0));
  }

  /** The square cut from vertex v to the one opposite. */
  private static Triangulation triangulation(int v) {
    Dcel dcel = Dcel.cycle(0, 1, 2, 3);
    dcel.splitFace(dcel.outEdge(v), dcel.outEdge(v + 2));
    return new Triangulation(Domain.POLYGON, SQUARE, dcel, edge -> EdgeKind.FLIPPED);
  }

  private static Claims read(String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    return ResultJson.read("in.json", new ByteArrayInputStream(bytes));
  }

  @Test
  void the_summary_has_the_fields_of_the_contract_in_order() {
    assertThat(ResultJson.summary(square(), MILLIS))
        .isEqualTo(
            "{\"input\": \"a \\\"b\\\".txt\", \"kind\": \"polygon\", \"algorithm\": \"monotone\","
                + " \"post\": \"none\", \"vertices\": 4, \"edges\": 5, \"triangles\": 2,"
                + " \"boundary\": 4, \"even\": 2, \"odd\": 2, \"oddLowerBound\": 2,"
                + " \"optimal\": true, \"merged\": 0,"
                + " \"millis\": {\"read\": 3.1, \"triangulate\": 2, \"post\": 0}}");
  }

  @Test
  void flips_add_their_fields() {
    Solution flipped =
        square().flipped(new FlipResult(triangulation(1), triangulation(0), List.of(4)));
    JsonObject json = JsonParser.parseString(ResultJson.summary(flipped, MILLIS)).getAsJsonObject();
    assertThat(json.get("post").getAsString()).isEqualTo("flip");
    assertThat(json.get("evenBefore").getAsInt()).isEqualTo(2);
    assertThat(json.get("oddBefore").getAsInt()).isEqualTo(2);
    assertThat(json.get("flips").getAsInt()).isEqualTo(1);
  }

  @Test
  void wishes_of_the_document_are_kept_beside_a_result_made_for_others(@TempDir Path folder)
      throws Exception {
    Points points = Points.ofPairs(0, 0, 10, 0, 10, 10, 0, 9);
    Instance instance = Instance.of(Domain.POLYGON, "a.txt", points, Progress.NONE);
    Solution solution =
        Solution.of(instance, Method.MONOTONE, Progress.NONE)
            .optimized(SearchLimits.DEFAULT, Progress.NONE);
    ParityGoal wishes = ParityGoal.of(Wish.EVEN, Wish.ODD, Wish.ANY, Wish.EVEN);
    Path file = folder.resolve("a.json");
    ResultJson.write(file, solution, wishes, Progress.NONE);
    PointDocument read = PointFile.read(file, Progress.NONE);
    assertThat(read.wishes()).contains(wishes);
    assertThat(read.verified(Progress.NONE).orElseThrow().outcome()).isEqualTo(Outcome.TRUE);
    Solution again = read.solution(Progress.NONE).orElseThrow();
    assertThat(again.instance().wishes()).isEqualTo(ParityGoal.allEven(4));
    assertThat(again.optimum().orElseThrow().bound())
        .isEqualTo(solution.optimum().orElseThrow().bound());
  }

  @Test
  void a_false_triangulation_is_refused_with_its_line(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("a.json");
    Points points = Points.ofPairs(0, 0, 10, 0, 10, 10, 0, 9);
    Instance instance = Instance.of(Domain.POLYGON, "a.txt", points, Progress.NONE);
    Solution solution = Solution.of(instance, Method.MONOTONE, Progress.NONE);
    ResultJson.write(file, solution, ParityGoal.allEven(4), Progress.NONE);
    Files.writeString(file, Files.readString(file).replace("\"even\": 2", "\"even\": 3"));
    PointDocument read = PointFile.read(file, Progress.NONE);
    assertThatThrownBy(() -> read.verified(Progress.NONE))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("the field \"even\"");
  }

  @Test
  void the_whole_result_lists_points_and_edges() throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ResultJson.write(out, square(), MILLIS);
    String text = out.toString(StandardCharsets.UTF_8);
    JsonObject json = JsonParser.parseString(text).getAsJsonObject();
    JsonArray points = json.getAsJsonArray("points");
    assertThat(points).hasSize(4);
    assertThat(points.get(3)).hasToString("[0,1e30]");
    assertThat(json.getAsJsonArray("edgeList")).hasSize(5);
    assertThat(text).contains("\n[10, 0.5],\n").contains(", \"flipped\"]").endsWith("]}\n");
    assertThat(json.get("odd").getAsInt()).isEqualTo(2);
    assertThat(json.get("format").getAsString()).isEqualTo("dct-result/1");
  }

  @Test
  void reads_back_what_it_writes(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("result.json");
    Triangulation written = square().triangulation();
    ResultJson.write(file, square(), MILLIS, Progress.NONE);
    Claims stored = ResultJson.read(file, Progress.NONE);
    assertThat(stored.points()).isEqualTo(SQUARE);
    assertThat(stored.domain()).contains(Domain.POLYGON);
    assertThat(stored.text("algorithm")).contains("monotone");
    assertThat(stored.whole("odd")).hasValue(2);
    assertThat(stored.whole("algorithm")).isEmpty();
    assertThat(stored.flag("optimal")).contains(true);
    assertThat(stored.edges().size()).isEqualTo(5);
    assertThat(stored.edges().from(0)).isEqualTo(written.from(0));
    assertThat(stored.edges().to(0)).isEqualTo(written.to(0));
    assertThat(stored.edges().kind(0)).isEqualTo(EdgeKind.BOUNDARY);
    assertThat(stored.edges().line(0)).isEqualTo(6);
    assertThat(PointFile.read(file, Progress.NONE).points()).isEqualTo(SQUARE);
    assertThat(PointFile.read(file, Progress.NONE).declared()).contains(Domain.POLYGON);
  }

  @Test
  void the_windows_of_a_bound_come_back() {
    Points points = Points.ofPairs(0, 0, 10, 0, 10, 9, 0, 8);
    Instance sites = Instance.of(Domain.SITES, "four.txt", points, Progress.NONE);
    Triangulation delaunay = Solution.of(sites, Method.DELAUNAY, Progress.NONE).triangulation();
    BitSet two = new BitSet();
    two.set(1, 3);
    LowerBound bound = new LowerBound(2, "windows", List.of(new LocalBound(two, 1)));
    Solution solution =
        Solution.of(sites, Method.DELAUNAY, delaunay)
            .optimized(Optimum.of(delaunay, ParityGoal.allEven(4), bound), SearchLimits.DEFAULT);
    Claims claims = ResultJson.claims(solution);
    assertThat(Restoration.of(claims, Progress.NONE).bound()).isEqualTo(bound);
  }

  @Test
  void points_alone_come_back_with_their_kind_and_lines(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("points.json");
    ResultJson.write(file, PointDocument.of("x", Domain.SITES, SQUARE), Progress.NONE);
    assertThat(file)
        .hasContent(
            "{\"kind\": \"points\", \"points\": [\n[0, 0],\n[10, 0],\n[10, 0.5],\n[0, 1e30]]}");
    PointDocument document = PointFile.read(file, Progress.NONE);
    assertThat(document.points()).isEqualTo(SQUARE);
    assertThat(document.declared()).contains(Domain.SITES);
    assertThat(document.line(2)).isEqualTo(4);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{\"points\": [[0, 0], [1, 0], [0, 1]]}",
        "\uFEFF\r\n {\"points\":\r\n[[0,0],[1.0,0e0],\r\n[0,1]], \"ä\": {\"x\": [1, null]}}\n",
      })
  void json_is_told_by_content(String text, @TempDir Path folder) throws IOException {
    Path file = Files.writeString(folder.resolve("points.txt"), text);
    assertThat(PointFile.read(file, Progress.NONE).points())
        .isEqualTo(Points.ofPairs(0, 0, 1, 0, 0, 1));
    assertThat(PointFile.read(file, Progress.NONE).declared()).isEmpty();
    assertThat(ResultJson.read(file, Progress.NONE).hasEdges()).isFalse();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "{} | 1: there is no field \"points\"; write \"points\": [[x, y], …]",
        "{\"kind\": 1, \"points\": []} | 1: \"kind\" is not a text;"
            + " write \"kind\": \"polygon\", \"points\" or \"region\"",
        "{\"kind\": \"dots\"} | 1: \"dots\" is not a kind of input;"
            + " write \"kind\": \"polygon\", \"points\" or \"region\"",
        "{\"points\": 3} | 1: \"points\" is not a list; write \"points\": [[x, y], …]",
        "{\"points\": [[0, 0],~[1, \"a\"]]} | 2: a point is not a pair of numbers, at points[1][1];"
            + " write \"points\": [[x, y], …]",
        "{\"points\": [[0, 0],~[1]]} | 2: a point is not a pair of numbers, at points[1][1];"
            + " write \"points\": [[x, y], …]",
        "{\"points\": [[0, 0, 0]]} | 1: a point is not a pair of numbers, at points[0][2];"
            + " write \"points\": [[x, y], …]",
        "{\"points\": [[0,~~1e400]]} | 3: 1e400 is too large, a number is at most 1.797e308;"
            + " scale the data",
        "{\"points\": [[NaN, 0]]} | 1: this is not JSON, at points[0][0]; correct it",
        "{\"points\": [[0x1, 0]]} | 1: this is not JSON, at points[0][0]; correct it",
        "{\"points\": [[0, 0],~[1, 0 | 2: the JSON text ends too early; restore the rest of the"
            + " file",
        "{\"points\": []}~{} | 2: something follows the JSON object; remove it",
        "{\"points\": [], \"points\": []} | 1: the field \"points\" is there twice; remove one",
        "{\"n\": 1,~\"n\": 1} | 2: the field \"n\" is there twice; remove one",
        "{\"points\": [],~\"edgeList\": [[0, 1]]} | 2: an edge is not of the known form,"
            + " at edgeList[0][2]; EDGE",
        "{\"points\": [],~\"edgeList\": [[0, 1, \"red\"]]} | 2: an edge is not of the known form,"
            + " at edgeList[0][3]; EDGE",
        "{\"points\": [],~\"edgeList\": [[0, 1.5, \"boundary\"]]} | 2: an edge is not of the known"
            + " form, at edgeList[0][1]; EDGE",
        "[[0, 0]] | 1: this is not a JSON object; write \"points\": [[x, y], …] inside { }",
      })
  void names_what_is_wrong(String text, String message) {
    String edge =
        "write [u, v, \"boundary\"], or \"diagonal\", \"partition\", \"flipped\", \"fixed\" as the third";
    assertThatThrownBy(() -> read(text.replace('~', '\n')))
        .isInstanceOf(BadInputException.class)
        .hasMessage("in.json:" + message.replace("EDGE", edge));
  }

  @Test
  void another_encoding_is_named() {
    byte[] latin1 = "{\"input\": \"ä\"}".getBytes(StandardCharsets.ISO_8859_1);
    assertThatThrownBy(() -> ResultJson.read("in.json", new ByteArrayInputStream(latin1)))
        .isInstanceOf(BadInputException.class)
        .hasMessage("in.json:1: the text is not UTF-8; save it as UTF-8");
  }

  @Test
  void a_deep_nest_is_refused_and_not_run_into() {
    assertThatThrownBy(() -> read("{\"x\": " + "[".repeat(100_000)))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("this is not JSON");
  }
}
