package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import dct.render.Ink;
import dct.render.Viewport;
import java.awt.event.KeyEvent;
import javax.swing.JLabel;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;
import org.assertj.swing.core.GenericTypeMatcher;
import org.assertj.swing.core.MouseButton;
import org.junit.jupiter.api.Test;

/** How drawing begins, goes on and ends, by mouse and by keys. */
class DrawingWindowTest extends WindowTest {

  private void begin() {
    choose("Polygon Based");
    check("Draw Vertex");
  }

  @Test
  void aClickOnTheFirstVertexEndsTheDrawing() {
    begin();
    clickAt(100, 100, 500, 100, 300, 400, 102, 99);
    assertThat(points()).isEqualTo(Points.ofPairs(100, 100, 500, 100, 300, 400));
    frame.checkBox("Edit Vertex").requireSelected();
  }

  @Test
  void aDoubleClickEndsTheDrawing() {
    begin();
    clickAt(100, 100, 500, 100);
    click(() -> robot.click(canvas(), at(canvas(), 300, 400), MouseButton.LEFT_BUTTON, 2));
    frame.checkBox("Edit Vertex").requireSelected();
    assertThat(points()).isEqualTo(Points.ofPairs(100, 100, 500, 100, 300, 400));
  }

  @Test
  void keysTakeBackEndAndLeave() {
    begin();
    clickAt(100, 100, 500, 100, 300, 400, 200, 300);
    type(KeyEvent.VK_BACK_SPACE);
    assertThat(points().size()).isEqualTo(3);
    type(KeyEvent.VK_ENTER);
    frame.checkBox("Edit Vertex").requireSelected();
    type(KeyEvent.VK_D);
    frame.checkBox("Draw Vertex").requireSelected();
    type(KeyEvent.VK_ESCAPE);
    frame.checkBox("Edit Vertex").requireSelected();
    assertThat(points().size()).isEqualTo(3);
  }

  @Test
  void whatTheStatusLineDoesNotShowTakesNoRoomFromTheHint() {
    begin();
    JLabel zoom = frame.label("zoom").target();
    assertThat(onEventThread(() -> zoom.getParent().getWidth()))
        .isEqualTo(onEventThread(zoom::getWidth));
  }

  @Test
  void escapeClosesAnOpenMenuAndLeavesTheDrawingAlone() {
    begin();
    click(() -> robot.click(frame.menuItem("Edit").target()));
    assertThat(onEventThread(() -> openMenus().length)).isPositive();
    robot.pressAndReleaseKeys(KeyEvent.VK_ESCAPE);
    settle();
    assertThat(onEventThread(() -> openMenus().length)).isZero();
    frame.checkBox("Draw Vertex").requireSelected();
  }

  private static MenuElement[] openMenus() {
    return MenuSelectionManager.defaultManager().getSelectedPath();
  }

  @Test
  void anEmptyCanvasSaysWhatDrawsOnIt() {
    begin();
    frame.label(new Titled("Click to draw the first vertex")).requireVisible();
    check("Edit Vertex");
    frame.label(new Titled("Choose Draw Vertex to draw")).requireVisible();
  }

  /** Labels with a text. */
  private static final class Titled extends GenericTypeMatcher<JLabel> {
    private final String text;

    Titled(String text) {
      super(JLabel.class, true);
      this.text = text;
    }

    @Override
    protected boolean isMatching(JLabel label) {
      return label.getText().equals(text);
    }
  }

  @Test
  void aCrossingAndWhatCanBeDoneFitTheStatusLine() {
    begin();
    clickAt(100, 100, 501, 103, 499, 407, 203, 97, 210, 399);
    type(KeyEvent.VK_ENTER);
    JLabel status = frame.label("status").target();
    assertThat(status.getText()).startsWith("Not simple: edges v0–v1 and v2–v3 cross; ");
    assertThat(onEventThread(() -> status.getPreferredSize().width))
        .isLessThan(onEventThread(status::getWidth));
    type(KeyEvent.VK_G, KeyEvent.VK_CONTROL);
    assertThat(status.getText()).startsWith("Here edges v0–v1 and v2–v3 cross (1 of ");
  }

  @Test
  void theProvisionalEdgeIsNoFault() {
    begin();
    clickAt(100, 100, 500, 100, 500, 400, 700, 250);
    requireInk(canvas(), Ink.BOUNDARY, 500, 150);
    type(KeyEvent.VK_ENTER);
    requireInk(canvas(), Ink.DEFECT, 500, 150);
  }

  @Test
  void arrowsMoveACrossAndSpaceClicksThere() {
    begin();
    moveTo(500, 350); // where a robot that takes the keyboard leaves the mouse
    type(KeyEvent.VK_RIGHT, KeyEvent.VK_SHIFT);
    type(KeyEvent.VK_DOWN);
    type(KeyEvent.VK_DOWN);
    assertThat(canvas().corner()).isEqualTo("x 510   y 352");
    type(KeyEvent.VK_SPACE);
    type(KeyEvent.VK_LEFT);
    type(KeyEvent.VK_ENTER);
    assertThat(points()).isEqualTo(Points.ofPairs(510, 352, 509, 352));
    requireInk(canvas(), Ink.LABEL, 509 + 8, 352);
  }

  @Test
  void theMouseDoesNotTakeTheKeyboardAndTheSpaceBarPansWhereItPoints() {
    begin();
    moveTo(300, 300);
    assertThat(onEventThread(() -> canvas().isFocusOwner())).isFalse();
    robot.pressKey(KeyEvent.VK_SPACE);
    press(300, 300);
    moveTo(340, 320);
    release();
    robot.releaseKey(KeyEvent.VK_SPACE);
    settle();
    assertThat(onEventThread(() -> canvas().viewport()))
        .isEqualTo(Viewport.IDENTITY.panned(40, 20));
    frame.checkBox("Draw Vertex").requireSelected();
    assertThat(points().size()).isZero();
  }

  @Test
  void aDialogThatTakesTheReleaseOfTheSpaceBarLeavesNothingPressed() {
    begin();
    takeKeyboard();
    robot.pressKey(KeyEvent.VK_SPACE);
    onEventThread(
        () -> {
          java.awt.EventQueue.invokeLater(window.commands().get("Random Polygon…")::perform);
          return null;
        });
    var dialog = dialog();
    robot.releaseKey(KeyEvent.VK_SPACE);
    answer(dialog, "Cancel");
    clickAt(200, 200);
    assertThat(points()).isEqualTo(Points.ofPairs(200, 200));
    assertThat(onEventThread(() -> canvas().viewport())).isEqualTo(Viewport.IDENTITY);
  }
}
