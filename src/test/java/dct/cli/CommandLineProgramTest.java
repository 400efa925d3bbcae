package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What holds for every verb: help, version, wrong usage, streams that fail. */
class CommandLineProgramTest {
  private static final String SQUARE = "0 0\n10 0\n10 10\n0 10\n";

  @Test
  void the_help_names_every_verb() {
    CliRun run = CliRun.of("--help").done();
    assertThat(run.out())
        .startsWith("Usage: dct")
        .contains("triangulate", "generate", "convert", "check", "verify", "Exit status");
  }

  @ParameterizedTest
  @ValueSource(strings = {"triangulate", "generate", "convert", "check", "verify"})
  void every_verb_has_help_and_version(String verb) {
    assertThat(Verb.isVerb(verb)).isTrue();
    assertThat(CliRun.of(verb, "--help").done().out()).startsWith("Usage: dct " + verb);
    assertThat(CliRun.of(verb, "--version").done().out()).startsWith("dct ");
  }

  @ParameterizedTest
  @ValueSource(strings = {"triangulate", "generate", "experiment", "convert", "check", "verify"})
  void help_explains_each_verb(String verb) {
    assertThat(CliRun.of("help", verb).done()).isEqualTo(CliRun.of(verb, "--help"));
    assertThat(CliRun.of(verb, "--help").out()).contains("\nExample");
  }

  @Test
  void help_alone_explains_the_program() {
    assertThat(CliRun.of("help").done()).isEqualTo(CliRun.of("--help"));
    assertThat(CliRun.of("help").out()).contains("Verbs:\n  triangulate ", "  completion ");
  }

  /** In the order of the verbs, for one example reads what another has written. */
  @Test
  void the_examples_of_every_help_run(@TempDir Path folder) {
    List<String> examples = new ArrayList<>();
    for (String verb : Verb.NAMES) {
      CliRun.of("help", verb)
          .done()
          .out()
          .lines()
          .dropWhile(line -> !line.startsWith("Example"))
          .skip(1)
          .map(line -> line.strip().replaceFirst("^source <\\((.*?)\\).*", "$1"))
          .forEach(examples::add);
    }
    assertThat(examples).hasSizeGreaterThan(Verb.NAMES.size());
    for (String example : examples) {
      String input = "";
      for (String part : example.split(" [>|] ", -1)) {
        input = part.startsWith("dct ") ? run(part, input, folder) : "";
      }
    }
  }

  private static String run(String example, String input, Path folder) {
    Object[] words =
        Arrays.stream(example.split(" ", -1))
            .skip(1)
            .map(word -> word.matches("[a-z_]+\\.[a-z]+") ? folder.resolve(word) : word)
            .toArray();
    return CliRun.withInput(input, words).done().out();
  }

