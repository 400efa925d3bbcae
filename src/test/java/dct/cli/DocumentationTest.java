package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dct.experiment.generate.PolygonShape;
import dct.experiment.generate.RegionShape;
import dct.experiment.generate.SiteShape;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import dct.io.Formats;
import dct.testing.Markdown;
import dct.testing.Markdown.Shell;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/** What README and the pages of docs say of commands, files and classes is so. */
class DocumentationTest {
  private static final String PROGRAM = "java -jar target/dct.jar ";
  private static final Pattern OPTION = Pattern.compile("(?<= )(--[a-z-]+|-[a-z])(?=[ =]|$)");
  private static final Pattern LINK = Pattern.compile("\\]\\(([^)#:]+)\\)");
  private static final Pattern WRITTEN = Pattern.compile("`(\\.[a-z.]+)`");
  private static final Pattern ENDING = Pattern.compile("(?<=[\\s`])(\\.[a-z]+)+(?=[,;`\\s])");
  private static final Pattern CLASS =
      Pattern.compile("`([A-Z][a-z][A-Za-z0-9]*)(?:\\.[A-Za-z0-9]+)?`");

  private static final Pattern MAIN = Pattern.compile("\\b(dct\\.[a-z.]*[A-Z]\\w+)");

  @TempDir Path folder;

  /** Every block of README that begins with a prompt is run, and prints what stands there. */
  @Test
  void everyExampleOfTheReadmePrintsWhatItSays() throws IOException {
    Files.createDirectory(folder.resolve("samples"));
    for (Path sample : files(Path.of("samples"), ".txt")) {
      Files.copy(sample, folder.resolve(sample));
    }
    List<Shell> examples = Markdown.of(Path.of("README.md")).examples();
    assertThat(examples).hasSizeGreaterThanOrEqualTo(4);
    for (Shell example : examples) {
      assertThat(example.command()).startsWith(PROGRAM);
      assertThat(run(example.command().substring(PROGRAM.length())))
          .as(example.command())
          .isEqualTo(example.output());
    }
  }

  /** Runs the program as if the temporary folder were the current one. */
  private String run(String arguments) {
    List<String> words = new ArrayList<>();
    for (String word : arguments.split(" ", -1)) {
      words.add(word.endsWith(".txt") ? folder.resolve(word).toString() : word);
    }
    CliRun run = CliRun.of(words.toArray()).done();
    return run.out().replace(folder + "/", "");
  }

  @TestFactory
  Stream<DynamicTest> everyOptionOfEveryCommandExists() throws IOException {
    List<String> commands = new ArrayList<>();
    for (Path page : pages()) {
      for (String line : Markdown.of(page).codeLines()) {
        String command =
            line.replaceFirst("^\\$ ", "").replace(PROGRAM, "dct ").replaceFirst(" +# .*", "");
        if (command.startsWith("dct ") || command.startsWith("mvn ")) {
          commands.add(command);
        }
      }
    }
    assertThat(commands).hasSizeGreaterThan(12);
    return commands.stream().distinct().map(c -> DynamicTest.dynamicTest(c, () -> check(c)));
  }

  private static void check(String command) throws IOException {
    if (command.startsWith("mvn ")) {
      String pom = Files.readString(Path.of("pom.xml"));
      for (String word : command.split(" ", -1)) {
        if (word.startsWith("-P")) {
          assertThat(pom).contains("<id>" + word.substring(2) + "</id>");
        } else if (word.startsWith("-Dbench.") || word.startsWith("-Dgui.")) {
          assertThat(pom).contains("<" + word.substring(2, word.indexOf('=')) + ">");
        }
      }
      for (String name : groups(MAIN, command)) {
        Path file = Path.of(name.replace('.', '/') + ".java");
        assertThat(Stream.of("src/main/java", "src/test/java", "src/jmh/java"))
            .as(name)
            .anyMatch(root -> Files.exists(Path.of(root).resolve(file)));
      }
      return;
    }
    String verb = command.split(" ", -1)[1];
    String help = verb.startsWith("-") ? CliRun.of(verb).out() : CliRun.of(verb, "--help").out();
    for (String option : matches(OPTION, command)) {
      assertThat(help).as(command).containsPattern("(?m)^ .*" + option + "\\b");
    }
  }

