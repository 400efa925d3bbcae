package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.SimplicityCheck;
import dct.core.triangulate.Domain;
import dct.ui.document.Document;
import java.awt.event.KeyEvent;
import org.assertj.swing.fixture.JOptionPaneFixture;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A polygon with a hole that is tied to its outline: what the window offers. */
class TouchingWindowTest extends WindowTest {
  private static final Points TIED =
      Points.ofPairs(
          100, 100, 400, 100, 400, 400, 100, 400, 100, 100, 200, 200, 200, 300, 300, 300, 300, 200,
          200, 200);

  @BeforeEach
  void load() {
    onEventThread(
        () -> {
          window.workbench().choose(Domain.POLYGON);
          window.workbench().chooseEdit();
          window
              .workbench()
              .editor(Domain.POLYGON)
              .load(new Document(Domain.POLYGON, TIED), "tied");
          return null;
        });
    settle();
  }

  private void perform(String command) {
    javax.swing.SwingUtilities.invokeLater(() -> window.commands().get(command).perform());
  }

  private boolean isSimple() {
    return SimplicityCheck.firstDefect(points(), Progress.NONE).isEmpty();
  }

  @Test
  void itIsPartedByAHairInOneStep() {
    assertThat(frame.label("status").text()).contains("Split Ring…, Part by a Hair");
    perform("Part by a Hair");
    await("a simple polygon", this::isSimple);
    assertThat(points().size()).isEqualTo(TIED.size());
    assertThat(frame.label("status").text())
        .isEqualTo("The polygon is simple now; 4 vertices moved a hair");
    settle();
    assertThat(onEventThread(() -> window.commands().get("Part by a Hair").isEnabled())).isFalse();
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(points()).isEqualTo(TIED);
  }

  @Test
  void oneOfItsRingsIsChosenFromPictures() {
    perform("Split Ring…");
    JOptionPaneFixture question = dialog();
    question.list("shapes").requireItemCount(2).selectItem(1);
    answer(question, "Open");
    await("the hole", () -> points().size() == 4);
    assertThat(points()).isEqualTo(Points.ofPairs(200, 200, 200, 300, 300, 300, 300, 200));
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(points()).isEqualTo(TIED);
  }

  @Test
  void triangulatingOffersWhatHelps() {
    click(() -> frame.button("Monotone Polygon Triangulation").click());
    JOptionPaneFixture refusal = dialog();
    assertThat(message(refusal)).contains("vertices v0 and v4 are both at (100, 100)");
    answer(refusal, "Part by a Hair");
    await("a simple polygon", this::isSimple);
    perform("Undo");
    await("as before", () -> points().equals(TIED));
    perform("Split Ring…");
    answer(dialog(), "All as Sites");
    await("sites", () -> window.workbench().isChosen(Domain.SITES));
    assertThat(points().size()).isEqualTo(8);
  }
}
