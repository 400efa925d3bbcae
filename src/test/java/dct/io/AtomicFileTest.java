package dct.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dct.core.Progress;
import dct.testing.ProgramProcess;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AtomicFileTest {
  @TempDir Path folder;

  private static AtomicFile.Content text(String text) {
    return out -> out.write(text.getBytes(StandardCharsets.UTF_8));
  }

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
  }

  @Test
  void writes_a_new_file_and_nothing_else() throws IOException {
    Path file = folder.resolve("new.txt");
    AtomicFile.write(file, Progress.NONE, text("1 2\n"));
    assertThat(file).hasContent("1 2\n");
    assertThat(names()).containsExactly("new.txt");
  }

  @Test
  void replaces_a_file_and_keeps_its_permissions() throws IOException {
    Path file = Files.writeString(folder.resolve("old.txt"), "old");
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r-----"));
    AtomicFile.write(file, Progress.NONE, text("new"));
    assertThat(file).hasContent("new");
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
        .isEqualTo("rw-r-----");
  }

  @Test
  void writes_what_a_symbolic_link_leads_to() throws IOException {
    Path file = Files.writeString(folder.resolve("file.txt"), "old");
    Path link = Files.createSymbolicLink(folder.resolve("link.txt"), Path.of("file.txt"));
    Path dangling = Files.createSymbolicLink(folder.resolve("ahead.txt"), Path.of("later.txt"));
    AtomicFile.write(link, Progress.NONE, text("new"));
    AtomicFile.write(dangling, Progress.NONE, text("made"));
    assertThat(link).isSymbolicLink();
    assertThat(file).hasContent("new");
    assertThat(dangling).isSymbolicLink();
    assertThat(folder.resolve("later.txt")).hasContent("made");
  }

  @Test
  void keeps_the_old_file_when_writing_fails_half_way() throws IOException {
    Path file = Files.writeString(folder.resolve("old.txt"), "old");
    assertThatThrownBy(
            () ->
                AtomicFile.write(
                    file,
                    Progress.NONE,
                    out -> {
                      out.write(new byte[1 << 20]);
                      throw new IOException("No space left on device");
                    }))
        .isInstanceOf(CannotWriteException.class)
        .hasMessage(
            file
                + ": cannot be written, No space left on device;"
                + " nothing was changed, choose another place");
    assertThat(file).hasContent("old");
    assertThat(names()).containsExactly("old.txt");
  }

  @Test
  void keeps_the_old_file_when_the_content_cannot_be_made() throws IOException {
    Path file = Files.writeString(folder.resolve("old.txt"), "old");
    assertThatThrownBy(
            () ->
                AtomicFile.write(
                    file,
                    Progress.NONE,
                    out -> {
                      throw new IllegalStateException();
                    }))
        .isInstanceOf(IllegalStateException.class);
    assertThat(file).hasContent("old");
    assertThat(names()).containsExactly("old.txt");
  }

  @Test
  void refuses_a_folder() {
    assertRefused(folder, "it is a folder");
  }

  @Test
  void refuses_a_place_in_a_missing_folder() {
    assertRefused(folder.resolve("none/file.txt"), "its folder does not exist");
  }

  @Test
  void refuses_a_place_below_a_file() throws IOException {
    Files.writeString(folder.resolve("file"), "old");
    assertRefused(folder.resolve("file/below.txt"), "Not a directory");
    assertThat(folder.resolve("file")).hasContent("old");
  }

  @Test
  void refuses_links_in_a_circle() throws IOException {
    Path one = folder.resolve("one");
    Files.createSymbolicLink(one, Path.of("two"));
    Files.createSymbolicLink(folder.resolve("two"), Path.of("one"));
    assertRefused(one, "its symbolic links go in a circle");
  }

  @Test
  void says_that_a_device_is_full_and_leaves_the_device() {
    Path full = Path.of("/dev/full");
    assumeTrue(Files.exists(full), "skipped: this system has no /dev/full");
    assertRefused(full, "No space left on device");
    assertThat(Files.exists(full) && !Files.isRegularFile(full)).isTrue();
  }

  private void assertRefused(Path file, String reason) {
    assertThatThrownBy(() -> AtomicFile.write(file, Progress.NONE, text("1 2\n")))
        .isInstanceOf(CannotWriteException.class)
        .hasMessage(
            "%s: cannot be written, %s; nothing was changed, choose another place"
                .formatted(file, reason));
  }

  @Test
  void removes_what_killed_writers_left_and_nothing_else() throws IOException {
    for (int i = 0; i < 3; i++) {
      Files.writeString(folder.resolve(".dct-" + UUID.randomUUID() + ".tmp"), "half");
    }
    Files.writeString(folder.resolve(".dct-note.tmp"), "not ours");
    AtomicFile.write(folder.resolve("a.txt"), Progress.NONE, text("1 2\n"));
    assertThat(names()).containsExactly(".dct-note.tmp", "a.txt");
  }

  @Test
  void leaves_the_temporary_file_of_a_writer_at_work_in_this_process() throws IOException {
    Path outer = folder.resolve("outer.txt");
    AtomicFile.write(
        outer,
        Progress.NONE,
        out -> {
          out.write('1');
          AtomicFile.write(folder.resolve("inner.txt"), Progress.NONE, text("2"));
          out.write('3');
        });
    assertThat(outer).hasContent("13");
    assertThat(names()).containsExactly("inner.txt", "outer.txt");
  }

  @Test
  void leaves_the_temporary_file_of_a_writer_at_work_in_another_process() throws Exception {
    Path live = folder.resolve(".dct-" + UUID.randomUUID() + ".tmp");
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                ProgramProcess.classPath(),
                AtomicFileTest.class.getName(),
                live.toString())
            .start();
    assertThat(process.getInputStream().read()).as("it holds the lease").isEqualTo('.');
    AtomicFile.write(folder.resolve("a.txt"), Progress.NONE, text("1"));
    assertThat(names()).containsExactly(live.getFileName().toString(), "a.txt");
    process.destroyForcibly();
    process.waitFor();
    AtomicFile.write(folder.resolve("a.txt"), Progress.NONE, text("2"));
    assertThat(names()).containsExactly("a.txt");
  }

  /** A writer that never comes to its end. */
  public static void main(String[] arguments) throws Exception {
    try (FileLease lease = FileLease.take(Path.of(arguments[0])).orElseThrow()) {
      System.out.print(lease.channel().isOpen() ? '.' : '-');
      System.out.flush();
      TimeUnit.MINUTES.sleep(10);
    }
  }
}
