package dct.ui.dialog;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is kept of the program's own faults, and where. */
class FaultLogTest {
  private static final long MOST = FaultLog.MOST_BYTES + 200_000; // one fault more

  @TempDir Path folder;

  @Test
  void aFaultIsOneSentenceAndItsDetailsAreInTheFile() throws IOException {
    Path logs = folder.resolve("not").resolve("there");
    String sentence = new FaultLog(logs).keep(new IllegalStateException("broken"));
    Path file = logs.resolve("faults.log");
    assertThat(sentence)
        .isEqualTo(
            "This should not have happened: java.lang.IllegalStateException: broken."
                + " Please report it; the details are in "
                + file
                + ".");
    assertThat(file)
        .content()
        .contains("IllegalStateException: broken")
        .contains("at dct.ui.dialog.FaultLogTest");
  }

  @Test
  void theFileStaysSmall() throws IOException {
    FaultLog log = new FaultLog(folder);
    IllegalStateException fault = new IllegalStateException("x".repeat(100_000));
    for (int i = 0; i < 10; i++) {
      log.keep(fault);
    }
    assertThat(folder.resolve("faults.log").toFile().length()).isLessThan(MOST);
    assertThat(folder.resolve("faults.1.log").toFile().length()).isLessThan(MOST);
    assertThat(folder.toFile().list()).hasSize(2);
  }

  @Test
  void aFolderThatCannotBeMadeLosesOnlyTheDetails() throws IOException {
    Path file = Files.writeString(folder.resolve("file"), "");
    assertThat(new FaultLog(file.resolve("below")).keep(new IllegalStateException("broken")))
        .endsWith("broken. Please report it.");
  }

  @Test
  void theFolderIsTheUsersOwn() {
    assertThat(FaultLog.folder("Linux", Map.of(), "/home/a"))
        .isEqualTo(Path.of("/home/a/.local/state/dct"));
    assertThat(FaultLog.folder("Linux", Map.of("XDG_STATE_HOME", "/s"), "/home/a"))
        .isEqualTo(Path.of("/s/dct"));
    assertThat(FaultLog.folder("Mac OS X", Map.of(), "/Users/a"))
        .isEqualTo(Path.of("/Users/a/Library/Logs/dct"));
    assertThat(FaultLog.folder("Windows 11", Map.of("LOCALAPPDATA", "C:/a"), "C:/Users/a"))
        .isEqualTo(Path.of("C:/a/dct"));
  }
}