  @Test
  void the_version_is_one_line() {
    assertThat(CliRun.of("--version").done().out()).matches("dct [^\n]+\n");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "'' | dct: a verb is missing; see dct --help",
        "frobnicate | dct: \"frobnicate\" is neither a verb nor a file; see dct --help",
        "trianglate a | dct: \"trianglate\" is neither a verb nor a file"
            + " (did you mean triangulate?); see dct --help",
        "pom.xml extra | dct: \"extra\" is no file; see dct --help",
        "pom.xml --flip | dct: a verb is missing, it comes before files and options;"
            + " see dct --help",
        "pom.xml check | dct: a verb is missing, it comes before files and options; see dct --help",
        "--flip a | dct: --flip is no option of dct, a verb comes first; see dct --help",
        "triangulate | dct triangulate: INPUT is missing; see dct triangulate --help",
        "triangulate a b | dct triangulate: \"b\" is one argument too many, leave it out;"
            + " a name with blanks needs quotes; see dct triangulate --help",
        "triangulate --flop a | dct triangulate: --flop is no option of dct triangulate"
            + " (did you mean --flip?); see dct triangulate --help",
        "triangulate --flop=1 a | dct triangulate: --flop is no option of dct triangulate"
            + " (did you mean --flip?); see dct triangulate --help",
        "triangulate a -x | dct triangulate: -x is no option of dct triangulate;"
            + " see dct triangulate --help",
        "triangulate a --json=yes | dct triangulate: --json takes no value, write it without one;"
            + " see dct triangulate --help",
        "triangulate a --as | dct triangulate: --as needs a value: polygon or points or region;"
            + " see dct triangulate --help",
        "triangulate a -o --json | dct triangulate: -o needs a value: OUTPUT;"
            + " see dct triangulate --help",
        "triangulate a --optimize even --time-limit 1,5 | dct triangulate: --time-limit 1,5 is not"
            + " a number, use one such as 2.5; see dct triangulate --help",
        "triangulate - --as point | dct triangulate: --as point is unknown (did you mean points?),"
            + " use polygon, points or region; see dct triangulate --help",
        "triangulate a -o b.pdx | dct triangulate: the ending of b.pdx is no format, use .txt,"
            + " .json, .wkt, .geojson, .node, .poly, .ele, .edge, .off, .obj, .instance.json,"
            + " .solution.json, .png, .svg, .pdf, .ipe or .tex; see dct triangulate --help",
        "triangulate a -o b | dct triangulate: the ending of b is no format, use .txt, .json, .wkt,"
            + " .geojson, .node, .poly, .ele, .edge, .off, .obj, .instance.json, .solution.json,"
            + " .png, .svg, .pdf, .ipe or .tex; see dct triangulate --help",
        "triangulate a --json -o - | dct triangulate: --json and -o - both want standard output,"
            + " leave one out; see dct triangulate --help",
        "help chek | dct help: the verb chek is unknown (did you mean check?), use triangulate,"
            + " generate, experiment, convert, check, verify, help or completion;"
            + " see dct help --help",
        "completion powershell | dct completion: the shell powershell is unknown, use bash, zsh or"
            + " fish; see dct completion --help",
        "triangulate - --as lines | dct triangulate: --as lines is unknown,"
            + " use polygon, points or region; see dct triangulate --help",
        "triangulate - --algorithm delaunay | dct triangulate: --algorithm delaunay is none for"
            + " a polygon, use monotone, ear-clipping, convex-even, convex-odd, constrained-delaunay;"
            + " see dct triangulate --help",
        "triangulate - --as points --algorithm monotone | dct triangulate: --algorithm monotone is"
            + " none for points, use delaunay; see dct triangulate --help",
        "triangulate - --algorithm monotnoe | dct triangulate: --algorithm monotnoe is none for"
            + " a polygon (did you mean monotone?), use monotone, ear-clipping, convex-even,"
            + " convex-odd, constrained-delaunay; see dct triangulate --help",
        "generate points | dct generate: -n N is missing; see dct generate --help",
        "generate points -n | dct generate: -n needs a value: N; see dct generate --help",
        "generate points -n x | dct generate: -n x is not a whole number, use one such as 100;"
            + " see dct generate --help",
        "generate points -n 5 --seed 99999999999999999999 | dct generate: --seed"
            + " 99999999999999999999 is too far from 0, use a smaller number;"
            + " see dct generate --help",
        "generate points -n 5 -n 6 | dct generate: -n is given twice, leave one out;"
            + " see dct generate --help",
        "generate points -n 0 | dct generate: the number of random sites is from 1 to 100000000;"
            + " 0 is not;"
            + " see dct generate --help",
        "generate circles -n 5 | dct generate: the kind circles is unknown, use points, polygon or region;"
            + " see dct generate --help",
        "generate points -n 5 --shape cluster | dct generate: --shape cluster is unknown"
            + " (did you mean clusters?), use uniform, disk, clusters, lattice, jittered-lattice,"
            + " circle or lines; see dct generate --help",
        "convert - | dct convert: -o OUTPUT is missing; see dct convert --help",
        "convert - -o - --to wtk | dct convert: --to wtk is unknown (did you mean wkt?), use txt,"
            + " json, wkt, geojson, node, poly, ele, edge, off, obj, instance.json, solution.json,"
            + " png, svg, pdf, ipe or tex; see dct convert --help",
      })
  void wrong_usage_is_one_line_and_status_2(String words, String message) {
    Object[] arguments = words.isEmpty() ? new Object[0] : words.split(" ", -1);
    CliRun run = CliRun.withInput(SQUARE, arguments);
    assertThat(run.err()).isEqualTo(message + "\n");
    assertThat(run.out()).isEmpty();
    assertThat(run.status()).isEqualTo(2);
  }

  @Test
  void a_name_may_begin_with_an_at_sign(@TempDir Path folder) throws IOException {
    Path options = Files.writeString(folder.resolve("options"), "--quiet");
    CliRun run = CliRun.of("check", "@" + options);
    assertThat(run.err())
        .isEqualTo("@" + options + ": there is no such file; check its name and folder\n");
    assertThat(run.status()).isEqualTo(3);
  }

  @ParameterizedTest
  @CsvSource({"check, 3", "verify, 3"})
  void quiet_leaves_the_fault_to_the_status(String verb, int status) {
    CliRun run = CliRun.withInput("0 0\n1 1\n", verb, "-", "--quiet");
    assertThat(run).isEqualTo(new CliRun(status, "", ""));
  }

  @Test
  void a_place_that_cannot_be_written_loses_nothing(@TempDir Path folder) throws IOException {
    Path file = Files.writeString(folder.resolve("file.txt"), "old");
    for (String ending : new String[] {".txt", ".json", ".png", ".svg"}) {
      Path below = file.resolve("below" + ending);
      CliRun run = CliRun.withInput(SQUARE, "triangulate", "-", "-o", below);
      assertThat(run.status()).isEqualTo(1);
      assertThat(run.err())
          .isEqualTo(
              below
                  + ": cannot be written, Not a directory;"
                  + " nothing was changed, choose another place\n");
      assertThat(run.out()).isEmpty();
    }
    assertThat(file).hasContent("old");
  }

  @Test
  void a_full_place_loses_nothing(@TempDir Path folder) throws IOException {
    Path full = Path.of("/dev/full");
    assumeTrue(Files.exists(full), "skipped: this system has no /dev/full");
    Path link = Files.createSymbolicLink(folder.resolve("full.txt"), full);
    CliRun run = CliRun.of("generate", "points", "-n", 10, "-o", link);
    assertThat(run.status()).isEqualTo(1);
    assertThat(run.err())
        .isEqualTo(
            link
                + ": cannot be written, No space left on device;"
                + " nothing was changed, choose another place\n");
    assertThat(link).isSymbolicLink();
    Files.delete(link);
  }

  @ParameterizedTest
  @CsvSource({
    "Broken pipe, ''",
    "No space left on device,"
        + " 'dct: standard input or output failed, No space left on device; try another\n'"
  })
  void a_standard_output_that_fails_gives_no_stack_trace(String reason, String message) {
    OutputStream failing =
        new OutputStream() {
          @Override
          public void write(int b) throws IOException {
            throw new IOException(reason);
          }
        };
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    Console console =
        new Console(
            new ByteArrayInputStream(new byte[0]),
            failing,
            new PrintStream(err, true, StandardCharsets.UTF_8));
    assertThat(CommandLineProgram.run(console, "generate", "points", "-n", "10")).isEqualTo(1);
    assertThat(err.toString(StandardCharsets.UTF_8)).isEqualTo(message);
  }

  @Test
  void numbers_have_a_point_whatever_the_locale() {
    Locale before = Locale.getDefault();
    Locale.setDefault(Locale.GERMANY);
    try {
      CliRun run = CliRun.withInput("0 0\n1.5 0\n0 2.5\n", "triangulate", "-", "-o", "-").done();
      assertThat(run.out()).contains("[1.5, 0],", "[0, 2.5]]").doesNotContain("1,5");
      CliRun bow = CliRun.withInput("0 0\n1 1\n1 0\n0 1\n", "check", "-");
      assertThat(bow.err()).contains("(0.5, 0.5)");
    } finally {
      Locale.setDefault(before);
    }
  }

  @Test
  void wrong_usage_repeats_a_word_without_its_control_characters() {
    String word = "a\u001b[31m\nb";
    String shown = "a<U+001B>[31m<U+000A>b";
    assertThat(CliRun.of(word).err()).contains("\"" + shown + "\" is neither");
    assertThat(CliRun.of("generate", "points", "-n", word).err())
        .contains(shown + " is not a whole number")
        .hasLineCount(1);
    assertThat(CliRun.of("generate", "points", "-n", "5", "--shape", word).err())
        .contains("--shape " + shown + " is unknown");
  }
}
