package dct.render;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Box;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.RandomSites;
import java.awt.image.BufferedImage;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Large scenes, drawn by several cores and by the block. */
class SceneRasterTest {
  private static final int WIDTH = 400;
  private static final int HEIGHT = 300;

  private static Triangulation delaunay(int n) {
    return Delaunay.triangulate(Sites.of(RandomSites.uniform(n, 4), Progress.NONE), Progress.NONE);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 1.5, 2})
  void thePartsOfAPictureMakeTheWhole(double scale) {
    requirePartsMakeTheWhole(Scene.of(delaunay(3000)), scale);
    Points tangled = RandomSites.uniform(3000, 4);
    requirePartsMakeTheWhole(Scene.outline(Rings.ofChain(tangled), false, List.of()), scale);
  }

  private static void requirePartsMakeTheWhole(Scene scene, double scale) {
    Viewport view = ScenePainter.fitted(scene, WIDTH / scale, HEIGHT / scale, false);
    BufferedImage parts = image();
    SceneRaster.draw(scene, view, Theme.LIGHT, scale, parts, Progress.NONE);
    BufferedImage whole = image();
    RasterPen pen = new RasterPen(whole, 0, HEIGHT, scale, Theme.LIGHT);
    pen.ground();
    Box screen = new Box(0, 0, WIDTH / scale, HEIGHT / scale);
    ScenePainter.paintShapes(scene, view, screen, pen);
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        assertThat(parts.getRGB(x, y)).as("(%d, %d)", x, y).isEqualTo(whole.getRGB(x, y));
      }
    }
  }

  @Test
  void nothingInSightIsPassedOver() {
    Triangulation delaunay = delaunay(5000);
    Scene scene = Scene.of(delaunay);
    for (double zoom : new double[] {1, 3, 30}) {
      Viewport view = ScenePainter.fitted(scene, WIDTH, HEIGHT, false).zoomed(zoom, 200, 150);
      RecordingPen pen = new RecordingPen();
      Box screen = new Box(0, 0, WIDTH, HEIGHT);
      ScenePainter.paint(scene, view, screen, pen);
      assertThat(pen.shapes.stream().filter(s -> isDot(s) && screen.holds(s.x(), s.y())).count())
          .as("dots at zoom %s", zoom)
          .isEqualTo(dotsIn(delaunay.points(), view, screen));
      assertThat(pen.shapes.stream().filter(s -> s.kind().equals("line")).count())
          .as("lines at zoom %s", zoom)
          .isGreaterThanOrEqualTo(edgesFrom(delaunay, view, screen));
    }
  }

  private static boolean isDot(RecordingPen.Shape shape) {
    return shape.kind().equals("disc") || shape.kind().equals("square");
  }

  private static long dotsIn(Points points, Viewport view, Box screen) {
    long count = 0;
    for (int v = 0; v < points.size(); v++) {
      count += screen.holds(view.screenX(points.x(v)), view.screenY(points.y(v))) ? 1 : 0;
    }
    return count;
  }

  /** The edges that begin and end on the screen and are too long for the dots to cover. */
  private static long edgesFrom(Triangulation delaunay, Viewport view, Box screen) {
    double covered = 2 * ScenePainter.dotRadius(Scene.of(delaunay), view);
    Points points = delaunay.points();
    long count = 0;
    for (int edge = 0; edge < delaunay.edgeCount(); edge++) {
      double ax = view.screenX(points.x(delaunay.from(edge)));
      double ay = view.screenY(points.y(delaunay.from(edge)));
      double bx = view.screenX(points.x(delaunay.to(edge)));
      double by = view.screenY(points.y(delaunay.to(edge)));
      boolean seen = screen.holds(ax, ay) && screen.holds(bx, by);
      count += seen && Math.hypot(ax - bx, ay - by) > covered + 1e-6 ? 1 : 0;
    }
    return count;
  }

  private static BufferedImage image() {
    return new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
  }
}
