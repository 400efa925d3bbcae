package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The same bytes and the same sentences in every locale. */
class LocaleTest {
  /** Arabic, Persian and Devanagari digits; a Turkish i without a dot; a decimal comma. */
  private static final List<String> TAGS =
      List.of("ar-EG", "ar-EG-u-nu-arab", "fa-IR", "hi-IN-u-nu-deva", "tr-TR", "de-DE");

  private static final List<String> BAD_TEXTS =
      List.of(
          "",
          "0 0\n1 1",
          "0 0\n10 10\n10 0\n0 10\n",
          "0 0\n1 0\n0 0\n1 1\n",
          "0 0\n3 3\nx 5\n",
          "0 0\n1,5 2,5\n",
          "0 0\n1,000 2,000\n",
          "0 0\n1 2 3 4\n",
          "0 0\n1e999 2\n",
          "0 0\nNaN 2\n",
          "{\"points\": [[0, 0], [1, 0]]}",
          "{\"points\": [[0, 0], [1, 0}");

  private final Locale before = Locale.getDefault();

  @TempDir Path folder;

  @AfterEach
  void restore() {
    Locale.setDefault(before);
  }

  @Test
  void files_and_messages_do_not_depend_on_it() throws IOException {
    Locale.setDefault(Locale.ROOT);
    Map<String, String> expected = everything();
    for (String tag : TAGS) {
      Locale.setDefault(Locale.forLanguageTag(tag));
      Map<String, String> seen = everything();
      assertThat(seen.keySet()).as(tag).isEqualTo(expected.keySet());
      expected.forEach(
          (name, bytes) -> assertThat(seen.get(name)).as(tag + " " + name).isEqualTo(bytes));
    }
  }

  /** What every verb prints and writes, by the name of the file or the words typed. */
  private Map<String, String> everything() throws IOException {
    Map<String, String> seen = new TreeMap<>();
    for (String sample : List.of("star_polygonbased.txt", "random_50_pointbased.txt")) {
      triangulate(Path.of("samples", sample), seen);
    }
    studies(seen);
    generate(seen);
    faults(seen);
    wrongUsages(seen);
    try (Stream<Path> files = Files.list(folder)) {
      for (Path file : files.sorted().toList()) {
        seen.put(file.getFileName().toString(), withoutTimes(Files.readAllBytes(file)));
        Files.delete(file);
      }
    }
    return seen;
  }

  private void triangulate(Path input, Map<String, String> seen) throws IOException {
    List<Object> words = new ArrayList<>(List.of("triangulate", input, "--flip"));
    String name = input.getFileName().toString().replace(".txt", "");
    for (String ending :
        List.of("json", "svg", "png", "pdf", "ipe", "tex", "off", "txt", "SVG", "IPE")) {
      words.add("-o");
      words.add(folder.resolve((ending.equals("txt") ? "" : "a_") + name + "." + ending));
    }
    run(seen, words.toArray());
    run(seen, "triangulate", input, "--optimize", "even", "--json");
    Path wishes = Files.writeString(folder.resolve("wishes"), "0 even\n1 odd\n12 EVEN\n");
    run(seen, "triangulate", input, "--optimize", wishes);
    Path result = folder.resolve("a_" + name + ".json");
    run(seen, "verify", result);
    String text = Files.readString(result);
    run(seen, "verify", Files.writeString(result, text.replaceFirst("\"odd\": ", "\"odd\": 1")));
    run(seen, "check", input);
    run(seen, "convert", input, "-o", folder.resolve("b_" + name + ".json"));
  }

  private void studies(Map<String, String> seen) {
    for (String kind : List.of("points", "polygons")) {
      List<Object> words = new ArrayList<>(List.of("experiment", kind, "--times"));
      words.addAll(List.of("--sizes", "50,1100", "--sets", "2", "--threads", "1"));
      words.addAll(List.of("--shapes", kind.equals("points") ? "uniform" : "comb,spiral"));
      for (String ending : List.of("csv", "md", "tex", "svg", "png")) {
        words.add("-o");
        words.add(folder.resolve(kind + "." + ending));
      }
      run(seen, words.toArray());
    }
    run(seen, "experiment", "points", "--sizes", "1-2:3:4");
    run(seen, "experiment", "points", "--sizes", "50", "--threads", "1000000");
  }

  private void generate(Map<String, String> seen) {
    run(seen, "generate", "points", "-n", "40", "-o", folder.resolve("g_pointbased.txt"));
    run(seen, "generate", "points", "-n", "4000000000");
    run(seen, "generate", "points", "-n", "1234567890");
    run(seen, "generate", "polygon", "-n", "2");
    run(seen, "generate", "--help");
  }

  private void faults(Map<String, String> seen) throws IOException {
    for (int i = 0; i < BAD_TEXTS.size(); i++) {
      Path file = Files.writeString(folder.resolve("bad" + i), BAD_TEXTS.get(i));
      run(seen, "check", file);
      run(seen, "triangulate", file, "--as", "points");
    }
    Path wishes = Files.writeString(folder.resolve("wishes"), "999 even\n");
    run(seen, "triangulate", "samples/star_polygonbased.txt", "--optimize", wishes);
  }

  private void wrongUsages(Map<String, String> seen) {
    run(seen, "triangulate", "a", "b", "c");
    run(seen, "triangulate", "a", "--seed", "x");
    run(seen, "triangulate", "a", "--algorithm", "x");
    run(seen, "triangulate", "a", "-o", "x.bmp");
    run(seen, "nosuchverb");
  }

  private void run(Map<String, String> seen, Object... words) {
    CliRun run = CliRun.of(words);
    String said = run.status() + "\n" + run.out() + run.err();
    seen.put(List.of(words).toString(), withoutTimes(said.getBytes(StandardCharsets.UTF_8)));
  }

  /** The bytes as a text, a byte a character, without times and the widths that they give. */
  private static String withoutTimes(byte[] bytes) {
    return new String(bytes, StandardCharsets.ISO_8859_1)
        .replaceAll("\"millis\": ?\\{[^}]*}", "")
        .replaceAll("[0-9]+\\.[0-9]{3}(?=[,\\n |&])", "TIME")
        .replaceAll(" +", " ")
        .replaceAll("-+", "-");
  }
}
