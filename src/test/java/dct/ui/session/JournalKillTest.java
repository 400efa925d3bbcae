package dct.ui.session;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import dct.testing.ProgramProcess;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** A real process draws and is killed: no more than the last edit is lost. */
class JournalKillTest {
  private static final int KILLS = 20;

  @TempDir Path folder;

  private Process writer() throws IOException {
    return start(command());
  }

  private List<String> command() {
    return List.of(
        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
        "-Djava.awt.headless=true",
        "-XX:TieredStopAtLevel=1",
        "-XX:-UsePerfData",
        "-cp",
        ProgramProcess.classPath(),
        JournalWriter.class.getName(),
        folder.toString());
  }

  private static Process start(List<String> command) throws IOException {
    return new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT).start();
  }

  /** Kills a writer as soon as it has said that it has drawn so many vertices. */
  private void killAfter(Process writer, int vertices) throws Exception {
    try (BufferedReader said = writer.inputReader(StandardCharsets.US_ASCII)) {
      String line = said.readLine();
      while (line != null && Integer.parseInt(line) < vertices) {
        line = said.readLine();
      }
      assertThat(line).isEqualTo(String.valueOf(vertices));
      writer.destroyForcibly();
      assertThat(writer.waitFor(30, TimeUnit.SECONDS)).isTrue();
    }
  }

  private static Points drawn(int vertices) {
    return Points.ofPairs(
        IntStream.rangeClosed(1, vertices)
            .boxed()
            .flatMapToDouble(k -> java.util.stream.DoubleStream.of(k, (double) k * k))
            .toArray());
  }

  @Test
  void aKilledProgramLosesAtMostOneEdit() throws Exception {
    Lane lane = new Lane();
    for (int k = 1; k <= KILLS; k++) {
      killAfter(writer(), k);
      List<Orphan> orphans = new Journals(folder, lane).orphans(unread -> {});
      Points back = orphans.isEmpty() ? Points.ofPairs() : orphans.get(0).document().points();
      assertThat(back.size()).isGreaterThanOrEqualTo(k - 1);
      assertThat(back).isEqualTo(drawn(back.size()));
      orphans.forEach(Orphan::discard);
      lane.await();
      assertThat(folder).isEmptyDirectory();
    }
  }

  /** A limit on the size of files stands for a full disk: the write that reaches it is cut. */
  @Test
  @EnabledOnOs(OS.LINUX)
  void aWriteThatFailsLeavesNoPartOfAStep() throws Exception {
    List<String> limited =
        new ArrayList<>(List.of("bash", "-c", "ulimit -f 2 && exec \"$@\"", "-"));
    limited.addAll(command());
    Process writer = start(limited);
    int vertices = 0;
    try (BufferedReader said = writer.inputReader(StandardCharsets.US_ASCII)) {
      for (String line = said.readLine(); line != null; line = said.readLine()) {
        vertices = Integer.parseInt(line);
      }
    }
    assertThat(writer.waitFor()).isEqualTo(1);
    try (Stream<Path> files = Files.list(folder)) {
      assertThat(files.filter(file -> file.toString().endsWith(JournalFile.ENDING)))
          .singleElement()
          .satisfies(journal -> assertThat(Files.readString(journal)).endsWith("\nend\n"));
    }
    List<Orphan> orphans = new Journals(folder, new Lane()).orphans(unread -> {});
    assertThat(orphans).hasSize(1);
    assertThat(orphans.get(0).document().points()).isEqualTo(drawn(vertices - 1));
  }

  @Test
  void theJournalOfALivingProgramIsItsOwn() throws Exception {
    Process living = writer();
    Process dead = writer();
    try (BufferedReader said = living.inputReader(StandardCharsets.US_ASCII)) {
      assertThat(said.readLine()).isEqualTo("1");
      assertThat(said.readLine()).isEqualTo("2"); // so that the first vertex is in its journal
      killAfter(dead, 5);
      Journals journals = new Journals(folder, new Lane());
      assertThat(journals.orphans(unread -> {}))
          .singleElement()
          .satisfies(orphan -> assertThat(orphan.document().size()).isGreaterThanOrEqualTo(4));
      assertThat(journals.orphans(unread -> {})).isEmpty(); // it is taken
    } finally {
      living.destroyForcibly();
      living.waitFor();
    }
  }
}
