package dct.render;

import dct.core.Progress;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.RandomSites;
import java.awt.image.BufferedImage;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * What a frame of the window costs: Delaunay triangulations of random sites on the canvas of the
 * thesis, as a whole and zoomed in.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class PainterBenchmark {

  /** The sites, triangulated. */
  @State(Scope.Benchmark)
  public static class Drawing {
    @Param({"10000", "100000", "1000000"})
    private int sites;

    private Triangulation triangulation;
    private Scene scene;

    /** Triangulates the sites. */
    @Setup
    public void triangulate() {
      triangulation =
          Delaunay.triangulate(
              Sites.of(RandomSites.uniform(sites, 1), Progress.NONE), Progress.NONE);
      scene = Scene.of(triangulation);
    }
  }

  private static final int WIDTH = 1000;
  private static final int HEIGHT = 700;

  /** Where on the screen they are. */
  @State(Scope.Benchmark)
  public static class Zoom {
    @Param({"1", "4", "16"})
    private double zoom;

    private final BufferedImage image =
        new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);

    private Viewport view(Scene scene) {
      return ScenePainter.fitted(scene, WIDTH, HEIGHT, false)
          .zoomed(zoom, WIDTH / 2.0, HEIGHT / 2.0);
    }
  }

  /** Draws everything in sight into pixels, as the canvas does in the background. */
  @Benchmark
  public BufferedImage frame(Drawing drawing, Zoom zoom) {
    SceneRaster.draw(
        drawing.scene, zoom.view(drawing.scene), Theme.LIGHT, 1, zoom.image, Progress.NONE);
    return zoom.image;
  }

  /**
   * Makes the scene of a triangulation and sorts it by place: what comes before its first frame.
   */
  @Benchmark
  public SceneIndex scene(Drawing drawing) {
    return Scene.of(drawing.triangulation).index();
  }
}
