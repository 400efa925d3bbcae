package dct.ui.canvas;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import dct.experiment.generate.RandomSites;
import dct.render.Ink;
import dct.render.Scene;
import dct.render.Theme;
import dct.render.Viewport;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
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