  @Test
  void theReadmeListsTheShapesAndEndingsThatThereAre() throws IOException {
    String readme = Files.readString(Path.of("README.md"));
    String polygons = quoted(Arrays.stream(PolygonShape.values()).map(PolygonShape::word));
    String sites = quoted(Arrays.stream(SiteShape.values()).map(SiteShape::word));
    String regions = quoted(Arrays.stream(RegionShape.values()).map(RegionShape::word));
    assertThat(readme.replaceAll("\\s+", " "))
        .contains("Polygons: " + polygons + ".")
        .contains("Sites: " + sites + ".")
        .contains("Regions: " + regions + ".");
    String outputs = readme.substring(readme.indexOf("`-o` writes"), readme.indexOf("`--json`"));
    String help = CliRun.of("triangulate", "--help").out();
    assertThat(endings(outputs)).isEqualTo(endings(help.substring(help.indexOf("--output="))));
  }

  /** A row has what the format is, what is read, what is written, and what is lost. */
  private static List<List<String>> formatTable() throws IOException {
    return Files.readString(Path.of("README.md"))
        .lines()
        .dropWhile(line -> !line.startsWith("| Format |"))
        .skip(2)
        .takeWhile(line -> line.startsWith("|"))
        .map(line -> Arrays.stream(line.split("\\|", -1)).map(String::strip).toList())
        .map(cells -> cells.subList(1, cells.size() - 1))
        .toList();
  }

  @Test
  void theReadmesTableHasEveryFormatThatIsReadOrWritten() throws IOException {
    List<List<String>> rows = formatTable();
    assertThat(rows).isNotEmpty().allSatisfy(row -> assertThat(row).hasSize(4).doesNotContain(""));
    for (String title : Formats.titles()) {
      assertThat(rows)
          .as(title)
          .anyMatch(
              row -> row.get(0).matches(".*\\b" + title + "\\b.*") && !row.get(1).equals("–"));
    }
    Set<String> written = new TreeSet<>();
    rows.forEach(row -> written.addAll(groups(WRITTEN, row.get(2))));
    assertThat(written)
        .containsExactlyInAnyOrder(
            Arrays.stream(FileEnding.values())
                .filter(e -> e.holds(Content.POINTS, Content.TRIANGULATION, Content.PICTURE))
                .map(FileEnding::dotted)
                .toArray(String[]::new));
  }

  private static String quoted(Stream<String> words) {
    return words.map(word -> "`" + word + "`").collect(Collectors.joining(", "));
  }

  private static Set<String> endings(String text) {
    return new TreeSet<>(matches(ENDING, text));
  }

  @Test
  void everyLinkLeadsToAFile() throws IOException {
    for (Path page : pages()) {
      for (String link : groups(LINK, Files.readString(page))) {
        assertThat(page.resolveSibling(link)).as("in %s", page).exists();
      }
    }
  }

  @Test
  void everyClassThatThePagesNameExists() throws IOException {
    Set<String> classes = new TreeSet<>();
    for (Path file : files(Path.of("src"), ".java")) {
      classes.add(file.getFileName().toString().replace(".java", ""));
    }
    for (String page : List.of("docs/architecture.md", "CONTRIBUTING.md")) {
      String text = Files.readString(Path.of(page));
      assertThat(groups(CLASS, text)).as(page).isNotEmpty().isSubsetOf(classes);
    }
  }

  private static List<Path> pages() throws IOException {
    List<Path> pages = new ArrayList<>(files(Path.of("docs"), ".md"));
    pages.add(Path.of("README.md"));
    pages.add(Path.of("CONTRIBUTING.md"));
    return pages;
  }

  private static List<Path> files(Path folder, String ending) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      return files.filter(file -> file.toString().endsWith(ending)).sorted().toList();
    }
  }

  private static List<String> matches(Pattern pattern, String text) {
    return pattern.matcher(text).results().map(MatchResult::group).toList();
  }

  private static List<String> groups(Pattern pattern, String text) {
    return pattern.matcher(text).results().map(match -> match.group(1)).toList();
  }
}
