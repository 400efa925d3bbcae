package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Results of a region are checked with their rings and fixed edges; forged ones are refused. */
class ForgedRegionTest {
  private static final String PLATE = "samples/plate_region.txt";

  @TempDir private Path folder;

  private static JsonObject made(String... options) {
    return made(CliRun.of(all(options)));
  }

  private static Object[] all(String... options) {
    List<Object> words = new ArrayList<>(List.of("triangulate", PLATE, "-o", "-"));
    words.addAll(List.of(options));
    return words.toArray();
  }

  private static JsonObject made(CliRun run) {
    return JsonParser.parseString(run.done().out()).getAsJsonObject();
  }

  private static CliRun verify(JsonObject result) {
    return CliRun.withInput(result.toString(), "verify", "-", "--input", PLATE);
  }

  private static String refusal(Consumer<JsonObject> forge, String... options) {
    JsonObject result = made(options);
    forge.accept(result);
    CliRun run = CliRun.withInput(result.toString(), "verify", "-");
    assertThat(run.status()).as(run.out()).isEqualTo(4);
    return run.err();
  }

  private static JsonArray numbers(int... values) {
    JsonArray list = new JsonArray();
    for (int value : values) {
      list.add(value);
    }
    return list;
  }

  private static JsonArray ring(JsonObject result, int r) {
    return result.getAsJsonArray("rings").get(r).getAsJsonArray();
  }

  private static void rename(JsonObject result, int u, int v, String kind) {
    result
        .getAsJsonArray("edgeList")
        .forEach(
            each -> {
              JsonArray edge = each.getAsJsonArray();
              int a = edge.get(0).getAsInt();
              int b = edge.get(1).getAsInt();
              if (Math.min(a, b) == u && Math.max(a, b) == v) {
                edge.set(2, new JsonPrimitive(kind));
              }
            });
  }

  private static JsonArray edge(int u, int v) {
    JsonArray edge = numbers(u, v);
    edge.add("diagonal");
    return edge;
  }

  @Test
  void everyMethodIsVerified() {
    for (String algorithm : List.of("monotone", "ear-clipping", "convex-even", "convex-odd")) {
      for (JsonObject result :
          List.of(made("--algorithm", algorithm), made("--algorithm", algorithm, "--flip"))) {
        assertThat(verify(result).done().out()).contains("verified: 16 vertices triangulated by");
      }
    }
    assertThat(verify(made("--optimize", "even")).status()).isIn(0, 5);
  }

  @Test
  void ringsThatAreOthersAreRefused() {
    assertThat(refusal(result -> result.remove("rings"))).contains("cross at");
    Consumer<JsonObject> withoutHole =
        result -> {
          result.getAsJsonArray("rings").remove(2);
          result.add("ringSizes", numbers(6, 5));
        };
    assertThat(refusal(withoutHole)).contains("on one side of edge").contains("no triangle");
    assertThat(refusal(result -> ring(result, 0).set(0, new JsonPrimitive(15))))
        .contains("edges v14–v13 and v15–v1 cross");
    assertThat(refusal(result -> ring(result, 0).set(0, new JsonPrimitive(1))))
        .contains("vertex 1 is on two rings, or twice on one");
    assertThat(refusal(result -> ring(result, 0).set(0, new JsonPrimitive(99))))
        .contains("there is no vertex 99");
    assertThat(refusal(result -> result.getAsJsonArray("rings").set(1, numbers(6, 7, 8, 9, 10))))
        .contains("the ring of hole 1 runs counter-clockwise, not clockwise");
    assertThat(refusal(result -> result.getAsJsonArray("rings").set(0, numbers(5, 4, 3, 2, 1, 0))))
        .contains("the outer ring runs clockwise, not counter-clockwise");
    assertThat(refusal(result -> result.add("ringSizes", numbers(6, 4, 5))))
        .contains("the field \"ringSizes\" is not [6, 5, 4]");
    assertThat(refusal(result -> result.add("rings", new JsonArray())))
        .contains("the field \"rings\" has no ring");
    assertThat(refusal(result -> result.addProperty("kind", "polygon"))).isNotEmpty();
    assertThat(refusal(result -> result.addProperty("boundary", 14)))
        .contains("the field \"boundary\" says 14, but it is 15");
    assertThat(refusal(result -> result.addProperty("triangles", 21)))
        .contains("the field \"triangles\" says 21, but it is 19");
  }

