package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Points;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import javax.swing.JTable;
import org.junit.jupiter.api.Test;

/** What can be done without a mouse, and what a screen reader is told. */
class AccessWindowTest extends WindowTest {
  private static final double[] SQUARE = {100, 100, 500, 120, 480, 500, 90, 450, 300, 300};

  /** The table of the vertices, in front and with a cell in focus. */
  private JTable vertices(int row, int column) {
    onEventThread(
        () -> {
          frame.tabbedPane("tabs").target().setSelectedIndex(1);
          return null;
        });
    JTable table = frame.table("vertices").target();
    await("the table is shown", () -> onEventThread(table::isShowing));
    await("the rows", () -> onEventThread(() -> table.getRowCount() == points().size()));
    robot.focusAndWaitForFocusGain(table);
    onEventThread(
        () -> {
          table.changeSelection(row, column, false, false);
          return null;
        });
    return table;
  }

  /** Presses keys wherever the focus is. */
  private void keys(int... codes) {
    robot.pressAndReleaseKeys(codes);
    settle();
  }

  private String text(JTable table, int row, int column) {
    return onEventThread(() -> String.valueOf(table.getValueAt(row, column)));
  }

  @Test
  void aCoordinateTypedInTheTableMovesTheVertex() {
    choose("Point Sites Based");
    clickAt(SQUARE);
    JTable table = vertices(4, 1);
    keys(KeyEvent.VK_3, KeyEvent.VK_3, KeyEvent.VK_3, KeyEvent.VK_ENTER);
    await("the site has moved", () -> points().x(4) == 333);
    await("the row shows it", () -> text(table, 4, 1).equals("333"));
    clickMenu("Edit");
    await("the edit has its name", () -> frame.menuItem("Undo").target().getText().endsWith("v4"));
    clickMenu("Undo");
    await("the site is back", () -> points().equals(Points.ofPairs(SQUARE)));
  }

  @Test
  void lettersTypedInACellAreNoCommands() {
    choose("Point Sites Based");
    clickAt(SQUARE);
    JTable table = vertices(4, 1);
    keys(KeyEvent.VK_1, KeyEvent.VK_X, KeyEvent.VK_ENTER); // X alone chooses Delete Vertex
    frame.checkBox("Draw Vertex").requireSelected();
    await("the status says it", () -> frame.label("status").text().contains("“1x” is no"));
    assertThat(onEventThread(table::isEditing)).isTrue();
    keys(KeyEvent.VK_ESCAPE);
    await("the cell is given up", () -> !onEventThread(table::isEditing));
    assertThat(points()).isEqualTo(Points.ofPairs(SQUARE));
    keys(KeyEvent.VK_X);
    frame.checkBox("Delete Vertex").requireSelected();
  }

  @Test
  void aLetterChoosesTheWishOfTheRowsThatAreSelected() {
    choose("Point Sites Based");
    clickAt(SQUARE);
    JTable table = vertices(1, 4);
    robot.pressKey(KeyEvent.VK_SHIFT);
    keys(KeyEvent.VK_DOWN);
    robot.releaseKey(KeyEvent.VK_SHIFT);
    keys(KeyEvent.VK_O);
    await("the wishes", () -> wish(1) == Wish.ODD && wish(2) == Wish.ODD);
    assertThat(wish(0)).isEqualTo(Wish.EVEN);
    assertThat(wish(3)).isEqualTo(Wish.EVEN);
    await("the row shows it", () -> text(table, 2, 4).equals("ODD"));
  }

  private Wish wish(int v) {
    return onEventThread(() -> window.workbench().document().wishes().wish(v));
  }

  @Test
  void theTableShowsAMillionRowsAtOnce() {
    choose("Point Sites Based");
    int n = 1_000_000;
    double[] pairs = new double[2 * n];
    for (int v = 0; v < n; v++) {
      pairs[2 * v] = v;
    }
    Points line = Points.ofPairs(pairs);
    onEventThread(
        () -> {
          var editor = window.workbench().active().orElseThrow();
          editor.perform(dct.ui.document.Edit.replace("Many", editor.document(), line));
          return null;
        });
    onEventThread(
        () -> {
          frame.tabbedPane("tabs").target().setSelectedIndex(1);
          return null;
        });
    JTable table = frame.table("vertices").target();
    await("the rows", () -> onEventThread(() -> table.getRowCount() == n));
    onEventThread(
        () -> {
          table.scrollRectToVisible(new Rectangle(table.getCellRect(n - 1, 1, true)));
          return null;
        });
    assertThat(text(table, n - 1, 1)).isEqualTo("999999");
    onEventThread(
        () -> {
          window.workbench().jobs().cancelCurrent();
          return null;
        });
  }
}
