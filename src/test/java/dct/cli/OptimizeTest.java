package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** {@code dct triangulate --optimize}, and {@code dct verify} on what it writes. */
class OptimizeTest {
  private static final String SITES = "0 0\n10 0\n10 10\n0 10\n5 5\n3 4\n7 8\n2 9\n";

  @TempDir private Path folder;

  private JsonObject optimize(String goal) {
    String file = folder.resolve("result.json").toString();
    CliRun run =
        CliRun.withInput(
                SITES,
                "triangulate",
                "-",
                "--as",
                "points",
                "--optimize",
                goal,
                "--json",
                "-o",
                file)
            .done();
    String verified = CliRun.withInput("", "verify", file).done().out();
    assertThat(verified).contains("verified", "recomputed");
    return JsonParser.parseString(run.out()).getAsJsonObject();
  }

  @Test
  void evenCarriesTheBoundAndItsReason() {
    JsonObject json = optimize("even");

    assertThat(json.get("post").getAsString()).isEqualTo("optimize");
    assertThat(json.get("optimal").getAsBoolean()).isTrue();
    assertThat(json.get("odd").getAsInt()).isEqualTo(json.get("oddLowerBound").getAsInt());
    assertThat(json.get("boundReason").getAsString()).isNotEmpty();
    assertThat(json.has("satisfied")).isFalse();
  }

  @Test
  void wishesFromAFileAreCounted() throws IOException {
    Path wishes = folder.resolve("wishes.txt");
    Files.writeString(wishes, "# two of them\n0 odd\n\n3 any # whatever\n");

    JsonObject json = optimize(wishes.toString());

    assertThat(json.get("wishes").getAsString()).isEqualTo("oeeaeeee");
    assertThat(json.get("satisfied").getAsInt() + json.get("unsatisfied").getAsInt()).isEqualTo(8);
    assertThat(json.get("unsatisfied").getAsInt())
        .isGreaterThanOrEqualTo(json.get("unsatisfiedLowerBound").getAsInt());
  }

  @Test
  void aLieAboutGrantedWishesIsFound() throws IOException {
    optimize("odd");
    Path file = folder.resolve("result.json");
    String text = Files.readString(file);
    int satisfied = JsonParser.parseString(text).getAsJsonObject().get("satisfied").getAsInt();
    Files.writeString(
        file, text.replace("\"satisfied\": " + satisfied, "\"satisfied\": " + (satisfied - 1)));

    CliRun run = CliRun.withInput("", "verify", file.toString());

    assertThat(run.status()).isEqualTo(4);
    assertThat(run.err()).contains("\"satisfied\"");
  }

  @ParameterizedTest
  @CsvSource({
    "0 often, 1, this is no wish for a vertex",
    "odd, 1, this is no wish for a vertex",
    "99 odd, 1, there is no vertex 99"
  })
  void aBadWishIsNamedWithItsLine(String line, int number, String fault) throws IOException {
    Path wishes = folder.resolve("wishes.txt");
    Files.writeString(wishes, line + "\n");

    CliRun run =
        CliRun.withInput(
            SITES, "triangulate", "-", "--as", "points", "--optimize", wishes.toString());

    assertThat(run.status()).isEqualTo(3);
    assertThat(run.err()).startsWith(wishes + ":" + number + ": " + fault);
  }

  @Test
  void optionsThatDoNotGoTogetherAreRefused() {
    CliRun both =
        CliRun.withInput(
            SITES, "triangulate", "-", "--as", "points", "--optimize", "even", "--flip");
    CliRun alone = CliRun.withInput(SITES, "triangulate", "-", "--as", "points", "--seed", "2");

    assertThat(both.status()).isEqualTo(2);
    assertThat(both.err()).contains("--flip and --optimize exclude each other");
    assertThat(alone.status()).isEqualTo(2);
    assertThat(alone.err()).contains("--optimize, which is missing");
  }

  @ParameterizedTest
  @CsvSource({"evn, ' (did you mean even?)'", "most, ''", "wishes.txt, ''"})
  void what_is_neither_a_parity_nor_a_file(String word, String hint) {
    CliRun run = CliRun.withInput("0 0\n4 0\n0 4\n", "triangulate", "-", "--optimize", word);
    assertThat(run.err())
        .isEqualTo(
            word
                + ": there is no such file; --optimize takes even, odd or a file of wishes"
                + hint
                + "\n");
    assertThat(run.status()).isEqualTo(3);
  }

  @Test
  void wishesMayComeFromStandardInput() throws IOException {
    Path polygon = Files.writeString(folder.resolve("p.txt"), "0 0\n9 1\n10 8\n1 9\n");
    CliRun run = CliRun.withInput("0 odd\n2 odd\n", "triangulate", polygon, "--optimize", "-");
    assertThat(run.done().out()).contains("4 of 4 wishes granted");
    assertThat(CliRun.of("triangulate", "-", "--optimize", "-").err())
        .contains("INPUT and --optimize both want standard input");
  }
}
