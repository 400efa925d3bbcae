package dct.ui.canvas;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.render.Ink;
import dct.render.Scene;
import dct.render.Theme;
import java.awt.Graphics2D;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;

/** Canvases that are linked, without a window: moved by calls and by events sent to them. */
class LinksTest {
  private static final double[] SITES = {100, 100, 900, 120, 500, 600, 480, 300};

  private final Links links = new Links();
  private final CanvasPanel drawing = canvas(1000, 700, SITES);
  private final CanvasPanel first = canvas(600, 480, SITES);
  private final CanvasPanel second = canvas(600, 480, SITES);

  LinksTest() {
    links.addDrawing(drawing);
    links.add(first);
    links.add(second);
  }

  private static CanvasPanel canvas(int width, int height, double... sites) {
    CanvasPanel canvas = new CanvasPanel();
    canvas.setSize(width, height);
    Sites usable = Sites.of(Points.ofPairs(sites), Progress.NONE);
    canvas.setScene(Scene.of(Delaunay.triangulate(usable, Progress.NONE)));
    return canvas;
  }

  @Test
  void canvasesOfOneSizeShowTheSameAndOthersTheSamePart() {
    first.zoom(3, 200, 100);
    assertThat(second.viewport()).isEqualTo(first.viewport());
    assertThat(drawing.viewport().modelX(500))
        .isCloseTo(first.viewport().modelX(300), within(1e-9));
    assertThat(drawing.viewport().modelY(350))
        .isCloseTo(first.viewport().modelY(240), within(1e-9));
    assertThat(drawing.viewport().scale()).isGreaterThan(first.viewport().scale());
  }

  @Test
  void goingToAndFroDoesNotDrift() {
    first.zoom(2, 200, 100);
    double before = first.viewport().scale();
    for (int i = 0; i < 20; i++) {
      drawing.pan(10, 0);
      first.pan(-6, 0);
    }
    assertThat(first.viewport().scale()).isCloseTo(before, within(1e-9));
  }

  @Test
  void otherPointsAndCanvasesThatWereTakenOutStayWhereTheyAre() {
    CanvasPanel other = canvas(600, 480, 100, 100, 900, 120, 500, 601, 480, 300);
    links.add(other);
    links.remove(second);
    first.zoom(3, 200, 100);
    assertThat(other.viewport().scale()).isEqualTo(1);
    assertThat(second.viewport().scale()).isEqualTo(1);
  }

  @Test
  void aViewThatHasNoRoomYetShowsEverythingOnceItHas() {
    CanvasPanel late = canvas(0, 0, SITES);
    links.add(late);
    drawing.fit();
    late.setSize(600, 480);
    links.resized(late);
    assertThat(late.isAllInSight()).isTrue();
    assertThat(late.viewport()).isEqualTo(first.viewport());
    late.setSize(0, 0);
    links.resized(late);
    assertThat(late.viewport()).isEqualTo(first.viewport());
  }

  @Test
  void withoutLinksEachGoesItsOwnWay() {
    links.setOn(false);
    first.zoom(3, 200, 100);
    assertThat(second.viewport().scale()).isEqualTo(1);
    assertThat(links.isOn()).isFalse();
  }

  @Test
  void aNewViewShowsTheChosenPartOrElseEverything() {
    links.resized(first);
    links.resized(second);
    assertThat(first.isAllInSight()).isTrue();
    assertThat(drawing.viewport().scale()).isEqualTo(1);
    first.zoom(5, 300, 200);
    CanvasPanel late = canvas(600, 480, SITES);
    links.add(late);
    links.resized(late);
    assertThat(late.viewport()).isEqualTo(first.viewport());
  }

  @Test
  void aNewViewShowsThePartOfADrawingThatIsOutOfSight() {
    links.quietly(() -> drawing.zoom(8, 480, 300));
    links.resized(first);
    assertThat(first.viewport().modelX(300))
        .isCloseTo(drawing.viewport().modelX(500), within(1e-9));
  }

  @Test
  void whereAllOfTheDrawingIsInSightSoItIsInTheViews() {
    CanvasPanel open = canvas(1000, 700, 40, 40, 640, 80, 60, 600, 300, 200);
    CanvasPanel view = canvas(600, 480, 40, 40, 640, 80, 60, 600, 300, 200);
    Links others = new Links();
    others.addDrawing(open);
    others.add(view);
    open.showWell();
    assertThat(open.viewport().scale()).isEqualTo(1);
    assertThat(view.isAllInSight()).isTrue();
    view.setSize(500, 300);
    others.resized(view);
    assertThat(view.isAllInSight()).isTrue();
  }

  @Test
  void aViewThatIsAllInSightIsSoInASmallerOne() {
    first.fit();
    first.pan(0, -50);
    CanvasPanel small = canvas(600, 300, SITES);
    links.add(small);
    links.resized(small);
    assertThat(first.isAllInSight()).isTrue();
    assertThat(small.isAllInSight()).isTrue();
  }

  @Test
  void whatIsUnderTheMouseIsMarkedInTheOthersOnly() {
    point(first, 480, 300);
    assertThat(isMarked(second, 488, 300)).isTrue();
    assertThat(isMarked(first, 488, 300)).isFalse();
    point(first, 20, 450);
    assertThat(isMarked(second, 488, 300)).isFalse();
  }

  @Test
  void aClickTakesTheMarkAwayForWhatIsClickedMayBeGone() {
    point(first, 480, 300);
    send(first, MouseEvent.MOUSE_PRESSED, 480, 300, MouseEvent.BUTTON1);
    assertThat(isMarked(second, 488, 300)).isFalse();
  }

  private static void point(CanvasPanel canvas, int x, int y) {
    send(canvas, MouseEvent.MOUSE_MOVED, x, y, MouseEvent.NOBUTTON);
  }

  private static void send(CanvasPanel canvas, int what, int x, int y, int button) {
    canvas.dispatchEvent(new MouseEvent(canvas, what, 0, 0, x, y, 0, false, button));
  }

  private static boolean isMarked(CanvasPanel canvas, int x, int y) {
    BufferedImage image = new BufferedImage(600, 480, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = image.createGraphics();
    canvas.paint(graphics);
    graphics.dispose();
    return (image.getRGB(x, y) & 0xFFFFFF) == Ink.HIGHLIGHT.rgb(Theme.LIGHT);
  }
}
