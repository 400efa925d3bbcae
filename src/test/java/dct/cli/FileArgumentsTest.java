package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FileArgumentsTest {

  @Test
  void a_file_that_looks_like_an_option_is_named_with_its_folder() throws IOException {
    Path file = Path.of("-usage.txt"); // in the folder of this process
    Files.writeString(file, "0 0\n1 0\n0 1\n");
    try {
      assertThat(CliRun.of("check", file).err())
          .isEqualTo(
              "dct check: INPUT is missing; for the file of this name write ./-usage.txt;"
                  + " see dct check --help\n");
      assertThat(CliRun.of("triangulate", "-", file).err())
          .startsWith("dct triangulate: -usage.txt is no option of dct triangulate; for the file");
      assertThat(CliRun.of("check", "./" + file).done().out()).contains("simple");
    } finally {
      Files.delete(file);
    }
  }

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
