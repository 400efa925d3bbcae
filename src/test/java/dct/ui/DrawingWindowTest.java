package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import dct.render.Ink;
import dct.render.Viewport;
import java.awt.event.KeyEvent;
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
