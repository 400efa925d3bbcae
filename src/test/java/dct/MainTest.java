package dct;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dct.testing.ProgramProcess;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The program as a process of its own. */
class MainTest {
  @TempDir Path folder;

  @Test
  void the_command_line_runs_and_gives_its_status() throws IOException, InterruptedException {
    Path file = Files.writeString(folder.resolve("t.txt"), "0 0\n4 0\n0 4\n");
    Process good = ProgramProcess.of(List.of(), "check", file.toString()).start();
    assertThat(ProgramProcess.text(good.getInputStream()))
        .isEqualTo(file + ": a simple polygon with 3 vertices, counter-clockwise\n");
    assertThat(ProgramProcess.text(good.getErrorStream())).isEmpty();
    assertThat(good.waitFor()).isZero();
    Files.writeString(file, "0 0\n4 4\n4 0\n0 4\n");
    Process bad = ProgramProcess.of(List.of(), "check", file.toString()).start();
    assertThat(ProgramProcess.text(bad.getErrorStream()))
        .isEqualTo(
            file
                + ":1: edges v0–v1 and v2–v3 cross at (2, 2); move a vertex of one of them,"
                + " or read the file as sites with --as points\n");
    assertThat(bad.waitFor()).isEqualTo(3);
  }

  @Test
  void a_picture_for_a_full_disk_ends_the_program_with_the_cause() throws Exception {
    assumeTrue(Files.isWritable(Path.of("/dev/full")), "there is no such device here");
    Path full = Files.createSymbolicLink(folder.resolve("full.png"), Path.of("/dev/full"));
    Path file = Files.writeString(folder.resolve("t.txt"), "0 0\n4 0\n0 4\n");
    Process process =
        ProgramProcess.of(List.of(), "convert", file.toString(), "-o", full.toString()).start();
    try {
      assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
      assertThat(ProgramProcess.text(process.getErrorStream()))
          .contains("No space left on device")
          .doesNotContain("fault of the program");
      assertThat(process.exitValue()).isEqualTo(1);
    } finally {
      process.destroyForcibly();
    }
  }

  @Test
  void a_closed_pipe_is_no_error_message() throws IOException, InterruptedException {
    Process process = ProgramProcess.of(List.of(), "generate", "points", "-n", "300000").start();
    try (BufferedReader out = process.inputReader(StandardCharsets.UTF_8)) {
      assertThat(out.readLine()).isEqualTo("# kind: points");
    }
    assertThat(ProgramProcess.text(process.getErrorStream())).isEmpty();
    assertThat(process.waitFor()).isEqualTo(1);
  }

  @Test
  void a_heap_that_is_too_small_gives_one_clear_sentence()
      throws IOException, InterruptedException {
    StringBuilder circle = new StringBuilder();
    for (int k = 0; k < 100_000; k++) {
      double angle = 2 * Math.PI * k / 100_000;
      circle.append(Math.cos(angle)).append(' ').append(Math.sin(angle)).append('\n');
    }
    String file = Files.writeString(folder.resolve("circle.txt"), circle).toString();
    Process process =
        ProgramProcess.of(List.of("-Xmx24m"), "triangulate", file, "--optimize", "odd").start();
    assertThat(ProgramProcess.text(process.getInputStream())).isEmpty();
    assertThat(ProgramProcess.text(process.getErrorStream()))
        .isEqualTo(
            "dct: there is not enough memory; give Java more with -Xmx, for instance -Xmx4g\n");
    assertThat(process.waitFor()).isEqualTo(1);
  }

  @Test
  void without_a_display_the_window_says_so() throws IOException, InterruptedException {
    assertNoDisplay(ProgramProcess.of(List.of("-Djava.awt.headless=true")));
    Path file = Files.writeString(folder.resolve("t_pointbased.txt"), "0 0\n4 0\n0 4\n");
    assertNoDisplay(ProgramProcess.of(List.of("-Djava.awt.headless=true"), file.toString()));
  }

  @Test
  void with_a_display_that_cannot_be_reached_the_window_says_so()
      throws IOException, InterruptedException {
    assumeTrue(
        System.getProperty("os.name").equals("Linux"), "skipped: displays have no names here");
    ProcessBuilder program = ProgramProcess.of(List.of("-Djava.awt.headless=false"));
    program.environment().put("DISPLAY", ":7654321");
    assertNoDisplay(program);
  }

  private static void assertNoDisplay(ProcessBuilder program)
      throws IOException, InterruptedException {
    Process process = program.start();
    assertThat(ProgramProcess.text(process.getErrorStream()))
        .isEqualTo("dct: there is no display for the window; use the command line, dct --help\n");
    assertThat(ProgramProcess.text(process.getInputStream())).isEmpty();
    assertThat(process.waitFor()).isEqualTo(1);
  }
}
