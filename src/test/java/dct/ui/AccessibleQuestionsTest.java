package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Points;
import dct.ui.dialog.Chooser;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.job.Jobs;
import dct.ui.session.Orphan;
import dct.ui.session.Session;
import java.awt.Dialog;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Stream;
import javax.swing.JPopupMenu;
import org.assertj.swing.core.matcher.JButtonMatcher;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;

/** What no command opens by itself: questions about files, faults, and what runs. */
class AccessibleQuestionsTest extends WindowTest {
  private static final Points TRIANGLE = Points.ofPairs(100, 100, 500, 100, 300, 400);
  private static final Points BOW_TIE = Points.ofPairs(100, 100, 500, 400, 500, 100, 100, 400);
  private static final String TWO_RINGS = "0 0\n90 0\n90 90\n\n200 0\n290 0\n290 90\n200 90\n";

  @TempDir(cleanup = CleanupMode.NEVER)
  private Path folder;

  private void require(String what, Runnable action) {
    Dialog dialog = (Dialog) AccessLaws.open(what, action);
    robot.waitForIdle();
    AccessLaws.requireAnswerable(dialog);
    AccessLaws.closeByEscape(dialog);
    settle();
  }

  private void draw(Points points) {
    choose("Polygon Based");
    onEventThread(
        () -> {
          Editor editor = window.workbench().active().orElseThrow();
          editor.perform(Edit.replace("Draw", editor.document(), points));
          return null;
        });
    settle();
  }

  private void perform(String command) {
    window.commands().get(command).perform();
  }

  @Test
  void theChoiceOfAShape() throws IOException {
    choose("Polygon Based");
    Path file = Files.writeString(folder.resolve("rings.txt"), TWO_RINGS);
    require("a file of two rings", () -> window.open(file));
    assertThat(points().size()).isZero();
  }

  @Test
  void theChoiceOfTheColumns() throws IOException {
    choose("Polygon Based");
    Path rows = Files.writeString(folder.resolve("rows.csv"), "0.5 7 9 1\n90 7 9 1\n90 8 9 60\n");
    require("a table of four columns", () -> window.open(rows));
    Path head =
        Files.writeString(folder.resolve("head.csv"), "0,1\n10.5,20.5\n90.5,20.5\n60.5,80.5\n");
    require("a table with a row of numbers above", () -> window.open(head));
    assertThat(points().size()).isZero();
  }

  @Test
  void aFileThatCannotBeRead() throws IOException {
    Path file = Files.writeString(folder.resolve("words.txt"), "0 0\nno point\n");
    require("a file of words", () -> window.open(file));
  }

  @Test
  void theOfferOfThePointsAlone() throws IOException {
    String twice = "OFF\n4 2 0\n0 0 0\n90 0 0\n90 90 0\n0 90 0\n3 0 1 2\n3 2 1 0\n";
    Path file = Files.writeString(folder.resolve("twice.off"), twice);
    require("a mesh that is no triangulation", () -> window.open(file));
    assertThat(onEventThread(() -> window.workbench().domain())).isEmpty();
  }

  @Test
  void theQuestionsBeforeAFileIsReplaced() throws IOException {
    choose("Polygon Based");
    Path file = Files.writeString(folder.resolve("a_polygonbased.txt"), "0 0\n9 0\n9 9\n");
    require("a file that is there", () -> Chooser.confirmReplacing(window, file));
    onEventThread(
        () -> {
          window.open(file);
          return null;
        });
    await("the file", () -> points().size() == 3);
    draw(TRIANGLE);
    Files.writeString(file, "0 0\n8 0\n8 8\n");
    require("a file that has changed", () -> perform("Save"));
    assertThat(file).hasContent("0 0\n8 0\n8 8\n");
  }

  @Test
  void whatCanBeDoneAboutACrossing() {
    draw(BOW_TIE);
    require("triangulating a bow tie", () -> perform("Ear Clipping Triangulation"));
    require("checking a bow tie", () -> perform("Check Input"));
  }

  @Test
  void theRingsIntoWhichOneFallsApart() {
    draw(Points.ofPairs(100, 100, 300, 100, 200, 200, 300, 300, 100, 300, 200, 200));
    require("two rings in one", () -> perform("Split Ring…"));
    require("triangulating it", () -> perform("Ear Clipping Triangulation"));
  }

  @Test
  void wishesThatCanBeSaved() {
    draw(TRIANGLE);
    onEventThread(
        () -> {
          Editor editor = window.workbench().active().orElseThrow();
          editor.perform(Edit.wish(editor.document(), 1, Wish.ODD));
          return null;
        });
    require("wishes", () -> perform("Wished Parities…"));
  }

  @Test
  void theRecoveryOfADrawing() throws Exception {
    draw(TRIANGLE);
    session.journals().await();
    Path left = Files.createDirectories(folder.resolve("dct.journal"));
    try (Stream<Path> files = Files.list(state.resolve("dct.journal"))) {
      Path journal = files.filter(f -> f.toString().endsWith(".journal")).findFirst().orElseThrow();
      Files.copy(journal, left.resolve("a.journal"));
    }
    Session next = Session.in(folder);
    List<Orphan> orphans = next.journals().orphans(unread -> {});
    Windows again = onEventThread(() -> new Windows(next));
    require("a drawing that was left", () -> again.offer(orphans, List.of()));
    assertThat(left.resolve("a.journal")).exists();
  }

  @Test
  void theListOfWhatRuns() {
    draw(TRIANGLE);
    CountDownLatch end = new CountDownLatch(1);
    Jobs jobs = window.workbench().jobs();
    onEventThread(() -> jobs.submit("Waiting", progress -> isOver(end), done -> {}));
    onEventThread(() -> jobs.submit("Waiting more", progress -> true, done -> {}));
    await("the bar is shown", () -> onEventThread(() -> isShowing("cancelJob")));
    onEventThread(
        () -> {
          perform("Background Work");
          return null;
        });
    AccessLaws.requireNamed(robot.finder().findByName("jobList", JPopupMenu.class), 2);
    AccessLaws.requireNamed(window, 20);
    robot.pressAndReleaseKeys(KeyEvent.VK_ESCAPE);
    end.countDown();
    settle();
  }

  private static boolean isOver(CountDownLatch end) {
    try {
      end.await();
      return true;
    } catch (InterruptedException e) {
      return false;
    }
  }

  private boolean isShowing(String button) {
    return robot.finder().findAll(window, JButtonMatcher.withName(button).andShowing()).size() == 1;
  }
}
