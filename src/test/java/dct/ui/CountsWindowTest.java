package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import dct.render.Notes;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import java.awt.event.KeyEvent;
import java.util.stream.IntStream;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;

/** The counts beside the vertices. */
class CountsWindowTest extends WindowTest {

  /** Sites in rows, up to the borders of the canvas. */
  private static Points crowd() {
    int columns = 25;
    int count = 500;
    double[] x = IntStream.range(0, count).mapToDouble(i -> 5 + 41.0 * (i % columns)).toArray();
    double[] y =
        IntStream.range(0, count)
            .mapToDouble(i -> 5 + 36.0 * Math.floorDiv(i, columns) + (i % 3))
            .toArray();
    return Points.of(x, y);
  }

  @Test
  void aCrowdIsFittedBesideTheCountsAndFlipsLeaveThemWhereTheyAre() {
    choose("Point Sites Based");
    draw(crowd());
    await("the counts are aside", () -> aside().equals(String.join("   ", counts())));
    type(KeyEvent.VK_F);
    await("the counts are back", () -> aside().isEmpty() && notes().away().isEmpty());
    push("Perform Flip");
    await("the counts before, too", () -> counts().length == 2);
    settle();
    assertThat(aside()).isEmpty();
    assertThat(notes().counts()).isEqualTo(Notes.at(false).counts());
    zoomIn();
    await("no room is left", () -> aside().equals(String.join("   ", counts())));
  }

  @Test
  void whatIsShownWellUpToTheBordersIsFitted() {
    choose("Point Sites Based");
    draw(crowd());
    assertThat(onEventThread(() -> canvas().viewport().scale())).isEqualTo(1);
    onEventThread(
        () -> {
          canvas().showWell();
          return null;
        });
    assertThat(onEventThread(() -> canvas().viewport().scale())).isLessThan(1);
    await("the counts have room", () -> notes().away().isEmpty());
    JLabel zoom = frame.label("zoom").target();
    await("nothing is cut", () -> onEventThread(() -> isWhole(zoom)));
  }

  private static boolean isWhole(JLabel label) {
    return label.getX() + label.getPreferredSize().width <= label.getParent().getWidth();
  }

  private void zoomIn() {
    onEventThread(
        () -> {
          canvas().zoom(1.2, 500, 350);
          return null;
        });
    settle();
  }

  private void draw(Points points) {
    onEventThread(
        () -> {
          Editor editor = window.workbench().active().orElseThrow();
          Document before = editor.document();
          Document after = new Document(before.domain(), points);
          editor.perform(new Edit.Replace("Draw", before, after));
          return null;
        });
    settle();
  }

  private String aside() {
    return onEventThread(
        () -> robot.finder().findByName(window, "aside", JLabel.class, false).getText());
  }

  private Notes notes() {
    return onEventThread(() -> canvas().notes());
  }

  private String[] counts() {
    return onEventThread(() -> canvas().scene().counts().toArray(String[]::new));
  }
}
