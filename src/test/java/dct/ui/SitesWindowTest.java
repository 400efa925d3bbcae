package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.FlipResult;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.Preference;
import dct.core.degree.ScanFlip;
import dct.core.degree.SearchLimits;
import dct.core.degree.best.BestTriangulation;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.render.Ink;
import dct.render.Viewport;
import dct.ui.canvas.CanvasPanel;
import dct.ui.tool.Spot;
import java.awt.Point;
import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import org.assertj.swing.fixture.JOptionPaneFixture;
import org.junit.jupiter.api.Test;

/** Point Sites Based, by mouse and keyboard. */
class SitesWindowTest extends WindowTest {
  private static final double[] SITES = {
    150, 150, 800, 180, 500, 400, 300, 550, 700, 600, 430, 120, 620, 300, 250, 330, 880, 420, 90,
    620, 520, 620
  };

  @Test
  void theKeyThatAsksForRandomSitesTypesNothingIntoTheirNumber() {
    choose("Point Sites Based");
    takeKeyboard();
    // At once, as a keyboard does it: a robot waits between the events.
    post(KeyEvent.KEY_PRESSED, KeyEvent.VK_R, KeyEvent.CHAR_UNDEFINED);
    post(KeyEvent.KEY_TYPED, KeyEvent.VK_UNDEFINED, 'R');
    post(KeyEvent.KEY_RELEASED, KeyEvent.VK_R, KeyEvent.CHAR_UNDEFINED);
    JOptionPaneFixture form = dialog();
    robot.waitForIdle();
    assertThat(form.textBox("vertices").text()).isEqualTo("100");
    fill(form.textBox("vertices"), "12");
    answer(form, "OK");
    assertThat(points().size()).isEqualTo(12);
  }

  private void post(int id, int key, char letter) {
    int shift = InputEvent.SHIFT_DOWN_MASK;
    long now = System.currentTimeMillis();
    Toolkit.getDefaultToolkit()
        .getSystemEventQueue()
        .postEvent(new KeyEvent(canvas(), id, now, shift, key, letter));
  }

  @Test
  void theTriangulationFollowsEachClick() {
    choose("Point Sites Based");
    for (int n = 1; n <= SITES.length / 2; n++) {
      clickAt(SITES[2 * n - 2], SITES[2 * n - 1]);
      Points sites = Points.ofPairs(java.util.Arrays.copyOf(SITES, 2 * n));
      assertThat(points()).isEqualTo(sites);
      if (n == 2) {
        requireInk(canvas(), Ink.VERTEX, 150, 150);
      }
      if (n >= 3) {
        requireShown(canvas(), delaunay(sites));
      }
    }
  }

  @Test
  void theTriangulationFollowsEachDrag() {
    draw();
    check("Edit Vertex");
    press(500, 400);
    for (double[] to : new double[][] {{400, 300}, {480, 220}, {700, 450}}) {
      moveTo(to[0], to[1]);
      requireShown(canvas(), delaunay(Points.ofPairs(SITES).moved(2, to[0], to[1])));
    }
    release();
    assertThat(points()).isEqualTo(Points.ofPairs(SITES).moved(2, 700, 450));
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(points()).isEqualTo(Points.ofPairs(SITES));
    requireShown(canvas(), delaunay(Points.ofPairs(SITES)));
  }

  @Test
  void aSiteDroppedOnAnotherGoesBack() {
    draw();
    check("Edit Vertex");
    press(500, 400);
    moveTo(300, 550);
    release();
    assertThat(points()).isEqualTo(Points.ofPairs(SITES));
    assertThat(frame.label("status").text()).contains("v3 is already there");
  }

  @Test
  void performFlipShowsInTheCanvasAndAnyEditGoesBack() {
    draw();
    FlipResult flips = ScanFlip.run(delaunay(Points.ofPairs(SITES)), Progress.NONE);
    assertThat(flips.after().count(EdgeKind.FLIPPED)).as("magenta edges").isPositive();
    push("Perform Flip");
    requireShown(canvas(), flips.after());
    assertThat(canvas().scene().counts()).hasSize(2);
    assertThat(results()).isEmpty();
    check("Delete Vertex");
    clickAt(500, 400);
    requireShown(canvas(), delaunay(Points.ofPairs(SITES).removed(2)));
    assertThat(canvas().scene().counts()).hasSize(1);
  }

