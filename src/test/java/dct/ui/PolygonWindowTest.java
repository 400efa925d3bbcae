package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dct.core.Decimals;
import dct.core.Progress;
import dct.core.degree.DegreeCount;
import dct.core.degree.FlipResult;
import dct.core.degree.OddFan;
import dct.core.degree.PartitioningAqt;
import dct.core.degree.ScanFlip;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.PolygonShape;
import dct.render.Ink;
import dct.ui.solve.ResultFrame;
import dct.ui.tool.Spot;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.util.List;
import org.assertj.swing.fixture.JOptionPaneFixture;
import org.junit.jupiter.api.Test;

/** Polygon Based, by mouse and keyboard. */
class PolygonWindowTest extends WindowTest {
  /** Two wide convex parts and a corner, so that every method cuts it into pieces. */
  private static final double[] DRAWN = {
    100, 100, 300, 60, 500, 120, 560, 300, 800, 200, 900, 400, 850, 600, 600, 650, 450, 500, 200,
    620, 80, 400
  };

  @Test
  void clicksDrawThePolygon() {
    draw(DRAWN);
    assertThat(points()).isEqualTo(Points.ofPairs(DRAWN));
    assertThat(frame.textBox("coordinates").text()).startsWith("100 100\n300 60\n500 120\n");
    requireInk(canvas(), Ink.BOUNDARY, 200, 80);
    requireInk(canvas(), Ink.VERTEX, 500, 120);
    assertThat(window.getTitle()).startsWith("*");
  }

  @Test
  void threeButtonsOpenThreeFrames() {
    draw(DRAWN);
    SimplePolygon polygon = SimplePolygon.of(Points.ofPairs(DRAWN), Progress.NONE);
    Triangulation even = PartitioningAqt.triangulate(polygon, Progress.NONE);
    Triangulation odd = OddFan.triangulate(polygon, Progress.NONE);
    Triangulation monotone = MonotoneTriangulation.triangulate(polygon, Progress.NONE);
    for (Triangulation each : new Triangulation[] {even, odd, monotone}) {
      assertThat(each.count(EdgeKind.DIAGONAL)).isPositive();
      assertThat(each.count(EdgeKind.PARTITION)).isPositive();
    }
    requireShown(pushForResult("Convex Polygon Even Triangulation").canvas(), even);
    requireShown(pushForResult("Convex Polygon Odd Triangulation").canvas(), odd);
    requireShown(pushForResult("Monotone Polygon Triangulation").canvas(), monotone);
    assertThat(results()).hasSize(3);
  }

  @Test
  void performFlipShowsTheMostRecentTriangulationFlippedBesideTheOldOne() {
    draw(DRAWN);
    FlipResult flips = flips(MonotoneTriangulation.triangulate(polygon(), Progress.NONE));
    ResultFrame old = pushForResult("Monotone Polygon Triangulation");
    ResultFrame flipped = pushForResult("Perform Flip");
    assertThat(old.isShowing()).isTrue();
    assertThat(flipped.canvas().scene().counts())
        .hasSize(2)
        .first()
        .asString()
        .isEqualTo("Before: " + old.canvas().scene().counts().get(0));
    DegreeCount after = DegreeCount.of(flips.after());
    assertThat(flipped.canvas().scene().counts().get(1))
        .contains("Even " + after.even() + " ", "Odd " + after.odd());
    enlarge(flipped); // in a small frame one edge covers the middle of another
    requireShown(flipped.canvas(), flips.after());
  }

  private void enlarge(ResultFrame view) {
    onEventThread(
        () -> {
          view.setBounds(0, 0, 1200, 860);
          view.validate();
          return null;
        });
    await("a wide canvas", () -> onEventThread(() -> view.canvas().getWidth()) > 1000);
    robot.waitForIdle();
  }

  @Test
  void performFlipWithoutATriangulationBeginsWithTheMonotoneOne() {
    draw(DRAWN);
    FlipResult flips = flips(MonotoneTriangulation.triangulate(polygon(), Progress.NONE));
    requireShown(pushForResult("Perform Flip").canvas(), flips.after());
  }

  private static FlipResult flips(Triangulation triangulation) {
    FlipResult flips = ScanFlip.run(triangulation, Progress.NONE);
    assertThat(flips.after().count(EdgeKind.FLIPPED)).as("magenta diagonals").isPositive();
    return flips;
  }

  private static SimplePolygon polygon() {
    return SimplePolygon.of(Points.ofPairs(DRAWN), Progress.NONE);
  }

