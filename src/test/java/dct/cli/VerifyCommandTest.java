package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.generate.RandomSites;
import dct.io.PointFile;
import dct.testing.RandomPolygons;
import dct.testing.RandomSets;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** True results pass; each lie is caught and named. */
class VerifyCommandTest {
  private static final String CURE = "; make the result again from its input";
  private static final String POLYGON = "0 0\n9 1\n20 0\n19 8\n20 20\n11 17\n0 20\n3 9\n";
  private static final String FLAT_SQUARE = "0 0\n10 0\n11 10\n0 9\n";

  private static String result(String points, Object... options) {
    Object[] words = new Object[options.length + 4];
    words[0] = "triangulate";
    words[1] = "-";
    words[2] = "-o";
    words[3] = "-";
    System.arraycopy(options, 0, words, 4, options.length);
    return CliRun.withInput(points, words).done().out();
  }

  private static String text(Domain domain, Points points) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    PointFile.write(out, domain, points);
    return out.toString(StandardCharsets.UTF_8);
  }

  private static String sites(int n) throws IOException {
    return text(Domain.SITES, RandomSites.uniform(n, 5));
  }

  // ---- the truth ----

  static List<RandomPolygons.Family> polygons() {
    return RandomPolygons.families();
  }

  static List<RandomSets.Family> sets() {
    return RandomSets.families();
  }

  @ParameterizedTest
  @MethodSource("polygons")
  void true_results_of_polygons_pass(RandomPolygons.Family family) throws IOException {
    for (int seed = 0; seed < 6; seed++) {
      String points = text(Domain.POLYGON, family.make(4 + 7 * seed, seed));
      for (String algorithm : List.of("monotone", "ear-clipping", "convex-even", "convex-odd")) {
        assertTrue(result(points, "--algorithm", algorithm), "seed " + seed);
        assertTrue(result(points, "--algorithm", algorithm, "--flip"), "flips, seed " + seed);
      }
    }
  }

  @ParameterizedTest
  @MethodSource("sets")
  void true_results_of_sites_pass(RandomSets.Family family) throws IOException {
    for (int seed = 0; seed < 6; seed++) {
      Points points = family.make(4 + 15 * seed, seed).points();
      if (isUsable(points)) {
        String text = text(Domain.SITES, points);
        assertTrue(result(text), "seed " + seed);
        assertTrue(result(text, "--flip"), "flips, seed " + seed);
      }
    }
  }

  private static boolean isUsable(Points points) {
    for (int i = 2; i < points.size(); i++) {
      if (points.orient(0, 1, i) != 0) {
        return true;
      }
    }
    return false;
  }

  private static void assertTrue(String result, String what) {
    CliRun run = CliRun.withInput(result, "verify", "-");
    assertThat(run.status()).as(what + ": " + run.err() + run.out()).isZero();
  }

  @Test
  void the_verb_says_that_a_result_is_true() {
    assertThat(CliRun.withInput(result("0 0\n4 0\n0 4\n"), "verify", "-").done().out())
        .isEqualTo("-: verified: 3 vertices triangulated by monotone, 3 even, 0 odd\n");
    assertThat(CliRun.withInput(result(POLYGON), "verify", "--quiet", "-").done().out()).isEmpty();
  }

  // ---- lies about numbers ----

  private static JsonObject json(String text) {
    return JsonParser.parseString(text).getAsJsonObject();
  }

  private static String fault(JsonObject result) {
    CliRun run = CliRun.withInput(result.toString(), "verify", "-");
    assertThat(run.status()).as("status of\n" + result).isEqualTo(4);
    assertThat(run.out()).isEmpty();
    assertThat(run.err()).matches("-:1: [^\n]*\n");
    return run.err().substring("-:1: ".length()).strip();
  }

  @ParameterizedTest
  @EnumSource(
      value = Domain.class,
      names = {"POLYGON", "SITES"})
  void every_wrong_number_is_caught(Domain domain) throws IOException {
    String points = domain == Domain.SITES ? sites(30) : POLYGON;
    List<String> fields =
        List.of(
            "vertices",
            "edges",
            "triangles",
            "boundary",
            "even",
            "odd",
            "evenBefore",
            "oddBefore",
            "flips",
            "oddLowerBound");
    for (String field : fields) {
      JsonObject lie = json(result(points, "--flip"));
      int truth = lie.get(field).getAsInt();
      lie.addProperty(field, truth + 2);
      assertThat(fault(lie))
          .isEqualTo("the field \"%s\" says %d, but it is %d%s", field, truth + 2, truth, CURE);
    }
  }

  @Test
  void every_missing_field_is_caught() {
    List<String> fields =
        List.of(
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
            "merged");
    for (String field : fields) {
      JsonObject lie = json(result(POLYGON, "--flip"));
      lie.remove(field);
      assertThat(fault(lie))
          .isEqualTo("the field \"" + field + "\" is missing or no whole number" + CURE);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"flips", "evenBefore", "oddBefore"})
  void figures_of_flips_need_flips(String field) {
    JsonObject lie = json(result(POLYGON));
    lie.addProperty(field, 2);
    assertThat(fault(lie))
        .isEqualTo("the field \"" + field + "\" is there, and no flips were asked for" + CURE);
  }

  @ParameterizedTest
  @ValueSource(strings = {"satisfied", "unsatisfied", "unsatisfiedLowerBound", "wishes"})
  void figures_of_wishes_need_the_wishes(String field) {
    JsonObject lie = json(result(POLYGON, "--optimize", "even"));
    lie.addProperty(field, 2);
    assertThat(fault(lie))
        .isEqualTo("the field \"" + field + "\" is there, and no text holds the wishes" + CURE);
  }

  // ---- lies about the triangulation ----

  private static Arguments lie(
      String name, String points, List<String> options, Consumer<JsonObject> change, String fault) {
    return Arguments.of(name, points, options, change, fault);
  }

  static Stream<Arguments> lies() throws IOException {
    List<String> none = List.of();
    List<String> flip = List.of("--flip");
    List<String> ears = List.of("--algorithm", "ear-clipping");
    String sites = sites(30);
    String flatSquare = "# kind: points\n" + FLAT_SQUARE;
    return Stream.of(
        lie("kind", POLYGON, none, j -> j.remove("kind"), "the field \"kind\" is missing"),
        lie(
            "points alone",
            POLYGON,
            none,
            j -> j.remove("edgeList"),
            "the field \"edgeList\" is missing, these are points without a triangulation"),
        lie(
            "unknown algorithm",
            POLYGON,
            none,
            j -> j.addProperty("algorithm", "magic"),
            "the algorithm is none of monotone, ear-clipping, convex-even, convex-odd,"
                + " constrained-delaunay or unknown"),
        lie(
            "algorithm of the other kind",
            sites,
            none,
            j -> j.addProperty("algorithm", "monotone"),
            "the algorithm is none of delaunay or unknown"),
        lie(
            "unknown post",
            POLYGON,
            none,
            j -> j.addProperty("post", "prayer"),
            "the field \"post\" is none of \"none\", \"flip\", \"optimize\", \"optimize\\+flip\""),
        lie(
            "merged vertices of a polygon",
            POLYGON,
            none,
            j -> j.addProperty("merged", 1),
            "the field \"merged\" cannot be 1"),
        lie(
            "fewer than none merged",
            sites,
            none,
            j -> j.addProperty("merged", -1),
            "the field \"merged\" cannot be -1"),
        lie(
            "optimal",
            sites,
            none,
            j -> j.addProperty("optimal", !j.get("optimal").getAsBoolean()),
            "the field \"optimal\" is not false"),
        lie(
            "two vertices",
            POLYGON,
            none,
            j -> keep(j.getAsJsonArray("points"), 2),
            "there are fewer than three vertices"),
        lie(
            "a vertex that is not there",
            POLYGON,
            none,
            j -> edge(j, 0).set(0, new JsonPrimitive(8)),
            "there is no vertex v8"),
        lie(
            "a vertex below zero",
            POLYGON,
            none,
            j -> edge(j, 3).set(1, new JsonPrimitive(-1)),
            "there is no vertex v-1"),
        lie(
            "a loop",
            POLYGON,
            none,
            j -> edge(j, 0).set(1, edge(j, 0).get(0)),
            "the edge leads from vertex v0 to itself"),
        lie(
            "an edge twice",
            POLYGON,
            none,
            j -> j.getAsJsonArray("edgeList").add(edge(j, 0).deepCopy()),
            "edge v\\d–v\\d lies on another edge"),
        lie(
            "a diagonal left out",
            POLYGON,
            none,
            j -> removeEdge(j, "diagonal|partition"),
            "on one side of edge v\\d–v\\d is no triangle"),
        lie(
            "a side left out",
            POLYGON,
            none,
            j -> removeEdge(j, "boundary"),
            "(vertex v\\d has fewer than two edges|on one side of edge v\\d–v\\d is no triangle)"),
        lie(
            "an edge of the hull left out",
            sites,
            none,
            j -> removeEdge(j, "boundary"),
            "the rim is not convex at vertex v\\d+"),
        lie(
            "a vertex without edges",
            sites,
            none,
            j -> j.getAsJsonArray("points").add(array(-5, -5)),
            "vertex v30 has fewer than two edges"),
        lie(
            "a crossing edge more",
            "# kind: points\n0 0\n9 0\n9 9\n0 9\n5 4\n",
            none,
            j -> j.getAsJsonArray("edgeList").add(edge(0, 2, "diagonal")),
            "on one side of edge v\\d–v\\d is no triangle"),
        lie(
            "an inverted triangle",
            "# kind: points\n0 0\n9 0\n9 9\n0 9\n5 4\n",
            none,
            j -> j.getAsJsonArray("points").set(4, array(20, 4)),
            "(on one side of edge .* is no triangle|the rim is not convex at vertex v\\d)"),
        lie(
            "sites at the same place",
            sites,
            none,
            j -> j.getAsJsonArray("points").set(4, j.getAsJsonArray("points").get(9)),
            "two sites are at the same place"),
        lie(
            "a polygon called sites",
            POLYGON,
            none,
            j -> {
              j.addProperty("kind", "points");
              j.addProperty("algorithm", "delaunay");
            },
            "the rim is not convex at vertex v\\d"),
        lie(
            "sites called a polygon",
            "# kind: points\n0 0\n9 0\n9 9\n4 8.5\n0 9\n",
            none,
            j -> {
              j.addProperty("kind", "polygon");
              j.addProperty("algorithm", "monotone");
            },
            "edge v\\d–v\\d is on the rim and no side"),
        lie(
            "a diagonal called boundary",
            sites,
            none,
            j -> rename(j, "diagonal", "boundary"),
            "edge v\\d+–v\\d+ is not on the boundary"),
        lie(
            "a boundary called diagonal",
            sites,
            none,
            j -> rename(j, "boundary", "diagonal"),
            "edge v\\d+–v\\d+ is on the boundary"),
        lie(
            "a partition among sites",
            sites,
            none,
            j -> rename(j, "diagonal", "partition"),
            "edge v\\d+–v\\d+ is of a partition, and the algorithm makes none"),
        lie(
            "a partition by ear clipping",
            POLYGON,
            ears,
            j -> rename(j, "diagonal", "partition"),
            "edge v\\d–v\\d is of a partition, and the algorithm makes none"),
        lie(
            "a flip that nobody asked for",
            sites,
            none,
            j -> rename(j, "diagonal", "flipped"),
            "edge v\\d+–v\\d+ is flipped, and no flips were asked for"),
        lie(
            "a flip that was none",
            sites,
            flip,
            j -> rename(j, "diagonal", "flipped"),
            "edge v\\d+–v\\d+ did not come from a flip"),
        lie(
            "a flip that was none, without a list",
            sites,
            flip,
            j -> {
              j.remove("flipList");
              rename(j, "diagonal", "flipped");
            },
            "(edge v\\d+–v\\d+ cannot have come from a flip|the field \"flips\" says .*)"),
        lie(
            "a flip kept secret",
            sites,
            flip,
            j -> rename(j, "flipped", "diagonal"),
            "edge v\\d+–v\\d+ came from a flip"),
        lie(
            "a flip kept secret, without a list",
            sites,
            flip,
            j -> {
              j.remove("flipList");
              rename(j, "flipped", "diagonal");
            },
            "the field \"flips\" says \\d+, but it is \\d+"),
        lie(
            "a list of flips that nobody asked for",
            sites,
            none,
            j -> j.add("flipList", new JsonArray()),
            "the field \"flipList\" is there, and no flips were asked for"),
        lie(
            "the wrong diagonal",
            flatSquare,
            none,
            j -> otherDiagonal(j),
            "the triangulation is not Delaunay at edge v\\d–v\\d"),
        lie(
            "the wrong diagonal before a flip",
            flatSquare,
            none,
            j -> {
              rename(j, "diagonal", "flipped");
              j.addProperty("post", "flip");
              j.addProperty("flips", 1);
              j.addProperty("evenBefore", 2);
              j.addProperty("oddBefore", 2);
            },
            "the triangulation is not Delaunay at edge v\\d–v\\d"));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("lies")
  void every_lie_is_caught(
      String name, String points, List<String> options, Consumer<JsonObject> change, String fault) {
    String truth = result(points, options.toArray());
    JsonObject lie = json(truth);
    change.accept(lie);
    assertThat(lie).as("the change").isNotEqualTo(json(truth));
    assertThat(fault(lie)).matches(fault + CURE);
  }

  @Test
  void a_polygon_that_crosses_itself_is_caught() {
    JsonObject lie = json(result(POLYGON));
    lie.getAsJsonArray("points").set(1, array(9, 19));
    assertThat(fault(lie)).matches("edges v\\d–v\\d and v\\d–v\\d cross at .*");
  }

  @Test
  void two_parts_are_caught() {
    JsonObject lie = json(result("# kind: points\n0 0\n9 0\n0 9\n20 20\n29 20\n20 29\n"));
    JsonArray edges = new JsonArray();
    for (int from = 0; from < 6; from += 3) {
      edges.add(edge(from, from + 1, "boundary"));
      edges.add(edge(from + 1, from + 2, "boundary"));
      edges.add(edge(from + 2, from, "boundary"));
    }
    lie.add("edgeList", edges);
    assertThat(fault(lie)).matches("on one side of edge v[345]–v[345] is no triangle" + CURE);
  }

  @Test
  void a_lie_is_told_with_its_line() {
    List<String> lines = new ArrayList<>(result(POLYGON).lines().toList());
    int line = lines.size() - 1;
    lines.set(line, lines.get(line).replaceFirst("\\[\\d+, ", "[77, "));
    CliRun run = CliRun.withInput(String.join("\n", lines), "verify", "-");
    assertThat(run.err()).isEqualTo("-:" + (line + 1) + ": there is no vertex v77" + CURE + "\n");
  }

  // ---- ways to lie ----

  private static JsonArray edge(JsonObject result, int i) {
    return result.getAsJsonArray("edgeList").get(i).getAsJsonArray();
  }

  private static JsonArray edge(int u, int v, String kind) {
    JsonArray edge = array(u, v);
    edge.add(kind);
    return edge;
  }

  private static JsonArray array(double... numbers) {
    JsonArray array = new JsonArray();
    for (double number : numbers) {
      array.add((int) number);
    }
    return array;
  }

  private static void keep(JsonArray array, int count) {
    while (array.size() > count) {
      array.remove(count);
    }
  }

  private static int find(JsonObject result, String kinds) {
    int i = 0;
    while (!edge(result, i).get(2).getAsString().matches(kinds)) {
      i++;
    }
    return i;
  }

  private static void removeEdge(JsonObject result, String kinds) {
    result.getAsJsonArray("edgeList").remove(find(result, kinds));
  }

  private static void rename(JsonObject result, String kind, String other) {
    edge(result, find(result, kind)).set(2, new JsonPrimitive(other));
  }

  /** Of a square, the diagonal that is not there; the counts of the degrees stay as they are. */
  private static void otherDiagonal(JsonObject result) {
    JsonArray diagonal = edge(result, find(result, "diagonal"));
    for (int end = 0; end < 2; end++) {
      diagonal.set(end, new JsonPrimitive((diagonal.get(end).getAsInt() + 1) % 4));
    }
  }
}
