package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.assertj.swing.finder.JFileChooserFinder;
import org.assertj.swing.fixture.JFileChooserFixture;
import org.assertj.swing.fixture.JOptionPaneFixture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;

/** Files that hold more than one polygon, or are not of the program's own kind. */
class ForeignFilesWindowTest extends WindowTest {
  private static final String TWO_RINGS = "0 0\n90 0\n90 90\n\n200 0\n290 0\n290 90\n200 90\n";
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
}
