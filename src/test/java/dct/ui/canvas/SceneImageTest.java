package dct.ui.canvas;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.MovingSite;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.RandomSites;
import dct.render.Ink;
import dct.render.Scene;
import dct.render.ScenePainter;
import dct.render.Theme;
import dct.render.Viewport;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;

class SceneImageTest {
  private static final Dimension SIZE = new Dimension(300, 200);
  private static final int GROUND = Ink.BACKGROUND.rgb(Theme.LIGHT);

  private final List<Runnable> background = new ArrayList<>();
  private int drawn;
  private final SceneImage image = new SceneImage(() -> drawn++, background::add);

  /** One vertex at (150, 100), and so many elsewhere outside that it is not drawn at once. */
  private static Scene large() {
    Points crowd = RandomSites.uniform(SceneImage.AT_ONCE, 3);
    double[] x = crowd.xs();
    double[] y = crowd.ys();
    for (int v = 0; v < x.length; v++) {
      x[v] += 10_000;
    }
    return Scene.sites(Points.of(x, y).inserted(0, 150, 100));
  }

  private static View view(Scene scene, Viewport viewport) {
    return new View(scene, viewport, Theme.LIGHT, SIZE, 1);
  }

  @Test
  void aSmallSceneIsThereAtOnce() {
    BufferedImage screen = painted(view(Scene.sites(Points.ofPairs(150, 100)), Viewport.IDENTITY));
    assertThat(background).isEmpty();
    assertThat(rgb(screen, 150, 100)).isEqualTo(Ink.VERTEX.rgb(Theme.LIGHT));
  }

  @Test
  void aLargeSceneIsDrawnInTheBackground() throws Exception {
    View view = view(large(), Viewport.IDENTITY.zoomed(4, 150, 100));
    assertThat(rgb(painted(view), 150, 100)).isEqualTo(GROUND);
    drawInBackground();
    assertThat(drawn).isEqualTo(1);
    assertThat(rgb(painted(view), 150, 100)).isNotEqualTo(GROUND);
    assertThat(background).as("nothing is left to draw").isEmpty();
  }

  @Test
  void theViewBeforeStandsInMovedAndScaled() throws Exception {
    Viewport before = Viewport.IDENTITY.zoomed(4, 150, 100);
    Scene scene = large();
    painted(view(scene, before));
    drawInBackground();
    BufferedImage panned = painted(view(scene, before.panned(40, 30)));
    assertThat(rgb(panned, 190, 130)).isNotEqualTo(GROUND);
    assertThat(rgb(panned, 150, 100)).isEqualTo(GROUND);
    BufferedImage zoomed = painted(view(scene, before.zoomed(1.5, 0, 0)));
    assertThat(rgb(zoomed, 225, 150)).isNotEqualTo(GROUND);
  }

  @Test
  void ofManyViewsTheNewestIsDrawnNext() throws Exception {
    Scene scene = large();
    Viewport start = Viewport.IDENTITY.zoomed(4, 150, 100);
    for (int i = 0; i < 10; i++) {
      painted(view(scene, start.panned(i, 0)));
    }
    assertThat(background).as("only one at a time").hasSize(1);
    drawInBackground();
    View newest = view(scene, start.panned(9, 0));
    painted(newest);
    drawInBackground();
    painted(newest);
    assertThat(background).isEmpty();
  }

  @Test
  void anotherSceneIsNotShownInPlaceOfALargeOne() throws Exception {
    painted(view(Scene.sites(Points.ofPairs(150, 100)), Viewport.IDENTITY));
    assertThat(rgb(painted(view(large(), Viewport.IDENTITY)), 150, 100)).isEqualTo(GROUND);
  }

  /** Sites on the canvas, one of them at (150, 100), so many that they are not drawn at once. */
  private static Triangulation sites() {
    Points crowd = RandomSites.uniform(SceneImage.AT_ONCE, 3).inserted(0, 150.5, 100.5);
    return Delaunay.triangulate(Sites.of(crowd, Progress.NONE), Progress.NONE);
  }

  @Test
  void whereASiteHasMovedThePictureIsRightAtOnce() throws Exception {
    Triangulation sites = sites();
    Scene scene = Scene.of(sites);
    Viewport near = Viewport.IDENTITY.zoomed(6, 150, 100);
    painted(view(scene, near));
    drawInBackground();
    MovingSite moving = MovingSite.of(sites, 0).orElseThrow();
    for (int x = 151; x < 160; x++) {
      View moved = view(scene.moved(moving.to(x, 103)), near);
      assertSamePicture(painted(moved), moved);
    }
    View back = view(scene, near);
    assertSamePicture(painted(back), back);
    assertThat(background).as("nothing is left to draw").isEmpty();
  }

  @Test
  void aMoveDuringADrawingIsThereWhenThatEnds() throws Exception {
    Triangulation sites = sites();
    Scene scene = Scene.of(sites);
    Viewport near = Viewport.IDENTITY.zoomed(6, 150, 100);
    painted(view(scene, near));
    MovingSite moving = MovingSite.of(sites, 0).orElseThrow();
    View moved = view(scene.moved(moving.to(153, 103)), near);
    painted(moved);
    drawInBackground();
    assertSamePicture(painted(moved), moved);
    assertThat(background).as("nothing is left to draw").isEmpty();
  }

  @Test
  void aLargeChangeIsDrawnInTheBackgroundButItsEdgesAreThereAtOnce() throws Exception {
    Triangulation sites =
        Delaunay.triangulate(
            Sites.of(RandomSites.uniform(60_000, 3), Progress.NONE), Progress.NONE);
    Scene scene = Scene.of(sites);
    Viewport all = ScenePainter.fitted(scene, SIZE.width, SIZE.height, false);
    painted(view(scene, all));
    drawInBackground();
    BufferedImage before = painted(view(scene, all));
    MovingSite moving = MovingSite.of(sites, 0).orElseThrow();
    View far = view(scene.moved(moving.to(-1e5, -1e5)), all);
    BufferedImage at = painted(far);
    assertThat(background).hasSize(1);
    assertThat(IntStream.range(0, SIZE.width).filter(x -> rgb(at, x, 5) != rgb(before, x, 5)))
        .as("pixels of the edges to the site outside")
        .isNotEmpty();
    drawInBackground();
    assertSamePicture(painted(far), far);
  }

  private static void assertSamePicture(BufferedImage image, View view) {
    BufferedImage whole = new BufferedImage(SIZE.width, SIZE.height, BufferedImage.TYPE_INT_RGB);
    view.draw(whole);
    for (int y = 0; y < SIZE.height; y++) {
      for (int x = 0; x < SIZE.width; x++) {
        assertThat(rgb(image, x, y)).as("(%d, %d)", x, y).isEqualTo(rgb(whole, x, y));
      }
    }
  }

  private void drawInBackground() throws Exception {
    background.remove(0).run();
    SwingUtilities.invokeAndWait(() -> {}); // behind the end of the drawing
  }

  private BufferedImage painted(View view) {
    BufferedImage screen = new BufferedImage(SIZE.width, SIZE.height, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = screen.createGraphics();
    image.paint(graphics, view);
    graphics.dispose();
    return screen;
  }

  private static int rgb(BufferedImage image, int x, int y) {
    return image.getRGB(x, y) & 0xFFFFFF;
  }
}
