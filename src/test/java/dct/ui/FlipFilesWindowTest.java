package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.swing.SwingUtilities;
import org.assertj.swing.finder.JFileChooserFinder;
import org.assertj.swing.fixture.JFileChooserFixture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;

/** Lists of flips that are saved and loaded again. */
class FlipFilesWindowTest extends WindowTest {
  /** Not removed: a window that closes may still write its settings there. */
  @TempDir(cleanup = CleanupMode.NEVER)
  Path folder;

  @Test
  void flipsThatWereSavedAreCarriedOutAgainAsOneStep() throws Exception {
    onEventThread(
        () -> {
          window.open(Path.of("samples", "figure_3_12_sites_pointbased.txt"));
          return null;
        });
    await("the sites", () -> window.getTitle().startsWith("figure_3_12"));
    push("Perform Flip");
    List<String> flipped = counts();
    Path file = folder.resolve("f.txt");
    name("Save Flips…", "Save Flips", file);
    await("the file", () -> Files.exists(file));
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(counts()).isNotEqualTo(flipped);
    name("Load Flips…", "Load Flips", file);
    await("the flips", () -> counts().equals(flipped));
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(counts()).isNotEqualTo(flipped);
  }

  private List<String> counts() {
    return onEventThread(() -> List.copyOf(canvas().scene().counts()));
  }

  /** Answers the file panel of a command, which has this title. */
  private void name(String command, String title, Path file) {
    SwingUtilities.invokeLater(() -> window.commands().get(command).perform());
    JFileChooserFixture panel =
        JFileChooserFinder.findFileChooser().withTimeout(PATIENCE_MILLIS).using(robot);
    assertThat(onEventThread(() -> panel.target().getDialogTitle())).isEqualTo(title);
    onEventThread(
        () -> {
          panel.target().setSelectedFile(file.toFile());
          panel.target().approveSelection();
          return null;
        });
    settle();
  }
}
