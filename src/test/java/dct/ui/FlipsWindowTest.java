package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.degree.DegreeCount;
import dct.core.degree.Flip;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.problem.Solution;
import dct.render.Viewport;
import dct.ui.canvas.CanvasPanel;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.solve.ResultFrame;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.util.Random;
import java.util.stream.IntStream;
import javax.swing.JLabel;
import javax.swing.JSlider;
import javax.swing.JTable;
import org.junit.jupiter.api.Test;

/** Edges are flipped by hand, and what was flipped is listed and played. */
class FlipsWindowTest extends WindowTest {
  private static final double[] DRAWN = {
    100, 100, 300, 60, 500, 120, 560, 300, 800, 200, 900, 400, 850, 600, 600, 650, 450, 500, 200,
    620, 80, 400
  };

  @Test
  void aClickFlipsAnEdgeOfTheSitesAndUndoFlipsItBack() {
    drawSites();
    type(KeyEvent.VK_Q);
    Triangulation delaunay = sites().triangulation();
    int edge = flippable(delaunay);
    hover(canvas(), delaunay, edge);
    assertThat(hint()).startsWith("Click to flip v").contains(" even");
    clickOn(canvas(), delaunay, edge);
    assertThat(Flip.at(sites().triangulation(), edge)).isPresent();
    assertThat(sites().triangulation().from(edge)).isNotEqualTo(delaunay.from(edge));
    assertThat(undoText()).startsWith("Undo Flip v");
    assertThat(hint()).startsWith("Flipped v");
    requireShown(canvas(), sites().triangulation());
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(sites().triangulation()).isSameAs(delaunay);
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
    assertThat(sites().flips().orElseThrow().edges()).containsExactly(edge);
  }