  @Test
  void wishesAreGrantedInAFrameOfTheirOwn() {
    draw(100, 100, 500, 100, 500, 400, 100, 400);
    type(KeyEvent.VK_W);
    clickAt(100, 100, 500, 100); // the diagonal cannot end in just one of them
    type(KeyEvent.VK_W, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
    answer(dialog(), "Triangulate");
    await("the frame", () -> results().size() == 1);
    ResultFrame result = (ResultFrame) results().get(0);
    assertThat(result.canvas().scene().counts())
        .hasSize(2)
        .last()
        .asString()
        .startsWith("Granted 2 · Unmet 2 — optimal (");
    boolean first = result.canvas().scene().ink(0) == Ink.ODD;
    double right = 9 / onEventThread(() -> result.canvas().viewport().scale());
    requireInk(result.canvas(), Ink.UNMET, (first ? 500 : 100) + right, 100);
    requireInk(result.canvas(), Ink.UNMET, (first ? 500 : 100) + right, 400);
  }

  @Test
  void randomPolygonAsksForNumberShapeAndSeed() {
    draw(DRAWN);
    askForRandomPolygon("two", PolygonShape.TWO_OPT, "1");
    assertThat(message(dialog())).contains("“two” is no number of vertices");
    answer(dialog(), "OK");
    answer(dialog(), "Cancel");
    assertThat(points()).isEqualTo(Points.ofPairs(DRAWN));
    askForRandomPolygon("61", PolygonShape.ORTHOGONAL, "-5");
    assertThat(message(dialog())).contains("an orthogonal polygon has an even number");
    answer(dialog(), "OK");
    assertThat(points()).isEqualTo(Points.ofPairs(DRAWN));
    askForRandomPolygon("60", PolygonShape.ORTHOGONAL, "-5");
    Points expected = PolygonShape.ORTHOGONAL.generate(60, -5).points();
    await("the polygon", () -> points().equals(expected));
    requireInk(canvas(), Ink.VERTEX, expected.x(7), expected.y(7));
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(points()).isEqualTo(Points.ofPairs(DRAWN));
  }

  private void askForRandomPolygon(String n, PolygonShape shape, String seed) {
    type(KeyEvent.VK_R, KeyEvent.VK_CONTROL);
    fill(dialog().textBox("vertices"), n);
    dialog().comboBox("shape").selectItem(shape.title());
    fill(dialog().textBox("seed"), seed);
    answer(dialog(), "OK");
  }

  @Test
  void deleteJoinsTheNeighbours() {
    draw(100, 100, 300, 200, 500, 100, 300, 400);
    check("Delete Vertex");
    clickAt(302, 199);
    assertThat(points()).isEqualTo(Points.ofPairs(100, 100, 500, 100, 300, 400));
    requireInk(canvas(), Ink.BOUNDARY, 300, 100);
    clickAt(700, 600);
    assertThat(points().size()).isEqualTo(3);
  }

  @Test
  void splitPutsAVertexOnTheClosestEdge() {
    draw(100, 100, 500, 100, 300, 400);
    check("Split Vertex");
    clickAt(250, 108);
    assertThat(points()).isEqualTo(Points.ofPairs(100, 100, 250, 100, 500, 100, 300, 400));
    clickAt(195, 253); // the edge back to v0
    assertThat(points().size()).isEqualTo(5);
    assertThat(points().y(4)).isCloseTo(1.5 * (points().x(4) - 100) + 100, within(1.0));
  }

  @Test
  void editDragsAVertexInOneStep() {
    draw(100, 100, 500, 100, 300, 400);
    check("Edit Vertex");
    press(500, 100);
    moveTo(550, 150);
    moveTo(600, 300);
    requireInk(canvas(), Ink.BOUNDARY, 350, 200); // the outline follows before the release
    release();
    assertThat(points()).isEqualTo(Points.ofPairs(100, 100, 600, 300, 300, 400));
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(points()).isEqualTo(Points.ofPairs(100, 100, 500, 100, 300, 400));
  }

  @Test
  void escapePutsADraggedVertexBack() {
    draw(100, 100, 500, 100, 300, 400);
    check("Edit Vertex");
    press(500, 100);
    moveTo(600, 300);
    type(KeyEvent.VK_ESCAPE);
    release();
    assertThat(points()).isEqualTo(Points.ofPairs(100, 100, 500, 100, 300, 400));
    requireInk(canvas(), Ink.BOUNDARY, 300, 100);
  }

  @Test
  void undoAndRedoGoThroughEveryEdit() {
    draw(100, 100, 500, 100, 300, 400);
    check("Split Vertex");
    clickAt(250, 100);
    Points split = points();
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(points().size()).isEqualTo(3);
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(points().size()).isEqualTo(2);
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
    type(KeyEvent.VK_Y, KeyEvent.VK_CONTROL);
    assertThat(points()).isEqualTo(split);
    clickMenu("Edit");
    frame.menuItem("Undo").requireEnabled();
    assertThat(onEventThread(() -> frame.menuItem("Undo").target().getText()))
        .isEqualTo("Undo Split Vertex v1");
    clickMenu("Undo");
    assertThat(points().size()).isEqualTo(3);
  }

  @Test
  void clearCanvasRemovesEverythingAndCanBeUndone() {
    draw(100, 100, 500, 100, 300, 400);
    push("Clear Canvas");
    assertThat(points().size()).isZero();
    assertThat(frame.textBox("coordinates").text()).isEmpty();
    requireInk(canvas(), Ink.BACKGROUND, 300, 100);
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(points().size()).isEqualTo(3);
  }

  @Test
  void crossingEdgesAreRedAndTheButtonsSayWhichTheyAre() {
    draw(100, 100, 500, 400, 500, 100, 100, 400);
    requireInk(canvas(), Ink.DEFECT, 200, 175);
    requireInk(canvas(), Ink.DEFECT, 400, 175);
    frame.button("Monotone Polygon Triangulation").click();
    JOptionPaneFixture dialog = dialog();
    assertThat(message(dialog)).contains("edges v0–v1 and v2–v3 cross at (300, 250)");
    answer(dialog, "Show Me");
    assertThat(at(canvas(), 300, 250)).isEqualTo(new java.awt.Point(500, 350));
    assertThat(results()).isEmpty();
    assertThat(points().size()).isEqualTo(4);
    frame.checkBox("Edit Vertex").requireSelected();
  }

  @Test
  void theCrossingShownHasAMarkUntilThePolygonIsEdited() {
    draw(100, 100, 500, 400, 500, 100, 100, 400);
    frame.button("Monotone Polygon Triangulation").click();
    answer(dialog(), "Show Me");
    double reach = 17 / onEventThread(() -> canvas().viewport().scale());
    requireInk(canvas(), Ink.HIGHLIGHT, 300 + reach, 250);
    requireInk(canvas(), Ink.HIGHLIGHT, 300, 250 - reach);
    check("Split Vertex");
    clickAt(200, 175);
    requireInk(canvas(), Ink.INSIDE, 300 + reach, 250);
  }

  @Test
  void thePolygonIsUntangledOrUsedAsSitesFromTheDialogThatAsksForASimpleOne() {
    draw(100, 100, 500, 400, 500, 100, 100, 400);
    frame.button("Monotone Polygon Triangulation").click();
    answer(dialog(), "Use as Sites");
    frame.radioButton("Point Sites Based").requireSelected();
    assertThat(points().size()).isEqualTo(4);
    choose("Polygon Based");
    frame.button("Monotone Polygon Triangulation").click();
    answer(dialog(), "Untangle");
    assertThat(onEventThread(() -> window.workbench().active().orElseThrow().shown().defects()))
        .isEmpty();
    pushForResult("Monotone Polygon Triangulation");
  }

  @Test
  void twoVerticesAreNoPolygonYet() {
    draw(100, 100, 500, 400);
    frame.button("Perform Flip").click();
    JOptionPaneFixture dialog = dialog();
    assertThat(message(dialog)).contains("2 vertices");
    answer(dialog, "OK");
    assertThat(results()).isEmpty();
  }

  @Test
  void aClickWhereAVertexIsAddsNothing() {
    draw(100, 100, 500, 400);
    clickAt(100, 100);
    assertThat(points().size()).isEqualTo(2);
    assertThat(frame.label("status").text()).contains("v0 is already there");
  }

  @Test
  void lettersChooseTheTools() {
    draw(100, 100, 500, 400, 200, 500);
    type(KeyEvent.VK_X);
    frame.checkBox("Delete Vertex").requireSelected();
    frame.checkBox("Draw Vertex").requireNotSelected();
    clickAt(500, 400);
    assertThat(points().size()).isEqualTo(2);
    type(KeyEvent.VK_D);
    frame.checkBox("Draw Vertex").requireSelected();
  }

  @Test
  void theMouseCoordinatesAreInTheUpperLeftCorner() {
    choose("Polygon Based");
    moveTo(123, 456);
    await("the coordinates", () -> canvas().corner().equals("x 123   y 456"));
    requireInk(canvas(), Ink.LABEL, 16, 20);
  }

  @Test
  void theMouseCoordinatesAreOfWhatIsUnderTheMouseNow() {
    draw(100, 100, 500, 400, 500, 100, 100, 400);
    check("Edit Vertex");
    moveTo(600, 456);
    Point place = at(canvas(), 600, 456);
    for (String command : List.of("Go to Crossing", "Fit", "Zoom In", "Y Axis Up")) {
      onEventThread(
          () -> {
            window.commands().get(command).perform();
            return null;
          });
      settle();
      assertThat(onEventThread(canvas()::corner)).as(command).isEqualTo(coordinates(place));
      assertThat(frame.label("status").text()).startsWith("Here "); // is not written over
    }
    robot.moveMouse(frame.checkBox("Edit Vertex").target());
    await("the mouse is gone", () -> onEventThread(() -> canvas().corner().isEmpty()));
    onEventThread(
        () -> {
          window.commands().get("Zoom Out").perform();
          return null;
        });
    settle();
    assertThat(onEventThread(canvas()::corner)).isEmpty();
  }

  private String coordinates(Point place) {
    Spot spot = onEventThread(() -> Spot.at(canvas().viewport(), place.x, place.y));
    return "x " + Decimals.format(spot.x()) + "   y " + Decimals.format(spot.y());
  }

  private void draw(double... coordinates) {
    choose("Polygon Based");
    check("Draw Vertex");
    clickAt(coordinates);
  }
}
