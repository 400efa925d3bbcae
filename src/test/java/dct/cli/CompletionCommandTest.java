package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What the shells complete; bash is asked itself where it is there. */
class CompletionCommandTest {
  private static final Path BASH = Path.of("/bin/bash");

  /** Calls the function that completes "dct", as bash does when Tab is pressed. */
  private static final String PRESS_TAB =
      """
      source "$1"; shift
      function compopt() { echo "compopt $*"; }  # bash has one only while it completes
      COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=()
      _complete_dct dct "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD-1]}"
      echo "${COMPREPLY[*]}"
      complete -p dct
      """;

  @TempDir Path folder;
  private Path script;

  @BeforeEach
  void write() throws Exception {
    script = Files.writeString(folder.resolve("dct.bash"), CliRun.of("completion", "bash").out());
  }

  private String bash(String... words) throws Exception {
    assumeTrue(Files.isExecutable(BASH), "skipped: there is no bash here");
    String[] command = new String[words.length + 5];
    command[0] = BASH.toString();
    command[1] = "-c";
    command[2] = PRESS_TAB;
    command[3] = "bash";
    command[4] = script.toString();
    System.arraycopy(words, 0, command, 5, words.length);
    Process bash = new ProcessBuilder(command).redirectErrorStream(true).start();
    String said = new String(bash.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(bash.waitFor()).as(said).isZero();
    return said;
  }

  @ParameterizedTest
  @CsvSource({
    "dct tri, triangulate",
    "dct c, convert check completion",
    "dct triangulate --fl, --flip",
    "dct triangulate x --as poi, points",
    "dct triangulate x --optimize e, even",
    "dct generate points --shape clu, clusters",
    "dct generate po, points polygon",
    "dct completion b, bash",
    "dct help ver, verify",
    "dct check samp, ''"
  })
  void bash_completes(String typed, String offered) throws Exception {
    String said = bash(typed.split(" ", -1));
    assertThat(said.lines().findFirst().orElseThrow().strip()).isEqualTo(offered);
    assertThat(said)
        .as("files where nothing else is offered")
        .contains("complete -o default")
        .doesNotContain("+o");
  }

  @Test
  void zsh_takes_the_script_of_bash() {
    assertThat(CliRun.of("completion", "zsh").done().out())
        .isEqualTo(CliRun.of("completion", "bash").done().out())
        .contains("bashcompinit");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "-n __fish_use_subcommand -a check -d 'Is it a simple polygon, usable sites, or a region? Says what is"
            + " wrong, and where.'",
        "-n '__fish_seen_subcommand_from generate' -l shape -r -a 'uniform disk clusters",
        "-n '__fish_seen_subcommand_from triangulate' -s o -l output -r -d 'Where to.'",
        "-n '__fish_seen_subcommand_from check' -l quiet -d 'Print nothing.'",
        "-n '__fish_seen_subcommand_from completion' -a 'bash zsh fish'",
      })
  void fish_gets_a_line_for_each_thing(String line) {
    assertThat(CliRun.of("completion", "fish").done().out().lines())
        .allMatch(each -> each.startsWith("complete -c dct -n "))
        .anyMatch(each -> each.contains(line));
  }
}