  @Test
  void aHoleThatIsTriangulatedOverIsRefused() {
    Consumer<JsonObject> forge =
        result -> {
          result.getAsJsonArray("edgeList").add(edge(11, 13));
          result.addProperty("edges", 37);
          result.addProperty("triangles", 20);
        };
    assertThat(refusal(forge))
        .contains("on one side of edge")
        .contains("no triangle of the region");
  }

  @Test
  void fixedEdgesAreThereAndCalledSo() {
    assertThat(refusal(result -> rename(result, 5, 15, "diagonal")))
        .contains("edge v5–v15 is fixed");
    assertThat(refusal(result -> rename(result, 5, 15, "partition"))).contains("is fixed");
    assertThat(refusal(result -> result.getAsJsonArray("fixed").add(numbers(0, 15))))
        .contains("edges v9–v8 and v0–v15 cross at");
    assertThat(refusal(result -> result.getAsJsonArray("fixed").add(numbers(0, 1))))
        .contains("names an edge of a ring, or an edge twice");
    assertThat(refusal(result -> result.getAsJsonArray("fixed").remove(0)))
        .contains("is not fixed");
    assertThat(refusal(result -> result.remove("fixed"))).contains("missing");
  }

  @Test
  void aFixedEdgeThatIsMissingIsRefused() {
    String square = "# kind: region\n0 0\n9 0\n9 9\n0 9\n";
    JsonObject result = made(CliRun.withInput(square, "triangulate", "-", "-o", "-"));
    JsonArray made = result.getAsJsonArray("edgeList").get(4).getAsJsonArray();
    boolean isFirst = made.get(0).getAsInt() % 2 == 0; // v0–v2, or else v1–v3
    result.getAsJsonArray("fixed").add(isFirst ? numbers(1, 3) : numbers(0, 2));
    CliRun run = CliRun.withInput(result.toString(), "verify", "-");
    assertThat(run.status()).isEqualTo(4);
    assertThat(run.err()).contains("the fixed edge v").contains(" is missing");
  }

  @Test
  void theInputTellsOfOtherRingsAndFixedEdges() throws IOException {
    JsonObject result = made();
    String text = Files.readString(Path.of(PLATE)).replaceAll("fixed.*\n", "");
    Path other = Files.writeString(folder.resolve("other.txt"), text);
    CliRun run = CliRun.withInput(result.toString(), "verify", "-", "--input", other);
    assertThat(run.status()).isEqualTo(4);
    assertThat(run.err()).contains("the rings are not those of");
  }

  /** A flip that moves a fixed edge is none, even if a later one moves it back. */
  @Test
  void noFlipMovesAFixedEdge() {
    String square = "0 0\n9 0\n9 9\n0 9\nfixed 0 2\n";
    JsonObject result =
        made(CliRun.withInput(square, "triangulate", "-", "--as", "region", "--flip", "-o", "-"));
    JsonArray flips = new JsonArray();
    flips.add(numbers(0, 2, 1, 3));
    flips.add(numbers(1, 3, 0, 2));
    result.add("flipList", flips);
    result.addProperty("flips", 2);
    CliRun run = CliRun.withInput(result.toString(), "verify", "-");
    assertThat(run.status()).isEqualTo(4);
    assertThat(run.err()).contains("cannot have been a flip: one of its edges is fixed");
  }

  @Test
  void whatOnlyARegionHasIsRefusedOfAPolygon() {
    String square = "0 0\n9 0\n9 9\n0 9\n";
    JsonObject result = made(CliRun.withInput(square, "triangulate", "-", "-o", "-"));
    result.add("ringSizes", numbers(4));
    CliRun run = CliRun.withInput(result.toString(), "verify", "-");
    assertThat(run.err())
        .contains("the field \"ringSizes\" is there, and the result is not of a region");
  }
}
