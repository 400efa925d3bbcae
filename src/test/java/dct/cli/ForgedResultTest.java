package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.generate.PolygonShape;
import dct.experiment.generate.RandomSites;
import dct.io.PointFile;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** No result with a false figure is verified, however it was forged. */
class ForgedResultTest {
  /** Fields that say how a result came to be and nothing about it. */
  private static final Set<String> NO_CLAIMS =
      Set.of("format", "version", "input", "interrupted", "seed", "timeLimit", "millis");

  private static final String SQUARES = "# kind: points\n0 0\n9 0\n9 9\n0 9\n5 4\n9 0\n0 0\n";

  @TempDir private Path folder;

  private record Truth(String name, String points, List<String> options) {
    @Override
    public String toString() {
      return name;
    }

    JsonObject make() {
      List<Object> words = new ArrayList<>(List.of("triangulate", "-", "-o", "-"));
      words.addAll(options);
      return json(CliRun.withInput(points, words.toArray()).done().out());
    }
  }

  static List<Truth> truths() throws IOException {
    String polygon =
        text(Domain.POLYGON, PolygonShape.of("two-opt").orElseThrow().generate(40, 3).points());
    String sites = text(Domain.SITES, RandomSites.uniform(50, 5));
    return List.of(
        new Truth("monotone", polygon, List.of("--flip")),
        new Truth("ears", polygon, List.of("--algorithm", "ear-clipping")),
        new Truth("convex pieces", polygon, List.of("--algorithm", "convex-even", "--flip")),
        new Truth("fans", polygon, List.of("--algorithm", "convex-odd")),
        new Truth("optimum of a polygon", polygon, List.of("--optimize", "even")),
        new Truth("odd vertices of a polygon", polygon, List.of("--optimize", "odd")),
        new Truth("least length", polygon, List.of("--optimize", "even", "--prefer", "length")),
        new Truth("sites", sites, List.of("--flip")),
        new Truth("optimum of sites", sites, List.of("--optimize", "even")),
        new Truth("odd sites", sites, List.of("--optimize", "odd")));
  }

