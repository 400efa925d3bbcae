package dct.render;

import dct.core.Progress;
import dct.core.geometry.Box;
import java.awt.image.BufferedImage;
import java.util.stream.IntStream;

/** Draws scenes into pixels, the rows of large ones shared out among the cores. */
public final class SceneRaster {
  private static final int SMALL = 2_000; // vertices; fewer are drawn before another core wakes up

  private SceneRaster() {}

  /**
   * Draws what a viewport shows of a scene over a whole image; all but the counts, which stay in
   * their corner while the viewport moves.
   *
   * @param scale pixels of the image per pixel of the viewport's screen
   * @param image of type {@link BufferedImage#TYPE_INT_RGB}
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static void draw(
      Scene scene,
      Viewport view,
      Theme theme,
      double scale,
      BufferedImage image,
      Progress progress) {
    int cores = Runtime.getRuntime().availableProcessors();
    int parts = scene.points().size() <= SMALL ? 1 : Math.min(cores, image.getHeight());
    IntStream.range(0, parts)
        .parallel()
        .forEach(part -> drawRows(scene, view, theme, scale, image, part, parts, progress));
    RasterPen whole = new RasterPen(image, 0, image.getHeight(), scale, theme);
    Box screen = new Box(0, 0, image.getWidth() / scale, image.getHeight() / scale);
    ScenePainter.paintLabels(scene, view, screen, new ProgressPen(whole, progress));
  }

  private static void drawRows(
      Scene scene,
      Viewport view,
      Theme theme,
      double scale,
      BufferedImage image,
      int part,
      int parts,
      Progress progress) {
    int top = (int) ((long) image.getHeight() * part / parts);
    int bottom = (int) ((long) image.getHeight() * (part + 1) / parts);
    RasterPen pen = new RasterPen(image, top, bottom, scale, theme);
    pen.ground();
    Box rows = new Box(0, top / scale, image.getWidth() / scale, bottom / scale);
    ScenePainter.paintShapes(scene, view, rows, new ProgressPen(pen, progress));
  }
}
