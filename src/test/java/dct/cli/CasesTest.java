package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Files as other programs write them, each named after what it shows: one reads as its author
 * meant, or one sentence says line, cause and cure. None is read as something else without a word.
 */
class CasesTest {
  private static final Path FOLDER = Path.of("src/test/resources/cases");

  /**
   * A line for each file: its name, and what {@code dct check} says of it; what was left out, or
   * what there is to choose from, behind a slash each.
   */
  static List<String> table() throws IOException {
    return Files.readAllLines(Path.of("src/test/resources/cases.txt"));
  }

  @ParameterizedTest
  @MethodSource("table")
  void is_read_as_meant_or_refused_in_one_sentence(String row) {
    String name = row.substring(0, row.indexOf(':'));
    CliRun run = CliRun.of("check", FOLDER.resolve(name));
    String said = (run.out() + run.err()).replace(FOLDER + "/", "");
    assertThat(said.strip().replaceAll("\n(  )?(" + name + ": )?", " / ")).isEqualTo(row);
    boolean isRefusal = row.matches("[^:]+(:\\d+)?: [^/]+; .+");
    assertThat(run.status()).isEqualTo(isRefusal ? 3 : 0);
    assertThat(said.chars().filter(c -> c < ' ' && c != '\n')).as("control characters").isEmpty();
  }

  @Test
  void every_file_has_a_row() throws IOException {
    try (Stream<Path> files = Files.list(FOLDER)) {
      assertThat(files.map(file -> file.getFileName().toString()))
          .containsExactlyInAnyOrderElementsOf(
              table().stream().map(row -> row.substring(0, row.indexOf(':'))).toList());
    }
  }

  @Test
  void blank_lines_part_groups_of_sites_and_rings_are_not_joined_by_a_conversion() {
    Path blocks = FOLDER.resolve("two_blocks.txt");
    assertThat(CliRun.of("check", blocks, "--as", "points").done().out()).contains("usable sites");
    assertThat(CliRun.of("convert", blocks, "-o", "-").status()).isEqualTo(3);
    CliRun.of("convert", blocks, "--as", "points", "-o", "-").done();
  }
}
