package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dct.testing.ForeignDataTest;
import dct.testing.SharedData;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;

/** Every file of the shared data through the command line. */
class SharedDataTest {
  @TempDir Path folder;

  @ForeignDataTest
  void every_polygon_is_checked_triangulated_and_verified() {
    List<Path> files = SharedData.files("polygons");
    assertThat(files).isNotEmpty();
    for (Path file : files) {
      assertThat(CliRun.of("check", file).done().out()).startsWith(file + ": a simple polygon");
      for (String algorithm : List.of("monotone", "ear-clipping", "convex-even", "convex-odd")) {
        assertVerified(file, "--algorithm", algorithm);
      }
      assertVerified(file, "--flip", "--quiet");
    }
  }

  @ForeignDataTest
  void every_set_of_sites_is_checked_triangulated_and_verified() {
    List<Path> files = SharedData.files("points");
    assertThat(files).isNotEmpty();
    for (Path file : files) {
      CliRun check = CliRun.of("check", file, "--as", "points");
      if (check.status() == 3) {
        assertThat(check.err())
            .isEqualTo(file + ":1: all sites lie on one line; move at least one off it\n");
        assertThat(CliRun.of("triangulate", file, "--as", "points")).isEqualTo(check);
      } else {
        assertThat(check.done().out()).startsWith(file + ": ").contains(" usable sites");
        assertVerified(file, "--as", "points");
        assertVerified(file, "--as", "points", "--flip");
      }
    }
  }

  @ForeignDataTest
  void every_polygon_that_is_not_simple_is_refused_with_its_line() {
    List<Path> files = SharedData.files("not_simple");
    assertThat(files).isNotEmpty();
    for (Path file : files) {
      for (String verb : List.of("check", "triangulate")) {
        CliRun run = CliRun.of(verb, file);
        assertThat(run.status()).as(file.toString()).isEqualTo(3);
        assertThat(run.err()).startsWith(file + ":").matches("[^\n]*:[1-9]\\d*: [^\n]*; [^\n]*\n");
        assertThat(run.out()).isEmpty();
      }
    }
  }

  private void assertVerified(Path file, String... options) {
    Path result = folder.resolve("result.json");
    Object[] words = new Object[options.length + 4];
    words[0] = "triangulate";
    words[1] = file;
    words[2] = "-o";
    words[3] = result;
    System.arraycopy(options, 0, words, 4, options.length);
    CliRun.of(words).done();
    assertThat(CliRun.of("verify", result, "--input", file).done().out())
        .startsWith(result + ": verified: ");
  }
}