  @Test
  void aPolygonIsFlippedInTheFrameOfItsResultAndUndoneThere() {
    drawPolygon();
    type(KeyEvent.VK_Q);
    assertThat(hint()).contains("in the frame of a result");
    ResultFrame result = pushForResult("Monotone Polygon Triangulation");
    Triangulation before = shown(result);
    int edge = flippable(before);
    clickOn(result.canvas(), before, edge);
    await("the flip", () -> shown(result) != before);
    assertThat(undoText()).startsWith("Undo Flip v");
    assertThat(onEventThread(() -> result.canvas().scene().counts()).get(0)).startsWith("Before");
    requireShown(result.canvas(), shown(result));
    typeIn(result, KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    await("the undo", () -> shown(result) == before);
    assertThat(result.isShowing()).isTrue();
    typeIn(result, KeyEvent.VK_Y, KeyEvent.VK_CONTROL);
    await("the redo", () -> shown(result) != before);
  }

  @Test
  void aFrameOfAPolygonThatHasChangedSaysSoAndDoesNotFlip() {
    drawPolygon();
    ResultFrame result = pushForResult("Monotone Polygon Triangulation");
    Triangulation before = shown(result);
    onEventThread(
        () -> {
          window.workbench().perform(Edit.move(window.workbench().document(), 0, 90, 90));
          return null;
        });
    assertThat(status(result)).contains("no longer the one of this result");
    clickOn(result.canvas(), before, flippable(before));
    assertThat(shown(result)).isSameAs(before);
    assertThat(undoText()).isEqualTo("Undo Edit Vertex v0");
    perform("Undo");
    assertThat(status(result)).doesNotContain("no longer");
    clickOn(result.canvas(), before, flippable(before));
    await("the flip", () -> shown(result) != before);
  }

  @Test
  void flipsAreListedAndPlayedAndAnyStateCanBeGoneOnFrom() {
    loadSites();
    push("Perform Flip");
    Solution flipped = sites();
    int count = flipped.flips().orElseThrow().flips();
    assertThat(count).isGreaterThan(3);
    assertThat(table().isShowing()).isFalse();
    type(KeyEvent.VK_L, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
    await("the list", () -> table().isShowing());
    assertThat(onEventThread(() -> table().getRowCount())).isEqualTo(count);
    type(KeyEvent.VK_HOME, KeyEvent.VK_CONTROL);
    assertThat(place()).isEqualTo("0 of " + count);
    DegreeCount before = flipped.countsBefore().orElseThrow();
    assertThat(onEventThread(() -> canvas().scene().counts()).get(1))
        .isEqualTo("After: Even " + before.even() + " · Odd " + before.odd());
    assertThat(sites()).as("the document").isEqualTo(flipped);
    type(KeyEvent.VK_RIGHT, KeyEvent.VK_CONTROL);
    assertThat(place()).isEqualTo("1 of " + count);
    assertThat(onEventThread(() -> table().getSelectedRow())).isZero();
    type(KeyEvent.VK_ENTER, KeyEvent.VK_CONTROL);
    assertThat(undoText()).isEqualTo("Undo Go On from Flip 1");
    assertThat(sites().flips().orElseThrow().flips()).isEqualTo(1);
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(sites()).isEqualTo(flipped);
    assertThat(place()).isEqualTo(count + " of " + count);
  }

  @Test
  void theSliderShowsAStateAndPlayComesToTheEnd() {
    loadSites();
    push("Perform Flip");
    int count = sites().flips().orElseThrow().flips();
    type(KeyEvent.VK_L, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
    JSlider slider = robot.finder().findByName(window, "flipSlider", JSlider.class, true);
    onEventThread(
        () -> {
          slider.setValue(0);
          return null;
        });
    assertThat(place()).isEqualTo("0 of " + count);
    type(KeyEvent.VK_P, KeyEvent.VK_CONTROL);
    await("the end", () -> place().equals(count + " of " + count));
    assertThat(onEventThread(slider::getValue)).isEqualTo(count);
  }

  @Test
  void copiedFlipsAreAppliedToAnotherTriangulationOfTheSamePoints() {
    drawSites();
    push("Perform Flip");
    Solution flipped = sites();
    perform("Copy Flips");
    perform("Delaunay");
    assertThat(sites().flips()).isEmpty();
    perform("Apply Copied Flips");
    assertThat(undoText()).isEqualTo("Undo Apply Flips");
    assertThat(sites().flips().orElseThrow().edges())
        .isEqualTo(flipped.flips().orElseThrow().edges());
    perform("Apply Copied Flips");
    String sentence = message(dialog());
    assertThat(sentence).contains("clipboard").startsWith("clipboard:2: there is no edge");
    answer(dialog(), "OK");
    assertThat(undoText()).isEqualTo("Undo Apply Flips");
  }

  private void drawSites() {
    choose("Point Sites Based");
    check("Draw Vertex");
    clickAt(DRAWN);
  }

  /** Sites of which Scan-Flip flips some edges. */
  private void loadSites() {
    choose("Point Sites Based");
    Random random = new Random(3);
    double[] pairs = random.doubles(120, 60, 640).map(Math::rint).toArray();
    onEventThread(
        () -> {
          Points points = Points.ofPairs(pairs);
          window.workbench().active().orElseThrow().load(new Document(Domain.SITES, points), "60");
          return null;
        });
    settle();
  }

  private void drawPolygon() {
    choose("Polygon Based");
    check("Draw Vertex");
    clickAt(DRAWN);
  }

  private Solution sites() {
    return onEventThread(() -> window.workbench().shown().solution().orElseThrow());
  }

  @Test
  void theDrawingStaysInSightWhileTheFlipsAreListed() {
    choose("Point Sites Based");
    check("Draw Vertex");
    clickAt(40, 40, 960, 60, 940, 660, 60, 640, 500, 350);
    perform("Fit");
    Viewport fitted = onEventThread(() -> canvas().viewport());
    int height = canvas().getHeight();
    perform("Flips");
    await("less room", () -> canvas().getHeight() < height);
    await("all is in sight", () -> onEventThread(() -> canvas().isAllInSight()));
    perform("Flips");
    await("the room is back", () -> canvas().getHeight() == height);
    await("as before", () -> onEventThread(() -> canvas().viewport().equals(fitted)));

    perform("Zoom In");
    perform("Zoom In");
    Viewport zoomed = onEventThread(() -> canvas().viewport());
    perform("Flips");
    await("less room", () -> canvas().getHeight() < height);
    settle();
    assertThat(onEventThread(() -> canvas().viewport())).isEqualTo(zoomed);
    perform("Flips");
    await("the room is back", () -> canvas().getHeight() == height);
    settle();
    assertThat(onEventThread(() -> canvas().viewport())).isEqualTo(zoomed);
  }

  private static Triangulation shown(ResultFrame result) {
    return onEventThread(() -> result.view().result().orElseThrow().solution().triangulation());
  }

  /** The first edge that can be flipped and whose middle no other edge comes near to. */
  private static int flippable(Triangulation of) {
    return IntStream.range(0, of.edgeCount())
        .filter(edge -> Flip.at(of, edge).isPresent())
        .filter(edge -> isApart(of, edge))
        .findFirst()
        .orElseThrow();
  }

  private static boolean isApart(Triangulation of, int edge) {
    Points points = of.points();
    double x = (points.x(of.from(edge)) + points.x(of.to(edge))) / 2;
    double y = (points.y(of.from(edge)) + points.y(of.to(edge))) / 2;
    return IntStream.range(0, of.edgeCount())
        .filter(other -> other != edge)
        .allMatch(
            other ->
                java.awt.geom.Line2D.ptSegDist(
                        points.x(of.from(other)),
                        points.y(of.from(other)),
                        points.x(of.to(other)),
                        points.y(of.to(other)),
                        x,
                        y)
                    > 20);
  }

  private Point middle(CanvasPanel canvas, Triangulation of, int edge) {
    Points points = of.points();
    return at(
        canvas,
        (points.x(of.from(edge)) + points.x(of.to(edge))) / 2,
        (points.y(of.from(edge)) + points.y(of.to(edge))) / 2);
  }

  private void hover(CanvasPanel canvas, Triangulation of, int edge) {
    robot.moveMouse(canvas, middle(canvas, of, edge));
    await("the hint", () -> hint().startsWith("Click to flip"));
  }

  private void clickOn(CanvasPanel canvas, Triangulation of, int edge) {
    Point place = middle(canvas, of, edge);
    click(() -> robot.click(canvas, place));
  }

  private void typeIn(ResultFrame result, int key, int modifier) {
    robot.focusAndWaitForFocusGain(result.canvas());
    robot.pressKey(modifier);
    robot.pressAndReleaseKeys(key);
    robot.releaseKey(modifier);
    settle();
  }

  private void perform(String command) {
    javax.swing.SwingUtilities.invokeLater(() -> window.commands().get(command).perform());
    robot.waitForIdle();
    settle();
  }

  private String undoText() {
    return onEventThread(() -> window.commands().get("Undo").name());
  }

  private String hint() {
    return onEventThread(
        () -> robot.finder().findByName(window, "status", JLabel.class, true).getText());
  }

  private String place() {
    return onEventThread(
        () -> robot.finder().findByName(window, "flipPlace", JLabel.class, true).getText());
  }

  private JTable table() {
    return robot.finder().findByName(window, "flipList", JTable.class, false);
  }
}
