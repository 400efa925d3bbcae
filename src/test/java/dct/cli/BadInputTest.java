package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Bad input on the command line: status 3, one line {@code FILE:LINE: cause; cure}. */
class BadInputTest {
  private static final String FORM = "write one vertex a line, as two numbers x y";
  private static final String TOUCHING = ", or give --touching split or --touching hair";
  private static final String HINT = ", or read the file as sites with --as points";

  @TempDir Path folder;

  private static Arguments bad(String name, String text, String message) {
    return Arguments.of(name, text.getBytes(StandardCharsets.UTF_8), message);
  }

  static Stream<Arguments> badPolygons() {
    return Stream.of(
        bad("empty", "", "1: the file is empty; " + FORM),
        Arguments.of(
            "binary",
            new byte[] {1, 0, 2},
            "1: this is a binary file, not text; choose a file with two numbers x y a line"),
        bad("one vertex", "0 0\n", "1: 1 vertex; three or more are needed"),
        bad("two vertices", "0 0\n\n1 1\n", "3: 2 vertices; three or more are needed"),
        bad("a word", "0 0\n1 one\n0 1\n", "2: \"one\" is not a number; " + FORM),
        bad("one number", "0 0\n1\n0 1\n", "2: there is only one number; " + FORM),
        bad(
            "three numbers",
            "0 0\n1 1 1\n0 1\n",
            "2: there are 3 numbers here, but 2 in line 1; " + FORM),
        bad(
            "NaN",
            "0 0\nNaN 1\n0 1\n",
            "2: NaN is not a finite number; remove the line or correct the coordinate"),
        bad(
            "infinity",
            "0 0\n1 Infinity\n0 1\n",
            "2: Infinity is not a finite number; remove the line or correct the coordinate"),
        bad(
            "too large",
            "0 0\n1 1\n0 1e400\n",
            "3: 1e400 is too large, a coordinate is at most 1.797e308; scale the data"),
        bad(
            "hexadecimal",
            "0 0\n0xFF 1\n0 1\n",
            "2: 0xFF is hexadecimal; write the number in decimal"),
        bad(
            "decimal comma",
            "0 0\n1,5 2,5\n0 1\n",
            "2: 1,5 is written with a decimal comma; write it with a point, 1.5"),
        Arguments.of(
            "Latin-1",
            "0 0\n1 1 # Fl\u00e4che\n0 1\n".getBytes(StandardCharsets.ISO_8859_1),
            "2: byte 0xE4 is not UTF-8, the text may be Latin-1; save it as UTF-8"),
        bad("garbage", "garbage\n".repeat(1_000_000), "1: \"garbage\" is not a number; " + FORM),
        bad(
            "a vertex twice",
            "# head\n0 0\n4 0\n4 4\n4 0\n0 4\n",
            "5: vertices v1 and v3 are both at (4, 0); remove one of them" + TOUCHING + HINT),
        bad(
            "on one line",
            "0 0\n1 1\n2 2\n5 5\n",
            "1: all vertices lie on one line; move at least one off it"),
        bad(
            "bow-tie",
            "0 0\n4 4\n4 0\n0 4\n",
            "1: edges v0–v1 and v2–v3 cross at (2, 2); move a vertex of one of them" + HINT),
        bad(
            "touching vertex",
            "0 0\n8 0\n8 8\n4 0\n0 8\n",
            "4: vertex v3 touches edge v0–v1 at (4, 0); move it off the edge" + TOUCHING + HINT),
        bad(
            "spike",
            "0 0\n4 0\n4 4\n4 9\n4 4.5\n0 4\n",
            "4: the boundary turns back along itself at vertex v3, (4, 9);"
                + " move or remove that vertex"
                + TOUCHING
                + HINT));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("badPolygons")
  void a_polygon(String name, byte[] bytes, String message) throws IOException {
    Path file = Files.write(folder.resolve("in.txt"), bytes);
    assertRefused(file, file + ":" + message);
    Path named = Files.write(folder.resolve("in_polygonbased.txt"), bytes);
    assertRefused(named, named + ":" + message.replace(HINT, ""));
    assertThat(named).hasBinaryContent(bytes);
  }

  private static void assertRefused(Path input, String message, String... options) {
    for (String verb : new String[] {"check", "triangulate"}) {
      Object[] words =
          Stream.concat(Stream.of(verb, input.toString()), Stream.of(options)).toArray();
      CliRun run = CliRun.of(words);
      assertThat(run.err()).isEqualTo(message + "\n");
      assertThat(run.out()).isEmpty();
      assertThat(run.status()).isEqualTo(3);
    }
  }

  @Test
  void a_crossing_far_away_is_found_and_named() throws IOException {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 5000; i++) {
      text.append(i).append(' ').append(i % 2).append('\n');
    }
    text.append("5000 10\n2500.5 -5\n2499.5 -5\n0 10\n");
    Path file = Files.writeString(folder.resolve("far_polygonbased.txt"), text);
    CliRun run = CliRun.of("check", file);
    assertThat(run.status()).isEqualTo(3);
    assertThat(run.err())
        .startsWith(file + ":")
        .containsPattern(":\\d+: edges v\\d+–v\\d+ and v500[0123]–v\\d+ cross at ");
  }

  @Test
  void a_file_that_is_not_there() {
    Path missing = folder.resolve("missing.txt");
    assertRefused(missing, missing + ": there is no such file; check its name and folder");
    assertRefused(folder, folder + ": this is a folder; name a file in it");
    assertRefused(Path.of(""), "\"\": this is no name of a file; name one");
  }

  @Test
  void sites() throws IOException {
    Path two = Files.writeString(folder.resolve("two_pointbased.txt"), "0 0\n1 1\n");
    assertRefused(two, two + ":2: 2 sites; three or more are needed");
    String oneLine = "1: all sites lie on one line; move at least one off it";
    Path line = Files.writeString(folder.resolve("line_pointbased.txt"), "0 0\n2 2\n1 1\n3 3\n");
    assertRefused(line, line + ":" + oneLine);
    Path same = Files.writeString(folder.resolve("same.txt"), "0 0\n0 0\n0 0\n1 1\n");
    assertRefused(same, same + ":" + oneLine, "--as", "points");
  }

  @Test
  void json() throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("x.json"), "{\"points\": [\n[0, 0],\n[4, 4],\n[4, 0],\n[0, 4]]}");
    assertRefused(
        file,
        file + ":2: edges v0–v1 and v2–v3 cross at (2, 2); move a vertex of one of them" + HINT);
    Path cut = Files.writeString(folder.resolve("cut.json"), "{\"points\": [[0, 0],\n[4");
    assertRefused(cut, cut + ":2: the JSON text ends too early; restore the rest of the file");
  }

  @Test
  void standard_input_is_called_by_its_dash() {
    CliRun run = CliRun.withInput("0 0\n1\n", "check", "-");
    assertThat(run.status()).isEqualTo(3);
    assertThat(run.err()).isEqualTo("-:2: there is only one number; " + FORM + "\n");
  }
}
