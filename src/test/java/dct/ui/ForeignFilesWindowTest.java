package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import dct.problem.Solution;
import java.awt.event.KeyEvent;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.SwingUtilities;
import javax.swing.filechooser.FileFilter;
import org.assertj.swing.finder.JFileChooserFinder;
import org.assertj.swing.fixture.JFileChooserFixture;
import org.assertj.swing.fixture.JOptionPaneFixture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;

/** Files that hold more than one polygon, or are not of the program's own kind. */
class ForeignFilesWindowTest extends WindowTest {
  private static final String TWO_RINGS = "0 0\n90 0\n90 90\n\n200 0\n290 0\n290 90\n200 90\n";

  /** A square with the diagonal of v0 and v2; the first triangle is on line 7. */
  private static final String MESH =
      "OFF\n4 2 0\n0 0 0\n90 0 0\n90 90 0\n0 91 0\n3 0 1 2\n3 0 2 3\n";

  private static final Points SECOND = Points.ofPairs(200, 0, 290, 0, 290, 90, 200, 90);

  @TempDir(cleanup = CleanupMode.NEVER)
  private Path folder;

  private Path open(String name, String text) throws IOException {
    Path file = Files.writeString(folder.resolve(name), text);
    choose("Polygon Based");
    onEventThread(
        () -> {
          window.open(file);
          return null;
        });
    return file;
  }

  @Test
  void oneOfSeveralShapesIsChosenFromAList() throws IOException {
    open("rings.txt", TWO_RINGS);
    JOptionPaneFixture question = dialog();
    question.list("shapes").requireItemCount(2).selectItem(1);
    answer(question, "Open");
    await("the second ring", () -> points().equals(SECOND));
  }

  @Test
  void allShapesCanBeOpenedAsSitesOrNone() throws IOException {
    open("rings.txt", TWO_RINGS);
    answer(dialog(), "Cancel");
    settle();
    assertThat(points().size()).isZero();
    open("rings.txt", TWO_RINGS);
    answer(dialog(), "All as Sites");
    await("the sites", () -> points().size() == 7);
    frame.radioButton("Point Sites Based").requireSelected();
  }

  private void run(String command) {
    SwingUtilities.invokeLater(() -> window.commands().get(command).perform());
    settle();
  }

  private Optional<Solution> solution() {
    return onEventThread(() -> window.workbench().solution());
  }

  @Test
  void aTriangulationOfSitesIsShownAndCanBeFlipped() throws IOException {
    open("square.off", MESH);
    await("the triangulation", () -> solution().isPresent());
    frame.radioButton("Point Sites Based").requireSelected();
    assertThat(solution().orElseThrow().methodTitle()).isEqualTo("Read from square.off");
    assertThat(solution().orElseThrow().triangulation().edgeBetween(0, 2)).isPresent();
    run("Perform Flip");
    await("the flips", () -> solution().orElseThrow().flips().isPresent());
    assertThat(solution().orElseThrow().countsBefore().orElseThrow().odd()).isEqualTo(2);
    run("Undo");
    await("the file's own", () -> solution().orElseThrow().flips().isEmpty());
    assertThat(solution().orElseThrow().method()).isEmpty();
  }

  @Test
  void aTriangulationOfAPolygonIsItsResult() throws IOException {
    open("dart.off", MESH.replace("90 90 0", "20 30 0"));
    await("the result", () -> solution().isPresent());
    frame.radioButton("Polygon Based").requireSelected();
    assertThat(solution().orElseThrow().triangulation().edgeBetween(0, 2)).isPresent();
  }

  @Test
  void pointsAloneAreOfferedWhereTrianglesAreWrong() throws IOException {
    open("twice.off", MESH.replace("3 0 2 3", "3 2 1 0"));
    JOptionPaneFixture sorry = dialog();
    sorry.requireMessage(
        "twice.off, line 8: its triangles are no triangulation of its sites: the triangle is there"
            + " already, on line 7.");
    answer(sorry, "Open Points Alone");
    await("the sites", () -> points().size() == 4);
    frame.radioButton("Point Sites Based").requireSelected();
  }

  @Test
  void theOpenPanelShowsWhatCanBeRead() {
    choose("Point Sites Based");
    type(KeyEvent.VK_O, KeyEvent.VK_CONTROL);
    JFileChooserFixture chooser =
        JFileChooserFinder.findFileChooser().withTimeout(PATIENCE_MILLIS).using(robot);
    FileFilter filter = chooser.target().getFileFilter();
    for (String name : List.of("a.ele", "a.off", "a.OBJ", "a.instance.json", "a.txt", "a.txt.gz")) {
      assertThat(filter.accept(new File(name))).as(name).isTrue();
    }
    assertThat(filter.accept(new File("a.png"))).isFalse();
    chooser.cancel();
    settle();
  }

  @Test
  void savingAsksForAPlaceRatherThanLosingWhatWasLeftOut() throws IOException {
    String heights = "0 0 1\n90 0 1\n90 90 2\n";
    Path file = open("field.xyz", heights);
    await("the vertices", () -> points().size() == 3);
    assertThat(frame.label("status").text()).contains("The column of z behind x and y is left out");
    type(KeyEvent.VK_S, KeyEvent.VK_CONTROL);
    JFileChooserFixture chooser =
        JFileChooserFinder.findFileChooser().withTimeout(PATIENCE_MILLIS).using(robot);
    assertThat(chooser.target().getSelectedFile()).hasName("field_polygonbased.txt");
    chooser.cancel();
    settle();
    assertThat(file).hasContent(heights);
  }

  private static void pick(JOptionPaneFixture question, String column, int number) {
    question.comboBox(column).selectItem(Integer.toString(number));
  }

  @Test
  void theColumnsOfATableAreAskedForWhereTheyCannotBeTold() throws IOException {
    open("table.csv", "0.5 7 9 0.5\n90 7 9 0.5\n90 8 9 60\n");
    JOptionPaneFixture question = dialog();
    question.table("rows").requireColumnCount(4).requireRowCount(3);
    pick(question, "yColumn", 4);
    answer(question, "OK");
    await("the vertices", () -> points().equals(Points.ofPairs(0.5, 0.5, 90, 0.5, 90, 60)));
    open("again.csv", "1 2 3 4\n4 5 7 8\n");
    answer(dialog(), "Cancel");
    settle();
    assertThat(points().size()).isEqualTo(3);
  }

  @Test
  void aRowThatNumbersTheColumnsIsSkippedIfThatIsMeant() throws IOException {
    open("frame.csv", "0,1\n10.5,20.5\n90.5,20.5\n60.5,80.5\n");
    JOptionPaneFixture question = dialog();
    question.spinner("skipped").requireValue(1);
    answer(question, "OK");
    await(
        "the vertices", () -> points().equals(Points.ofPairs(10.5, 20.5, 90.5, 20.5, 60.5, 80.5)));
  }
}
