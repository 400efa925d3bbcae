package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.io.DataFile;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import dct.io.PointFile;
import dct.io.format.Choice;
import dct.ui.solve.ResultFrame;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JFileChooser;
import javax.swing.filechooser.FileFilter;
import org.assertj.swing.finder.JFileChooserFinder;
import org.assertj.swing.fixture.JFileChooserFixture;
import org.assertj.swing.fixture.JOptionPaneFixture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is shown, written for other programs. */
class DataExportWindowTest extends WindowTest {
  private static final double[] PENTAGON = {100, 100, 500, 100, 600, 300, 300, 400, 80, 300};

  @TempDir Path folder;

  private void exportMenu() {
    clickMenu("File");
    clickMenu("Export Data");
  }

  private static JFileChooserFixture chooser(org.assertj.swing.core.Robot robot) {
    return JFileChooserFinder.findFileChooser().withTimeout(PATIENCE_MILLIS).using(robot);
  }

  private static List<String> formats(JFileChooser chooser) {
    return onEventThread(
        () ->
            Stream.of(chooser.getChoosableFileFilters()).map(FileFilter::getDescription).toList());
  }

  private void accept(JFileChooserFixture chooser, String name) {
    fill(chooser.fileNameTextBox(), folder.resolve(name).toString());
    robot.pressAndReleaseKeys(KeyEvent.VK_ENTER);
    await("the file panel is closed", () -> !chooser.target().isShowing());
    robot.waitForIdle();
  }

  @Test
  void aPolygonIsWrittenInEveryFormatThatHoldsPoints() {
    choose("Polygon Based");
    clickAt(PENTAGON);
    List<FileEnding> endings =
        DataFile.endings().stream().filter(ending -> ending.holds(Content.POINTS)).toList();
    for (FileEnding ending : endings) {
      exportMenu();
      JFileChooserFixture chooser = chooser(robot);
      assertThat(formats(chooser.target())).hasSize(endings.size());
      accept(chooser, "mine" + ending.dotted());
      Path file = folder.resolve("mine" + ending.dotted());
      settle();
      await("written", () -> frame.label("status").text().equals("Exported " + file));
      assertThat(PointFile.read(file, Choice.NONE, Progress.NONE).points())
          .as(ending.dotted())
          .isEqualTo(points());
    }
  }

  @Test
  void theFormatUsedLastIsOfferedAgainAndGivesTheEnding() throws Exception {
    choose("Point Sites Based");
    clickAt(PENTAGON);
    exportMenu();
    accept(chooser(robot), "sites.ele");
    settle();
    assertThat(frame.label("status").text())
        .isEqualTo("Exported " + folder.resolve("sites.ele") + ", and its vertices in sites.node");
    assertThat(Files.readString(folder.resolve("sites.ele"))).startsWith("3 3 0");
    exportMenu();
    JFileChooserFixture again = chooser(robot);
    assertThat(onEventThread(() -> again.target().getFileFilter().getDescription()))
        .isEqualTo("Triangle: triangles (*.ele)");
    accept(again, "others");
    settle();
    assertThat(folder.resolve("others.ele")).exists();
    assertThat(folder.resolve("others.node")).exists();
    Files.delete(folder.resolve("others.ele"));
    exportMenu();
    accept(chooser(robot), "others");
    JOptionPaneFixture question = dialog();
    assertThat(message(question)).startsWith("others.node is there already");
    answer(question, "Cancel");
    assertThat(folder.resolve("others.ele")).doesNotExist();
    exportMenu();
    accept(chooser(robot), "points.wkt");
    settle();
    assertThat(frame.label("status").text()).endsWith("points.wkt; it holds the points alone");
  }

  @Test
  void aResultIsWrittenFromItsFrame() throws Exception {
    choose("Polygon Based");
    clickAt(PENTAGON);
    ResultFrame result = pushForResult("Monotone Polygon Triangulation");
    onEventThread(
        () -> {
          javax.swing.SwingUtilities.invokeLater(
              () -> result.commands().get("Export Data").perform());
          return null;
        });
    accept(chooser(robot), "mesh.off");
    String told = "Exported " + folder.resolve("mesh.off");
    await("what was written is said", () -> status(result).equals(told));
    requireNoDialog();
    assertThat(Files.readString(folder.resolve("mesh.off"))).startsWith("OFF\n5 3 ");
  }
}