  private static String text(Domain domain, Points points) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    PointFile.write(out, domain, points);
    return out.toString(StandardCharsets.UTF_8);
  }

  private static JsonObject json(String text) {
    return JsonParser.parseString(text).getAsJsonObject();
  }

  private static CliRun verify(JsonObject result, Object... options) {
    List<Object> words = new ArrayList<>(List.of("verify", "-"));
    words.addAll(List.of(options));
    return CliRun.withInput(result.toString(), words.toArray());
  }

  /** Each figure and word of the result, changed in every way that comes to mind. */
  private static Map<String, JsonObject> forgeries(JsonObject truth) {
    Map<String, JsonObject> forged = new LinkedHashMap<>();
    for (Map.Entry<String, JsonElement> field : truth.entrySet()) {
      String name = field.getKey();
      if (NO_CLAIMS.contains(name) || !field.getValue().isJsonPrimitive()) {
        continue;
      }
      JsonPrimitive value = field.getValue().getAsJsonPrimitive();
      if (value.isNumber()) {
        for (int off : new int[] {-4, -2, -1, 1, 2, 4, 1000}) {
          forge(forged, truth, name + off, j -> j.addProperty(name, value.getAsInt() + off));
        }
        forge(forged, truth, name + " + ½", j -> j.addProperty(name, value.getAsInt() + 0.5));
        forge(forged, truth, name + " as text", j -> j.addProperty(name, value.toString()));
      } else if (value.isBoolean()) {
        forge(forged, truth, name, j -> j.addProperty(name, !value.getAsBoolean()));
      }
      if (!name.equals("boundReason")) {
        forge(forged, truth, "no " + name, j -> j.remove(name));
      }
    }
    forgeEdges(forged, truth);
    return forged;
  }

  private static void forgeEdges(Map<String, JsonObject> forged, JsonObject truth) {
    int edges = truth.getAsJsonArray("edgeList").size();
    for (int i = 0; i < edges; i += 7) {
      int edge = i;
      for (String kind : List.of("boundary", "partition", "flipped")) {
        if (!edge(truth, edge).get(2).getAsString().equals(kind)) {
          forge(forged, truth, "edge " + i + " " + kind, j -> relabel(j, edge, kind));
        }
      }
      forge(forged, truth, "without edge " + i, j -> j.getAsJsonArray("edgeList").remove(edge));
      forge(forged, truth, "another end of " + i, j -> moveEnd(j, edge));
    }
  }

  private static void relabel(JsonObject result, int edge, String kind) {
    edge(result, edge).set(2, new JsonPrimitive(kind));
  }

  private static void moveEnd(JsonObject result, int edge) {
    JsonArray ends = edge(result, edge);
    int n = result.getAsJsonArray("points").size();
    ends.set(0, new JsonPrimitive((ends.get(0).getAsInt() + 1) % n));
  }

  private static JsonArray edge(JsonObject result, int i) {
    return result.getAsJsonArray("edgeList").get(i).getAsJsonArray();
  }

  private static void forge(
      Map<String, JsonObject> forged, JsonObject truth, String how, Consumer<JsonObject> change) {
    JsonObject lie = truth.deepCopy();
    change.accept(lie);
    assertThat(lie).as(how).isNotEqualTo(truth);
    forged.put(how, lie);
  }

  @ParameterizedTest
  @MethodSource("truths")
  void no_forgery_passes(Truth truth) {
    JsonObject result = truth.make();
    assertThat(verify(result).status()).as("the truth: %s", verify(result)).isZero();
    Map<String, JsonObject> forged = forgeries(result);
    assertThat(forged).hasSizeGreaterThan(100);
    forged.forEach(
        (how, lie) -> {
          // A diagonal of a piece that is called one between pieces cuts pieces of the same form.
          boolean finer = how.endsWith("partition") && isStillCut(lie);
          // Not to claim that nothing is better is no lie.
          boolean modest = how.equals("preferenceOptimal");
          assertThat(verify(lie).status())
              .as(how)
              .isIn(finer || modest ? List.of(0, 4, 5) : List.of(3, 4, 5));
        });
  }

  private static boolean isStillCut(JsonObject lie) {
    return lie.get("kind").getAsString().equals("polygon")
        && !lie.get("algorithm").getAsString().equals("ear-clipping")
        && !lie.get("post").getAsString().equals("optimize");
  }

  @ParameterizedTest
  @MethodSource("truths")
  void an_invented_optimum_is_not_accepted(Truth truth) {
    JsonObject result = truth.make();
    boolean wished = result.has("unsatisfied");
    String present = wished ? "unsatisfied" : "odd";
    String bound = wished ? "unsatisfiedLowerBound" : "oddLowerBound";
    if (result.get(present).getAsInt() > result.get(bound).getAsInt()) {
      result.addProperty(bound, result.get(present).getAsInt());
      result.addProperty("optimal", true);
      for (String reason : List.of("degree sum", "exact table over all triangulations", "")) {
        result.addProperty("boundReason", reason);
        assertThat(verify(result).status()).as(reason).isIn(4, 5);
      }
    }
  }

  @Test
  void fourteen_odd_of_fifty_sites_are_no_optimum_by_degree_sum() throws IOException {
    Truth truth = new Truth("", text(Domain.SITES, RandomSites.uniform(50, 5)), List.of("--flip"));
    JsonObject result = truth.make();
    int odd = result.get("odd").getAsInt();
    assertThat(odd).isGreaterThan(2);
    result.addProperty("oddLowerBound", odd);
    result.addProperty("optimal", true);
    result.addProperty("boundReason", "degree sum");
    assertThat(verify(result).status()).isNotZero();
  }

  @ParameterizedTest
  @MethodSource("truths")
  void what_a_search_without_time_returns_is_verified(Truth truth) {
    List<String> hurried = List.of("--optimize", "even", "--time-limit", "0");
    JsonObject result = new Truth("", truth.points, hurried).make();
    assertThat(verify(result).status()).as("%s", verify(result)).isZero();
  }

  @Test
  void merged_duplicates_are_believed_only_beside_the_input() throws IOException {
    Path input = Files.writeString(folder.resolve("squares.txt"), SQUARES);
    JsonObject result = new Truth("", SQUARES, List.of()).make();
    assertThat(result.get("merged").getAsInt()).isEqualTo(2);
    assertThat(verify(result).status()).isEqualTo(5);
    assertThat(verify(result).out()).contains("2 merged duplicates were not recounted");
    assertThat(verify(result, "--input", input).status()).isZero();
    Path file = Files.writeString(folder.resolve("result.json"), result.toString());
    assertThat(CliRun.withInput(SQUARES, "verify", file, "--input", "-").status()).isZero();
    assertThat(verify(result, "--input", "-").status()).isEqualTo(2);
    result.addProperty("merged", 3);
    assertThat(verify(result, "--input", input).err())
        .contains("the field \"merged\" says 3, but it is 2");
  }

  @Test
  void the_result_of_another_input_is_caught() throws IOException {
    JsonObject result = new Truth("", SQUARES, List.of()).make();
    Path moved = Files.writeString(folder.resolve("a.txt"), SQUARES.replace("5 4", "5 5"));
    assertThat(verify(result, "--input", moved).err())
        .contains("vertex v4 is elsewhere in " + moved);
    Path more = Files.writeString(folder.resolve("b.txt"), SQUARES + "3 3\n");
    assertThat(verify(result, "--input", more).err())
        .contains("5 points are here, and 6 in " + more);
    Path polygon = Files.writeString(folder.resolve("c.txt"), "# kind: polygon\n0 0\n9 0\n9 9\n");
    assertThat(verify(result, "--input", polygon).status()).isEqualTo(4);
  }

  @ParameterizedTest
  @MethodSource("truths")
  void pieces_that_are_not_convex_or_monotone_are_caught(Truth truth) {
    JsonObject result = truth.make();
    int changed = 0;
    for (JsonElement each : result.getAsJsonArray("edgeList")) {
      JsonArray edge = each.getAsJsonArray();
      if (edge.get(2).getAsString().equals("partition")) {
        edge.set(2, new JsonPrimitive("diagonal"));
        changed++;
      }
    }
    if (changed > 0) {
      assertThat(verify(result).status()).isEqualTo(4);
      assertThat(verify(result).err()).containsPattern("is a piece that is not (convex|monotone)");
    }
  }

  @Test
  void the_checks_are_listed_as_json() {
    JsonObject result = new Truth("", SQUARES, List.of("--flip")).make();
    JsonObject verdict = json(verify(result, "--json").out());
    assertThat(verdict.get("verdict").getAsString()).isEqualTo("open");
    assertThat(verdict.getAsJsonArray("checks")).hasSizeGreaterThan(8);
    result.addProperty("odd", 77);
    JsonObject lie = json(verify(result, "--json").out());
    JsonArray checks = lie.getAsJsonArray("checks");
    JsonObject last = checks.get(checks.size() - 1).getAsJsonObject();
    assertThat(lie.get("verdict").getAsString()).isEqualTo("false");
    assertThat(last.get("what").getAsString()).isEqualTo("the degrees");
    assertThat(last.get("outcome").getAsString()).isEqualTo("false");
  }
}
