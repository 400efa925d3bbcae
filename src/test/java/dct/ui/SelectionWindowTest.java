package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import dct.render.Ink;
import dct.ui.document.Selection;
import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.event.KeyEvent;
import java.util.Arrays;
import javax.swing.JTable;
import org.assertj.swing.fixture.JOptionPaneFixture;
import org.junit.jupiter.api.Test;

/** Selecting, moving, copying, pasting and removing vertices; snapping by Ipe's keys. */
class SelectionWindowTest extends WindowTest {
  private static final double[] SQUARE = {100, 100, 300, 100, 300, 300, 100, 300};

  private void draw() {
    choose("Polygon Based");
    check("Draw Vertex");
    clickAt(SQUARE);
    check("Edit Vertex");
  }

  private Selection selection() {
    return onEventThread(() -> window.workbench().selection());
  }

  private void band(double x, double y, double toX, double toY) {
    press(x, y);
    moveTo((x + toX) / 2, (y + toY) / 2);
    moveTo(toX, toY);
    release();
  }

  @Test
  void aBandSelectsAndADragMovesAllOfThem() {
    draw();
    band(50, 50, 350, 150);
    assertThat(selection()).isEqualTo(Selection.of(0, 1));
    requireInk(canvas(), Ink.HIGHLIGHT, 100, 100 - 7);
    requireInk(canvas(), Ink.HIGHLIGHT, 300, 100 - 7);
    press(300, 100);
    moveTo(310, 130);
    moveTo(320, 140);
    release();
    assertThat(points()).isEqualTo(Points.ofPairs(120, 140, 320, 140, 300, 300, 100, 300));
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(points()).isEqualTo(Points.ofPairs(SQUARE));
    assertThat(selection()).isEqualTo(Selection.of(0, 1));
  }

  @Test
  void arrowsMoveAndDeleteRemovesWhatIsSelected() {
    draw();
    type(KeyEvent.VK_A, KeyEvent.VK_CONTROL);
    type(KeyEvent.VK_RIGHT);
    type(KeyEvent.VK_DOWN, KeyEvent.VK_SHIFT);
    assertThat(points()).isEqualTo(Points.ofPairs(101, 110, 301, 110, 301, 310, 101, 310));
    type(KeyEvent.VK_ESCAPE);
    clickAt(301, 110);
    type(KeyEvent.VK_DELETE);
    assertThat(points()).isEqualTo(Points.ofPairs(101, 110, 301, 310, 101, 310));
    assertThat(selection()).isEqualTo(Selection.NONE);
    for (int i = 0; i < 3; i++) {
      type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    }
    assertThat(points()).isEqualTo(Points.ofPairs(SQUARE));
  }