  @Test
  void mostEvenVerticesShowsTheOptimumAndWhyItIsOne() {
    draw();
    type(KeyEvent.VK_E, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
    await("the optimum", () -> canvas().scene().counts().get(0).contains("— optimal ("));
    requireShown(canvas(), optimum(ParityGoal.allEven(SITES.length / 2)).triangulation());
    type(KeyEvent.VK_O, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT);
    int unmet = optimum(ParityGoal.allOdd(SITES.length / 2)).unmet();
    await(
        "the most odd sites",
        () -> canvas().scene().counts().get(0).startsWith("Even " + unmet + " "));
  }

  private static Optimum optimum(ParityGoal goal) {
    Triangulation delaunay = delaunay(Points.ofPairs(SITES));
    return BestTriangulation.of(
            delaunay, goal, SearchLimits.DEFAULT, Preference.ANGLE, Progress.NONE)
        .optimum();
  }

  @Test
  void wishesAreClickedAndGrantedAndTheUnmetOnesRinged() {
    choose("Point Sites Based");
    clickAt(200, 200, 600, 200, 400, 500);
    type(KeyEvent.VK_W);
    frame.checkBox("Draw Vertex").requireNotSelected();
    clickAt(200, 200, 400, 500, 400, 500);
    assertThat(onEventThread(() -> window.workbench().document().wishes()))
        .isEqualTo(ParityGoal.of(Wish.ODD, Wish.EVEN, Wish.ANY));
    requireInk(canvas(), Ink.BOUNDARY, 400, 200);
    wishedParities();
    JOptionPaneFixture dialog = dialog();
    assertThat(message(dialog)).isEqualTo("Wished: even 1 · odd 1 · any 1.");
    answer(dialog, "Triangulate");
    await("the result", () -> canvas().scene().counts().size() == 2);
    assertThat(canvas().scene().counts().get(1)).startsWith("Granted 2 · Unmet 1 — ");
    requireInk(canvas(), Ink.UNMET, 191.5, 200);
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL); // the search
    assertThat(canvas().scene().counts()).hasSize(1);
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL); // the last click
    assertThat(onEventThread(() -> window.workbench().document().wishes()))
        .isEqualTo(ParityGoal.of(Wish.ODD, Wish.EVEN, Wish.ODD));
    requireShown(canvas(), delaunay(points()));
    check("Edit Vertex");
    frame.checkBox("Edit Vertex").requireSelected();
  }

  @Test
  void withoutWishesTheDialogSaysHowToMakeThem() {
    draw();
    wishedParities();
    JOptionPaneFixture dialog = dialog();
    assertThat(message(dialog)).contains("Edit ▸ Wish Parity");
    answer(dialog, "Cancel");
    assertThat(canvas().scene().counts()).hasSize(1);
  }

  private void wishedParities() {
    clickMenu("Triangulate");
    clickMenu("Wished Parities…");
  }

  @Test
  void splitPutsASiteOnTheClosestEdge() {
    choose("Point Sites Based");
    clickAt(100, 100, 500, 100, 300, 400);
    check("Split Vertex");
    clickAt(250, 108);
    assertThat(points()).isEqualTo(Points.ofPairs(100, 100, 500, 100, 300, 400, 250, 100));
  }

  @Test
  void randomSitesAsksForTheirNumber() {
    choose("Point Sites Based");
    frame.button("Random Sites").click();
    fill(dialog().textBox("vertices"), "ten");
    answer(dialog(), "OK");
    assertThat(message(dialog()))
        .contains("“ten” is no number of sites; type a whole number from 1");
    answer(dialog(), "OK");
    fill(dialog().textBox("vertices"), "1000");
    answer(dialog(), "OK");
    assertThat(points().size()).isEqualTo(1000);
    Triangulation delaunay = delaunay(points());
    assertThat(canvas().scene().edgeCount()).isEqualTo(delaunay.edgeCount());
    for (int v = 0; v < 1000; v += 97) {
      requireInk(canvas(), delaunay.isEven(v) ? Ink.EVEN : Ink.ODD, points().x(v), points().y(v));
    }
    type(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
    assertThat(points().size()).isZero();
  }

  @Test
  void manySitesAreDrawnAndFollowADragAndTheWheel() {
    choose("Point Sites Based");
    frame.button("Random Sites").click();
    fill(dialog().textBox("vertices"), "5000");
    answer(dialog(), "OK");
    await("the sites", () -> points().size() == 5000);
    settle();
    check("Edit Vertex");
    Points before = points();
    Point wheel = at(canvas(), before.x(0), before.y(0));
    onEventThread(
        () -> {
          canvas().zoom(20, wheel.x, wheel.y);
          return null;
        });
    requireShownNear(canvas(), delaunay(before), before.x(0), before.y(0));
    Point held = at(canvas(), before.x(0), before.y(0));
    press(before.x(0), before.y(0));
    moveTo(before.x(0) + 6, before.y(0) + 5);
    Point drop = at(canvas(), before.x(0) + 6, before.y(0) + 5);
    Viewport view = onEventThread(() -> canvas().viewport());
    Spot from = Spot.at(view, held.x, held.y);
    Spot to = Spot.at(view, drop.x, drop.y);
    Points moved =
        before.moved(
            0,
            Spot.rounded(view, before.x(0) + (to.x() - from.x())),
            Spot.rounded(view, before.y(0) + (to.y() - from.y())));
    requireShownNear(canvas(), delaunay(moved), moved.x(0), moved.y(0));
    release();
    assertThat(points()).isEqualTo(moved);
    requireShownNear(canvas(), delaunay(moved), moved.x(0), moved.y(0));
  }

  /** The vertices within eight units have their colours. */
  private void requireShownNear(
      CanvasPanel canvas, Triangulation triangulation, double x, double y) {
    Points sites = triangulation.points();
    for (int v = 0; v < sites.size(); v++) {
      if (Math.hypot(sites.x(v) - x, sites.y(v) - y) < 8) {
        requireInk(canvas, triangulation.isEven(v) ? Ink.EVEN : Ink.ODD, sites.x(v), sites.y(v));
      }
    }
  }

  @Test
  void randomSitesCanBeCancelled() {
    draw();
    frame.button("Random Sites").click();
    JOptionPaneFixture dialog = dialog();
    answer(dialog, "Cancel");
    assertThat(points()).isEqualTo(Points.ofPairs(SITES));
  }

  @Test
  void sitesOnOneLineShowTheirPath() {
    choose("Point Sites Based");
    clickAt(100, 100, 500, 100, 300, 100);
    requireInk(canvas(), Ink.BOUNDARY, 200, 100);
    requireInk(canvas(), Ink.BOUNDARY, 400, 100);
    requireInk(canvas(), Ink.EVEN, 300, 100);
    requireInk(canvas(), Ink.ODD, 100, 100);
    push("Perform Flip");
    requireNoDialog();
  }

  @Test
  void clearCanvasRemovesTheSites() {
    draw();
    push("Clear Canvas");
    assertThat(points().size()).isZero();
    requireInk(canvas(), Ink.BACKGROUND, 500, 400);
  }

  @Test
  void eachApplicationKeepsItsDocument() {
    draw();
    choose("Polygon Based");
    assertThat(points().size()).isZero();
    clickAt(100, 100);
    choose("Point Sites Based");
    assertThat(points()).isEqualTo(Points.ofPairs(SITES));
  }

  private void draw() {
    choose("Point Sites Based");
    clickAt(SITES);
  }

  private static Triangulation delaunay(Points sites) {
    return Delaunay.triangulate(Sites.of(sites, Progress.NONE), Progress.NONE);
  }
}
