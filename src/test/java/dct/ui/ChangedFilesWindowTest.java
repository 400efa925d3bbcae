package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.io.PointFile;
import dct.ui.dialog.Placement;
import java.awt.Component;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.Timer;
import org.assertj.swing.exception.ComponentLookupException;
import org.assertj.swing.fixture.JOptionPaneFixture;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;

/** A file that another program or window writes to, or removes, while it is open. */
class ChangedFilesWindowTest extends WindowTest {
  private static final Points TRIANGLE = Points.ofPairs(100, 100, 500, 100, 300, 400);
  private static final Points SQUARE = Points.ofPairs(100, 100, 500, 100, 500, 400, 100, 400);

  @TempDir(cleanup = CleanupMode.NEVER)
  Path folder;

  private Path file;

  @BeforeEach
  void openFile() throws Exception {
    file = folder.resolve("shape_polygonbased.txt");
    write(TRIANGLE);
    open(file);
  }

  private void open(Path opened) {
    javax.swing.SwingUtilities.invokeLater(() -> window.open(opened));
    await(
        "the file",
        () -> onEventThread(() -> window.getTitle()).startsWith(opened.getFileName().toString()));
    settle();
  }

  private void write(Points points) throws Exception {
    PointFile.write(file, Domain.POLYGON, points, Progress.NONE);
  }

  private void awaitBar(String end) {
    await(
        "the bar",
        () -> {
          robot.waitForIdle();
          return bar().endsWith(end);
        });
    settle();
  }

  /** What the bar says; empty if it is not there. */
  private String bar() {
    try {
      return frame.label("fileChange").text();
    } catch (ComponentLookupException e) {
      return ""; // not showing
    }
  }

  private void awaitNoBar() {
    await("no bar", () -> bar().isEmpty());
  }

  private boolean isMarked() {
    return onEventThread(() -> window.getTitle()).startsWith("*");
  }

  @Test
  void aChangedFileIsReloadedAsAStepThatCanBeUndone() throws Exception {
    write(SQUARE);
    awaitBar("has been changed by another program or window.");
    assertThat(points()).isEqualTo(TRIANGLE);
    assertThat(isMarked()).isFalse();
    push("Reload");
    await("what the file holds", () -> points().equals(SQUARE));
    awaitNoBar();
    assertThat(isMarked()).isFalse();
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(points()).isEqualTo(TRIANGLE);
    assertThat(isMarked()).isTrue();
  }

  @Test
  void whatIsKeptCountsAsNotSavedAndIsNotWrittenOverTheChangeUnasked() throws Exception {
    write(SQUARE);
    awaitBar("window.");
    push("Keep Mine");
    awaitNoBar();
    assertThat(isMarked()).isTrue();
    type(KeyEvent.VK_S, KeyEvent.VK_CONTROL);
    JOptionPaneFixture question = dialog();
    assertThat(message(question)).contains("has been changed by another program or window");
    answer(question, "Overwrite");
    await("saved", () -> !isMarked());
    assertThat(file).hasContent("100 100\n500 100\n300 400\n");
  }

  @Test
  void aRemovedFileIsNamedAndWrittenAgain() throws Exception {
    Files.delete(file);
    awaitBar("has been removed or cannot be read any more.");
    assertThat(isMarked()).isTrue(); // the only copy is in the window
    push("Save Again");
    awaitNoBar();
    await("saved", () -> !isMarked());
    assertThat(file).hasContent("100 100\n500 100\n300 400\n");
  }

  @Test
  void aFileThatIsPutBackIsNoChange() throws Exception {
    write(SQUARE);
    awaitBar("window.");
    write(TRIANGLE);
    awaitNoBar();
    assertThat(isMarked()).isFalse();
  }

  @Test
  void savingHereIsNoChange() throws Exception {
    check("Draw Vertex");
    clickAt(150, 300);
    type(KeyEvent.VK_S, KeyEvent.VK_CONTROL);
    await("saved", () -> !isMarked());
    // The watch tells of changes in their order: once it has told of the next, that one is past.
    Files.writeString(file, Files.readString(file) + "120 200\n");
    awaitBar("window.");
    push("Reload");
    await("what the file holds", () -> points().size() == 5);
  }

  @Test
  void theBarMovesNoWindowThatHasJustBeenOpened() {
    Component bar = robot.finder().findByName(window, "changeBar", false);
    awaitSettled(false, bar); // and the settling that began when it was opened
    Rectangle before = onEventThread(window::getBounds);
    awaitSettled(true, bar);
    assertThat(bar.getHeight()).isPositive();
    Rectangle after = onEventThread(window::getBounds);
    assertThat(after).isEqualTo(before);
  }

  /** Lets the window settle as after its opening; the bar comes before it has. */
  private void awaitSettled(boolean shown, Component bar) {
    Timer settling =
        onEventThread(
            () -> {
              Timer begun = Placement.settle(window, canvas());
              bar.setVisible(shown);
              return begun;
            });
    await("the window is settled", () -> !settling.isRunning());
    robot.waitForIdle();
  }

  @Test
  void theBarIsForTheApplicationThatIsShown() throws Exception {
    write(SQUARE);
    awaitBar("window.");
    choose("Point Sites Based");
    awaitNoBar();
    choose("Polygon Based");
    awaitBar("window.");
  }

  @Test
  void anotherWindowHearsOfASave() throws Exception {
    check("Draw Vertex");
    clickAt(150, 300);
    MainWindow other = onEventThread(() -> new Windows(session).openWindow());
    javax.swing.SwingUtilities.invokeLater(() -> other.open(file));
    await("the file", () -> onEventThread(other::getTitle).startsWith("shape_"));
    onEventThread(
        () -> {
          window.commands().get("Save").perform();
          return null;
        });
    await("saved", () -> !isMarked());
    Component bar = robot.finder().findByName(other, "changeBar", false);
    await("the other window's bar", () -> onEventThread(bar::isVisible));
    assertThat(bar()).isEmpty();
    onEventThread(
        () -> {
          other.workbench().jobs().shutDown();
          return null;
        });
  }

  @Test
  void whatCannotBeReadIsSaidAndChangesNothing() throws Exception {
    Files.writeString(file, "100 100\n500 nonsense\n");
    awaitBar("window.");
    frame.button("Reload").click();
    JOptionPaneFixture refusal = dialog();
    assertThat(message(refusal)).contains("shape_polygonbased.txt, line 2");
    answer(refusal, "OK");
    assertThat(points()).isEqualTo(TRIANGLE);
    Files.writeString(file, "100 100\n500 100\n\n100 100\n200 300\n250 300\n300 500\n");
    awaitBar("window.");
    frame.button("Reload").click();
    answer(dialog(), "OK");
    assertThat(points()).isEqualTo(TRIANGLE);
  }
}
