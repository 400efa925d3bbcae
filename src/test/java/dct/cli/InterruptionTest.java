package dct.cli;

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
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Ctrl+C, on the program as a process of its own. */
class InterruptionTest {
  @TempDir Path folder;

  @BeforeEach
  void needsSignals() {
    assumeTrue(Files.isExecutable(Path.of("/bin/kill")), "skipped: there is no kill here");
  }

  /** Sends a signal such as INT, which is Ctrl+C. */
  private static void send(String signal, Process to) throws Exception {
    String[] kill = {"/bin/kill", "-" + signal, Long.toString(to.pid())};
    assertThat(new ProcessBuilder(kill).start().waitFor()).isZero();
  }

  /** Starts the program on standard input; it works once it has all of it. */
  private static Process start(byte[] input, String... arguments) throws IOException {
    Process process = ProgramProcess.of(List.of(), arguments).start();
    process.getOutputStream().write(input);
    process.getOutputStream().close();
    return process;
  }

  private static byte[] generated(String... words) {
    return CliRun.of((Object[]) words).done().out().getBytes(StandardCharsets.UTF_8);
  }

  /** Sends a signal again and again until the process has ended; the first may come too early. */
  private static void sendUntilEnd(String signal, Process process) throws Exception {
    send(signal, process);
    while (!process.waitFor(2, TimeUnit.SECONDS)) {
      new ProcessBuilder("/bin/kill", "-" + signal, Long.toString(process.pid())).start().waitFor();
    }
  }

  /** Both searches go on for many times the processor time that is waited for. */
  @ParameterizedTest
  @CsvSource({"INT, polygon, convex, 30000, odd", "TERM, points, lattice, 20000, odd"})
  void a_search_that_is_stopped_writes_the_best_so_far(
      String signal, String kind, String shape, String n, String goal) throws Exception {
    Path result = folder.resolve("best.json");
    byte[] input = generated("generate", kind, "-n", n, "--shape", shape);
    Process process = start(input, "triangulate", "-", "--optimize", goal, "-o", result.toString());
    awaitWork(process, 2000);
    send(signal, process);
    String said = ProgramProcess.text(process.getErrorStream());
    assertThat(process.waitFor()).as(said).isEqualTo(130);
    assertThat(said).isEqualTo("dct triangulate: stopped; the result is the best found so far\n");
    assertThat(ProgramProcess.text(process.getInputStream())).contains("best found so far");
    CliRun verified = CliRun.of("verify", result);
    assertThat(verified.err()).isEmpty();
    assertThat(verified.out()).contains("verified");
  }

  /** Waits until so many milliseconds of processor time are used, or the process has ended. */
  private static void awaitWork(Process process, long millis) throws InterruptedException {
    while (process.isAlive()
        && process.info().totalCpuDuration().map(d -> d.toMillis() < millis).orElse(false)) {
      TimeUnit.MILLISECONDS.sleep(20);
    }
  }

  @Test
  void an_algorithm_that_is_stopped_leaves_nothing() throws Exception {
    Path result = folder.resolve("r.json");
    Process process =
        start(
            generated("generate", "points", "-n", "400000"),
            "triangulate",
            "-",
            "--as",
            "points",
            "-o",
            result.toString());
    awaitWork(process, 400);
    sendUntilEnd("INT", process);
    assertThat(process.exitValue()).isEqualTo(130);
    assertThat(ProgramProcess.text(process.getErrorStream())).isEmpty();
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void a_verb_that_waits_for_its_input_ends_at_once() throws Exception {
    Process process = ProgramProcess.of(List.of(), "triangulate", "-").start();
    awaitWork(process, 100);
    send("INT", process);
    assertThat(process.waitFor(10, TimeUnit.SECONDS)).isTrue();
    assertThat(process.exitValue()).isEqualTo(130);
  }

  @Test
  void a_second_one_ends_the_program_at_once() throws Exception {
    // Standard output is a pipe that nobody empties, so that the first one cannot come to an end.
    Process process = ProgramProcess.of(List.of(), "generate", "points", "-n", "300000").start();
    try (BufferedReader out = process.inputReader(StandardCharsets.UTF_8)) {
      assertThat(out.readLine()).isEqualTo("# kind: points");
      send("INT", process);
      assertThat(process.waitFor(1, TimeUnit.SECONDS)).isFalse();
      send("INT", process);
      assertThat(process.waitFor(10, TimeUnit.SECONDS)).isTrue();
    }
    assertThat(process.exitValue()).isEqualTo(130);
  }
}