  @Test
  void copiesAreLinesOfCoordinatesAndArePastedBehindTheSelection() throws Exception {
    draw();
    band(50, 50, 350, 150);
    type(KeyEvent.VK_C, KeyEvent.VK_CONTROL);
    assertThat(Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor))
        .isEqualTo("100 100\n300 100\n");
    type(KeyEvent.VK_V, KeyEvent.VK_CONTROL);
    assertThat(points())
        .isEqualTo(Points.ofPairs(100, 100, 300, 100, 120, 120, 320, 120, 300, 300, 100, 300));
    assertThat(selection()).isEqualTo(Selection.of(2, 3));
    type(KeyEvent.VK_X, KeyEvent.VK_CONTROL);
    assertThat(points()).isEqualTo(Points.ofPairs(SQUARE));
    assertThat(undoLabel()).isEqualTo("Cut 2 Vertices");
  }

  @Test
  void theTableSelectsWithTheCanvas() {
    draw();
    JTable table = robot.finder().findByName("vertices", JTable.class, false);
    band(50, 50, 350, 150);
    await("the rows", () -> Arrays.equals(onEventThread(table::getSelectedRows), new int[] {0, 1}));
    onEventThread(
        () -> {
          table.setRowSelectionInterval(2, 3);
          return null;
        });
    settle();
    assertThat(selection()).isEqualTo(Selection.of(2, 3));
    requireInk(canvas(), Ink.HIGHLIGHT, 300, 300 - 7);
    type(KeyEvent.VK_DELETE);
    await("no row", () -> onEventThread(table::getSelectedRowCount) == 0);
    assertThat(points()).isEqualTo(Points.ofPairs(100, 100, 300, 100));
  }

  private String undoLabel() {
    return onEventThread(
        () -> window.workbench().active().orElseThrow().history().undoLabel().orElseThrow());
  }

  @Test
  void sitesArePastedFromTextAndDuplicated() {
    choose("Point Sites Based");
    clickAt(100, 100, 300, 100, 200, 300);
    Toolkit.getDefaultToolkit()
        .getSystemClipboard()
        .setContents(new StringSelection("# two\n400, 50\n500 60\n500 60\n"), null);
    type(KeyEvent.VK_V, KeyEvent.VK_CONTROL);
    assertThat(points()).isEqualTo(Points.ofPairs(100, 100, 300, 100, 200, 300, 400, 50, 500, 60));
    assertThat(undoLabel()).isEqualTo("Paste 2 Sites");
    type(KeyEvent.VK_D, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
    assertThat(points().size()).isEqualTo(7);
    assertThat(undoLabel()).isEqualTo("Duplicate 2 Sites");
    assertThat(points().x(6)).isEqualTo(520);
    assertThat(selection()).isEqualTo(Selection.of(5, 6));
  }

  private static Object clipboard() throws Exception {
    return Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor);
  }

  @Test
  void verticesAreCopiedForOtherProgramsAndOneOfSeveralRingsIsPasted() throws Exception {
    draw();
    clickMenu("Edit");
    clickMenu("Copy as WKT");
    assertThat(clipboard()).isEqualTo("POLYGON ((100 100, 300 100, 300 300, 100 300, 100 100))\n");
    clickMenu("Edit");
    clickMenu("Copy as GeoJSON");
    assertThat(clipboard().toString()).startsWith("{\"type\": \"Polygon\"").contains("[300, 300]");
    band(50, 50, 350, 150);
    clickMenu("Edit");
    clickMenu("Copy for Ipe");
    assertThat(clipboard())
        .isEqualTo(
            """
            <ipeselection pos="0 0">
            <path stroke="black">
            100 -100 m
            300 -100 l
            h
            </path>
            </ipeselection>
            """);
    type(KeyEvent.VK_ESCAPE);
    Toolkit.getDefaultToolkit()
        .getSystemClipboard()
        .setContents(new StringSelection("0 0\n10 0\n10 10\n\n500 500\n600 500\n600 600\n"), null);
    takeKeyboard();
    robot.pressKey(KeyEvent.VK_CONTROL);
    robot.pressAndReleaseKeys(KeyEvent.VK_V);
    robot.releaseKey(KeyEvent.VK_CONTROL);
    JOptionPaneFixture question = dialog();
    question.list("shapes").selectItem(1);
    answer(question, "Open");
    await("the second ring", () -> points().size() == 7);
    assertThat(points().x(6)).isEqualTo(600);
  }

  @Test
  void textThatHoldsNoPointsIsNotPasted() {
    draw();
    Toolkit.getDefaultToolkit()
        .getSystemClipboard()
        .setContents(new StringSelection("no points"), null);
    takeKeyboard();
    robot.pressKey(KeyEvent.VK_CONTROL);
    robot.pressAndReleaseKeys(KeyEvent.VK_V);
    robot.releaseKey(KeyEvent.VK_CONTROL);
    var dialog = dialog();
    assertThat(message(dialog)).contains("the clipboard");
    answer(dialog, "OK");
    assertThat(points()).isEqualTo(Points.ofPairs(SQUARE));
  }

  @Test
  void ipesKeysSnap() {
    choose("Polygon Based");
    check("Draw Vertex");
    type(KeyEvent.VK_F7);
    clickAt(104, 97, 293, 108);
    assertThat(points()).isEqualTo(Points.ofPairs(100, 100, 300, 100));
    assertThat(frame.label("snap").text()).isEqualTo("Snap: grid 20");
    type(KeyEvent.VK_F7);
    type(KeyEvent.VK_F5);
    clickAt(300, 300, 204, 206); // on the edge back to v0
    assertThat(points().size()).isEqualTo(4);
    assertThat(points().x(3)).isEqualTo(points().y(3));
    assertThat(frame.label("snap").text()).isEqualTo("Snap: edges");
  }
}
