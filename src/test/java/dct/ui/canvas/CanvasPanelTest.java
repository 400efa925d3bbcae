package dct.ui.canvas;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.render.Ink;
import dct.render.Labels;
import dct.render.Scene;
import dct.render.Theme;
import dct.render.Viewport;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The canvas without a window or a display: drawn into an image, moved by events sent to it. */
class CanvasPanelTest {
  private final CanvasPanel canvas = new CanvasPanel();

  @BeforeEach
  void size() {
    canvas.setSize(1000, 700);
    Points sites = Points.ofPairs(100, 100, 900, 100, 500, 600);
    canvas.setScene(Scene.of(Delaunay.triangulate(Sites.of(sites, Progress.NONE), Progress.NONE)));
  }

  @Test
  void theSceneIsPaintedInTheViewport() {
    assertThat(colour(100, 100)).isEqualTo(Ink.EVEN.rgb(Theme.LIGHT));
    assertThat(colour(500, 100)).isEqualTo(Ink.BOUNDARY.rgb(Theme.LIGHT));
    assertThat(colour(500, 300)).isEqualTo(Ink.BACKGROUND.rgb(Theme.LIGHT));
    canvas.setViewport(Viewport.IDENTITY.panned(50, 20));
    assertThat(colour(150, 120)).isEqualTo(Ink.EVEN.rgb(Theme.LIGHT));
    assertThat(colour(100, 100)).isEqualTo(Ink.BACKGROUND.rgb(Theme.LIGHT));
  }

  @Test
  void theWheelZoomsAtTheMouse() {
    double before = canvas.viewport().modelX(300);
    canvas.dispatchEvent(
        new MouseWheelEvent(canvas, MouseEvent.MOUSE_WHEEL, 0, 0, 300, 200, 0, false, 0, 3, -2));
    assertThat(canvas.viewport().scale()).isGreaterThan(1.4);
    assertThat(canvas.viewport().modelX(300)).isEqualTo(before);
  }

  @Test
  void theMiddleButtonPans() {
    send(MouseEvent.MOUSE_PRESSED, 300, 200);
    send(MouseEvent.MOUSE_DRAGGED, 340, 190);
    send(MouseEvent.MOUSE_RELEASED, 340, 190);
    send(MouseEvent.MOUSE_DRAGGED, 400, 400);
    assertThat(canvas.viewport()).isEqualTo(Viewport.IDENTITY.panned(40, -10));
  }

  private void send(int id, int x, int y) {
    canvas.dispatchEvent(
        new MouseEvent(
            canvas, id, 0, InputEvent.BUTTON2_DOWN_MASK, x, y, 1, false, MouseEvent.BUTTON2));
  }

  @Test
  void fitShowsEverythingAndActualSizeTheCanvasOfTheThesis() {
    canvas.setScene(Scene.sites(Points.ofPairs(-1e6, 0, 1e6, 5)));
    canvas.fit();
    assertThat(canvas.viewport().screenX(-1e6)).isBetween(0.0, 100.0);
    assertThat(canvas.viewport().screenX(1e6)).isBetween(900.0, 1000.0);
    canvas.showActualSize();
    assertThat(canvas.viewport()).isEqualTo(Viewport.IDENTITY);
  }

  @Test
  void whatFitsTheThesissCanvasIsShownInActualSize() {
    canvas.showWell();
    assertThat(canvas.viewport()).isEqualTo(Viewport.IDENTITY);
    canvas.setScene(Scene.sites(Points.ofPairs(0, 0, 3, 2)));
    canvas.showWell();
    assertThat(canvas.viewport().scale()).isGreaterThan(50);
  }

  @Test
  void labelsStayWithTheCanvas() {
    canvas.setLabels(new Labels(true, false));
    canvas.setScene(Scene.sites(Points.ofPairs(1, 1)));
    assertThat(canvas.scene().labels().numbers()).isTrue();
  }

  private int colour(int x, int y) {
    BufferedImage image = new BufferedImage(1000, 700, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = image.createGraphics();
    ((Component) canvas).printAll(graphics);
    graphics.dispose();
    return image.getRGB(x, y) & 0xFFFFFF;
  }
}
