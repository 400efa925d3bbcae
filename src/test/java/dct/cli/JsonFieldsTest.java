package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Every field of the JSON that is printed is described in docs/json.md, and the other way round.
 */
class JsonFieldsTest {
  private static final Pattern NAME = Pattern.compile("`(\\w+)`");
  private static final String SQUARE = "0 0\n10 0\n10 10\n0 10\n";
  private static final String BOW_TIE = "0 0\n4 4\n4 0\n0 4\n";

  @TempDir Path folder;

  /** The names in the first column of the tables. */
  private static Set<String> described() throws IOException {
    Set<String> names = new TreeSet<>();
    for (String line : Files.readAllLines(Path.of("docs", "json.md"))) {
      Matcher name = NAME.matcher(line.startsWith("| `") ? line.split("\\|", -1)[1] : "");
      while (name.find()) {
        names.add(name.group(1));
      }
    }
    return names;
  }

  private static JsonObject json(String out) {
    return JsonParser.parseString(out).getAsJsonObject();
  }

  @Test
  void the_page_describes_what_is_printed() throws IOException {
    Path wishes = Files.writeString(folder.resolve("wishes.txt"), "0 odd\n1 any\n");
    Path result = folder.resolve("result.json");
    Path flips = folder.resolve("flips.json");
    Set<String> printed = new TreeSet<>();
    collect(printed, CliRun.withInput(SQUARE, "triangulate", "-", "--json", "--flip"));
    collect(
        printed,
        CliRun.withInput(SQUARE, "triangulate", "-", "--json", "--optimize", wishes, "-o", result));
    printed.addAll(json(Files.readString(result)).keySet());
    CliRun.withInput(SQUARE, "triangulate", "-", "--flip", "-o", flips).done();
    for (String preferred : List.of("length", "kept:" + flips)) {
      Object[] call = {"triangulate", "-", "--optimize", "even", "--prefer", preferred, "-o", "-"};
      printed.addAll(json(CliRun.withInput(SQUARE, call).done().out()).keySet());
    }
    printed.addAll(json(Files.readString(flips)).keySet());
    collect(printed, CliRun.withInput(SQUARE, "check", "-", "--json"));
    collect(printed, CliRun.withInput(BOW_TIE, "check", "-", "--json"));
    collect(printed, CliRun.of("verify", result, "--json"));
    collect(
        printed, CliRun.of("generate", "points", "-n", 5, "--json", "-o", folder.resolve("p.txt")));
    Object[] region = {"triangulate", "samples/plate_region.txt", "-o", "-"};
    printed.addAll(json(CliRun.of(region).done().out()).keySet());
    collect(printed, CliRun.of("check", "samples/plate_region.txt", "--json"));
    printed.addAll(List.of("documentWishes", "certificate")); // of the window, of large sets
    Set<String> inside = Set.of("format", "version", "seed", "timeLimit");
    assertThat(described()).isSubsetOf(printed);
    printed.removeAll(inside);
    assertThat(described()).containsAll(printed);
    assertThat(Files.readString(Path.of("docs", "json.md"))).contains(inside);
  }

  private static void collect(Set<String> names, CliRun run) {
    assertThat(run.out()).hasLineCount(1);
    names.addAll(json(run.out()).keySet());
  }

  @Test
  void check_says_what_was_found() {
    assertThat(json(CliRun.withInput(SQUARE, "check", "-", "--json").done().out()))
        .isEqualTo(
            json(
                "{'input': '-', 'usable': true, 'kind': 'polygon', 'vertices': 4, 'merged': 0,"
                    + " 'clockwise': false}"));
    CliRun sites = CliRun.withInput(SQUARE + "0 0\n", "check", "-", "--json", "--as", "points");
    assertThat(json(sites.done().out()))
        .isEqualTo(
            json("{'input': '-', 'usable': true, 'kind': 'points', 'vertices': 4, 'merged': 1}"));
  }

  @Test
  void check_says_what_is_wrong_also_as_json() {
    CliRun run = CliRun.withInput(BOW_TIE, "check", "-", "--json");
    assertThat(run.status()).isEqualTo(3);
    JsonObject said = json(run.out());
    assertThat(said.get("usable").getAsBoolean()).isFalse();
    assertThat("-:" + said.get("line") + ": " + said.get("fault").getAsString() + "\n")
        .isEqualTo(run.err());
    CliRun missing = CliRun.of("check", folder.resolve("none"), "--json", "--quiet");
    assertThat(missing.err()).isEmpty();
    assertThat(json(missing.out()).keySet()).containsExactly("input", "usable", "fault");
  }

  @Test
  void generate_says_what_makes_the_same_again() throws IOException {
    Path made = folder.resolve("made_polygonbased.txt");
    JsonObject said =
        json(CliRun.of("generate", "polygon", "-n", 9, "--json", "-o", made).done().out());
    assertThat(said.get("outputs").getAsJsonArray())
        .extracting(JsonElement::getAsString)
        .containsExactly(made.toString());
    Path again = folder.resolve("again_polygonbased.txt");
    CliRun.of(
            "generate",
            said.get("kind").getAsString(),
            "-n",
            said.get("vertices"),
            "--shape",
            said.get("shape").getAsString(),
            "--seed",
            said.get("seed"),
            "-o",
            again)
        .done();
    assertThat(again).hasSameTextualContentAs(made);
  }

  @Test
  void generate_prints_either_points_or_json() {
    CliRun run = CliRun.of("generate", "points", "-n", 5, "--json");
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).contains("--json and the points both want standard output, use -o FILE");
  }
}
