package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.generate.PolygonShape;
import dct.io.PointFile;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@code dct triangulate --optimize … --prefer …}, and what {@code dct verify} says of it. */
class PreferTest {
  @TempDir private Path folder;

  private Path polygon;
  private Path given;

  @BeforeEach
  void makeFiles() throws IOException {
    polygon = folder.resolve("polygon.txt");
    Points points = PolygonShape.TWO_OPT.generate(60, 7).points();
    try (OutputStream out = Files.newOutputStream(polygon)) {
      PointFile.write(out, Domain.POLYGON, points);
    }
    given = folder.resolve("given.json");
    CliRun.of("triangulate", polygon, "--quiet", "-o", given).done();
  }

  private JsonObject prefer(String... words) throws IOException {
    Path result = folder.resolve("result.json");
    Object[] call = {"triangulate", polygon, "--optimize", "even", "--quiet", "-o", result};
    Object[] all = new Object[call.length + words.length];
    System.arraycopy(call, 0, all, 0, call.length);
    System.arraycopy(words, 0, all, call.length, words.length);
    CliRun.of(all).done();
    return JsonParser.parseString(Files.readString(result)).getAsJsonObject();
  }

  private static CliRun verify(JsonObject result) {
    return CliRun.withInput(result.toString(), "verify", "-");
  }

  @Test
  void each_preference_is_best_by_its_own_value() throws IOException {
    JsonObject angle = prefer();
    JsonObject length = prefer("--prefer", "length");
    JsonObject kept = prefer("--prefer", "kept:" + given);
    JsonObject none = prefer("--prefer", "none");
    assertThat(prefer("--prefer", "angle").get("edgeList")).isEqualTo(angle.get("edgeList"));
    assertThat(none.has("preferred")).isFalse();
    for (JsonObject each : new JsonObject[] {angle, length, kept}) {
      assertThat(each.get("odd")).isEqualTo(none.get("odd"));
      assertThat(each.get("preferenceOptimal").getAsBoolean()).isTrue();
      assertThat(verify(each).done().out())
          .contains("what was preferred: that none is better was recomputed");
    }
    int all = angle.getAsJsonArray("edgeList").size();
    assertThat(angle.get("smallestAngle").getAsDouble()).isBetween(0.001, 60.0);
    assertThat(kept.get("keptEdges").getAsInt()).isBetween(60, all);
    assertThat(kept.getAsJsonArray("givenEdges")).hasSize(all);
    assertThat(swapped(angle, length, "totalLength"))
        .contains("\"totalLength\" is not")
        .contains("make the result again");
  }

  /** The edges of one result under the figures of another. */
  private static String swapped(JsonObject edges, JsonObject figures, String field) {
    JsonObject lie = edges.deepCopy();
    lie.remove("smallestAngle");
    lie.add("preferred", figures.get("preferred"));
    lie.add(field, figures.get(field));
    CliRun run = verify(lie);
    assertThat(run.status()).isEqualTo(4);
    return run.err();
  }

  @Test
  void the_value_of_another_optimum_is_no_proof() throws IOException {
    JsonObject length = prefer("--prefer", "length");
    JsonObject angle = prefer();
    JsonObject lie = length.deepCopy();
    lie.remove("totalLength");
    lie.addProperty("preferred", "angle");
    for (double value = 60; value > 1e-3; value /= 2) {
      lie.addProperty("smallestAngle", value);
      assertThat(verify(lie).status()).isEqualTo(4);
    }
    String truth =
        verify(lie).err().replaceAll("(?s).*\"smallestAngle\" is not ([0-9.E-]+);.*", "$1");
    lie.addProperty("smallestAngle", Double.parseDouble(truth));
    assertThat(Double.parseDouble(truth)).isLessThan(angle.get("smallestAngle").getAsDouble());
    assertThat(verify(lie).err())
        .contains("\"preferenceOptimal\" is true, but another has smallest angle");
  }

  @Test
  void a_list_of_given_edges_is_read_with_care() throws IOException {
    JsonObject kept = prefer("--prefer", "kept:" + given);
    JsonObject without = kept.deepCopy();
    without.remove("givenEdges");
    assertThat(verify(without).err()).contains("\"givenEdges\" is no list of pairs of vertices");
    JsonObject outside = kept.deepCopy();
    outside.getAsJsonArray("givenEdges").get(0).getAsJsonArray().set(0, outside.get("vertices"));
    assertThat(verify(outside).status()).isEqualTo(4);
    JsonObject misshaped = kept.deepCopy();
    misshaped.getAsJsonArray("givenEdges").set(3, new JsonArray());
    assertThat(verify(misshaped).status()).isEqualTo(3);
    assertThat(verify(misshaped).err()).contains("\"givenEdges\" is not a list of pairs");
  }

  @Test
  void a_result_is_read_back_with_what_was_preferred() throws IOException {
    prefer("--prefer", "kept:" + given);
    CliRun again =
        CliRun.of("triangulate", folder.resolve("result.json"), "--algorithm", "as-read").done();
    assertThat(again.out()).contains("60 vertices");
    assertThat(CliRun.of("triangulate", polygon, "--optimize", "odd").done().out())
        .containsPattern("smallest angle [0-9.e-]+°, the largest of all equally good ones");
  }

  @ParameterizedTest
  @CsvSource({
    "angel, '--prefer angel is unknown (did you mean angle?), use angle, length, none or kept'",
    "kept, '--prefer kept is unknown, use angle, length, none or kept:RESULT'",
    "kept:, '--prefer kept: names no file, write --prefer kept:RESULT.json'"
  })
  void wrong_words_are_refused(String word, String sentence) {
    CliRun run = CliRun.of("triangulate", polygon, "--optimize", "even", "--prefer", word);
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).contains(sentence);
  }

  @Test
  void what_does_not_go_together_is_refused() throws IOException {
    CliRun alone = CliRun.of("triangulate", polygon, "--prefer", "length");
    assertThat(alone.status()).isEqualTo(2);
    assertThat(alone.err()).contains("--prefer belongs to --optimize, which is missing");
    Path other = Files.writeString(folder.resolve("other.txt"), "0 0\n9 1\n10 8\n1 9\n");
    CliRun foreign =
        CliRun.of("triangulate", other, "--optimize", "even", "--prefer", "kept:" + given);
    assertThat(foreign.status()).isEqualTo(3);
    assertThat(foreign.err())
        .isEqualTo(given + ": its points are not those of " + other + "; name a result of them\n");
    CliRun bare =
        CliRun.of("triangulate", polygon, "--optimize", "even", "--prefer", "kept:" + polygon);
    assertThat(bare.status()).isEqualTo(3);
    assertThat(bare.err()).contains("there is no triangulation in it; triangulate it first");
  }
}
