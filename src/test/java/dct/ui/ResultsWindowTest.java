package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.ui.document.Edit;
import dct.ui.solve.ResultFrame;
import java.awt.Component;
import java.awt.event.KeyEvent;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;

/** What is made of a document is a part of it: results are steps of its history. */
class ResultsWindowTest extends WindowTest {
  private static final double[] DRAWN = {
    100, 100, 300, 60, 500, 120, 560, 300, 800, 200, 900, 400, 850, 600, 600, 650, 450, 500, 200,
    620, 80, 400
  };

  @Test
  void undoClosesTheFrameOfAPolygonsResultAndRedoOpensItAgain() {
    draw("Polygon Based", DRAWN);
    ResultFrame monotone = pushForResult("Monotone Polygon Triangulation");
    ResultFrame flipped = pushForResult("Perform Flip");
    assertThat(undoText()).isEqualTo("Undo Perform Flip");
    undo();
    await("the flips are gone", () -> !flipped.isShowing());
    assertThat(monotone.isShowing()).isTrue();
    assertThat(undoText()).isEqualTo("Undo Monotone Polygon Triangulation");
    redo();
    await("the flips are back", flipped::isShowing);
    undo();
    undo();
    await("no result is left", () -> results().isEmpty());
    assertThat(onEventThread(() -> window.workbench().document().result())).isEmpty();
    assertThat(points().size()).isEqualTo(DRAWN.length / 2);
  }

  @Test
  void flipsOfSitesAreUndoneBeforeTheSites() {
    draw("Point Sites Based", DRAWN);
    Triangulation delaunay = shown().orElseThrow();
    push("Perform Flip");
    Triangulation flipped = shown().orElseThrow();
    assertThat(flipped).isNotSameAs(delaunay);
    undo();
    assertThat(points().size()).isEqualTo(DRAWN.length / 2);
    assertThat(shown()).containsSame(delaunay);
    redo();
    assertThat(shown()).containsSame(flipped);
    clickMenu("Triangulate");
    clickMenu("Delaunay");
    settle();
    assertThat(shown()).containsSame(delaunay);
    assertThat(undoText()).isEqualTo("Undo Delaunay");
  }

  @Test
  void undoInAFrameOfSitesIsTheirsWhateverTheWindowShows() {
    draw("Point Sites Based", DRAWN);
    Triangulation delaunay = shown().orElseThrow();
    push("Perform Flip");
    ResultFrame frame = frameOfFirstRow();
    onEventThread(
        () -> {
          window.workbench().choose(Domain.POLYGON);
          window.workbench().perform(Edit.draw(window.workbench().document(), 100, 100));
          assertThat(frame.commands().get("Undo").name()).isEqualTo("Undo Perform Flip");
          frame.commands().get("Undo").perform();
          return null;
        });
    settle();
    assertThat(points().size()).isEqualTo(1);
    choose("Point Sites Based");
    assertThat(shown()).containsSame(delaunay);
    assertThat(points().size()).isEqualTo(DRAWN.length / 2);
  }

  /** Opens the result in the first row of the table, which the canvas does not show. */
  private ResultFrame frameOfFirstRow() {
    perform("Table of Results");
    onEventThread(
        () -> {
          JTable table = robot.finder().findByName("results", JTable.class, true);
          table.setRowSelectionInterval(0, 0);
          SwingUtilities.getWindowAncestor(table).setVisible(false);
          return null;
        });
    await("the frame", () -> results().size() == 1);
    settle();
    return (ResultFrame) results().get(0);
  }

  @Test
  void aPictureHasNoHistory() {
    draw("Polygon Based", DRAWN);
    perform("Monotone Partition");
    await("the frame", () -> results().size() == 1);
    ResultFrame frame = (ResultFrame) results().get(0);
    assertThat(onEventThread(() -> frame.commands().get("Undo").isEnabled())).isFalse();
  }

  @Test
  void anOptimumIsOneUndoAwayFromTheEditThatLostIt() {
    draw("Point Sites Based", DRAWN);
    type(KeyEvent.VK_E, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
    settle();
    assertThat(verdict()).contains("—");
    clickAt(640, 420);
    assertThat(verdict()).doesNotContain("—");
    undo();
    assertThat(verdict()).contains("—");
    assertThat(undoText()).isEqualTo("Undo Most Even Vertices");
  }

  @Test
  void menusHoldEveryCommandAndNoKeyTwice() {
    Set<String> inMenus = new HashSet<>();
    for (int i = 0; i < window.getJMenuBar().getMenuCount(); i++) {
      collect(window.getJMenuBar().getMenu(i), inMenus);
    }
    Set<KeyStroke> keys = new HashSet<>();
    for (var command : window.commands().all()) {
      boolean ofNoMenu = command.id().equals("Give Up");
      assertThat(inMenus.contains(command.id())).as(command.id()).isNotEqualTo(ofNoMenu);
      for (KeyStroke key : command.keys()) {
        assertThat(keys.add(key)).as(command.id() + " " + key).isTrue();
      }
      assertThat(command.description()).as(command.id()).isNotBlank();
    }
  }

  /** Also sees that every item has a letter that opens it. */
  private static void collect(JMenu menu, Set<String> names) {
    for (Component item : menu.getMenuComponents()) {
      if (item instanceof JMenuItem button) {
        assertThat(button.getMnemonic()).as(button.getText()).isNotZero();
        names.add(button.getName());
      }
    }
  }

  private void draw(String application, double... coordinates) {
    choose(application);
    check("Draw Vertex");
    clickAt(coordinates);
  }

  private void undo() {
    perform("Undo");
  }

  private void redo() {
    perform("Redo");
  }

  /** Frames of results may have the focus, and cover the menus. */
  private void perform(String command) {
    onEventThread(
        () -> {
          window.commands().get(command).perform();
          return null;
        });
    settle();
  }

  private String undoText() {
    return onEventThread(() -> window.commands().get("Undo").name());
  }

  private Optional<Triangulation> shown() {
    return onEventThread(
        () -> window.workbench().shown().solution().map(solution -> solution.triangulation()));
  }

  private String verdict() {
    List<String> counts = onEventThread(() -> canvas().scene().counts());
    return String.join(" ", counts);
  }
}
