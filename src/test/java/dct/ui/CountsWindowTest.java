package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.Flip;
import dct.core.geometry.Points;
import dct.problem.KnownBound;
import dct.problem.Solution;
import dct.render.Notes;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.solve.ResultFrame;
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

  @Test
  void theBoundIsShownOnRequestAndFollowsFlipsAndEdits() {
    choose("Point Sites Based");
    draw(Points.ofPairs(200, 200, 700, 220, 600, 560, 250, 520, 450, 390));
    assertThat(counts()[0]).doesNotContain("—");
    type(KeyEvent.VK_B);
    requireBound();
    onEventThread(
        () -> {
          Solution shown = window.workbench().inCanvas().orElseThrow();
          int edge = 0;
          while (Flip.at(shown.triangulation(), edge).isEmpty()) {
            edge++;
          }
          window.workbench().flips().solution();
          window.workbench().flips().flip(edge);
          return null;
        });
    settle();
    requireBound();
    draw(Points.ofPairs(200, 200, 700, 220, 600, 560));
    requireBound();
    assertThat(counts()[0]).endsWith("— best possible");
    type(KeyEvent.VK_B);
    assertThat(counts()[0]).doesNotContain("—");
  }

  @Test
  void theBoundIsInTheViewsOfAPolygonToo() {
    choose("Polygon Based");
    check("Draw Vertex");
    clickAt(100, 100, 300, 60, 500, 120, 560, 300, 500, 500, 200, 560);
    type(KeyEvent.VK_B);
    ResultFrame monotone = pushForResult("Monotone Polygon Triangulation");
    await(
        "the bound",
        () -> last(monotone).endsWith(words(monotone.view().result().get().solution())));
    push("Clear Canvas");
    assertThat(last(monotone)).endsWith(words(monotone.view().result().get().solution()));
  }

  private static String last(ResultFrame frame) {
    return onEventThread(() -> String.join(" ", frame.canvas().scene().counts()));
  }

  private void requireBound() {
    await(
        "the bound of what is shown",
        () ->
            onEventThread(
                () ->
                    String.join(" ", canvas().scene().counts())
                        .endsWith(words(window.workbench().inCanvas().orElseThrow()))));
  }

  private static String words(Solution solution) {
    return "— " + KnownBound.best(solution, Progress.NONE).words(solution);
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
