package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FileArgumentsTest {

  @Test
  void names_of_files_are_told_from_commands(@TempDir Path folder) throws IOException {
    Path file = Files.writeString(folder.resolve("t_pointbased.txt"), "");
    Path other = Files.writeString(folder.resolve("u.txt"), "");
    String shortName = folder.resolve("t").toString();
    assertThat(FileArguments.of()).hasValueSatisfying(files -> assertThat(files).isEmpty());
    assertThat(FileArguments.of(shortName, other.toString()))
        .hasValueSatisfying(files -> assertThat(files).containsExactly(file, other));
    assertThat(FileArguments.of(file.toString(), "missing.txt")).isEmpty();
    assertThat(FileArguments.of("check", file.toString())).isEmpty();
    assertThat(FileArguments.of("--help")).isEmpty();
    assertThat(FileArguments.of(folder.toString())).isEmpty();
    assertThat(FileArguments.of("\0")).isEmpty();
  }
}
