package dct.render;

import dct.core.Progress;
import dct.core.geometry.Box;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.IntStream;

/** Draws scenes into pixels, the rows of large ones shared out among the cores. */
public final class SceneRaster {
  private static final int SMALL = 2_000; // vertices; fewer are drawn before another core wakes up
  private static final int MOST_AT_ONCE = 150_000; // vertices, drawn within a frame or two
  private static final int BAND = 64; // rows that one core draws on

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
    drawShapes(scene, view, theme, Gauge.SCREEN, scale, image, progress);
    RasterPen whole = new RasterPen(image, 0, image.getHeight(), scale, theme);
    Box screen = new Box(0, 0, image.getWidth() / scale, image.getHeight() / scale);
    ScenePainter.paintLabels(scene, view, screen, new ProgressPen(whole, progress));
  }

  /** Draws all but the labels and notes. */
  static void drawShapes(
      Scene scene,
      Viewport view,
      Theme theme,
      Gauge gauge,
      double scale,
      BufferedImage image,
      Progress progress) {
    int cores = Runtime.getRuntime().availableProcessors();
    int parts = scene.size() <= SMALL ? 1 : Math.min(cores, image.getHeight());
    IntStream.range(0, parts)
        .parallel()
        .forEach(part -> drawRows(scene, view, theme, gauge, scale, image, part, parts, progress));
  }

  /**
   * Turns the picture of a scene into that of another, which is the same but for where one site is,
   * by drawing anew where they look different; if that can be done within a frame of the screen.
   *
   * @param image the picture that {@link #draw} made of {@code before} with the same view, theme
   *     and scale
   * @return whether it is that of {@code now} now; if not, it is as it was
   */
  public static boolean redraw(
      Scene before, Scene now, Viewport view, Theme theme, double scale, BufferedImage image) {
    if (!now.isLike(before)
        || ScenePainter.dotRadius(before, view) != ScenePainter.dotRadius(now, view)) {
      return false;
    }
    Box screen = new Box(0, 0, image.getWidth() / scale, image.getHeight() / scale);
    List<Box> boxes = SceneDifference.between(before, now, view, screen);
    long vertices = ScenePainter.vertices(now, view, boxes);
    if (vertices > MOST_AT_ONCE) {
      return false;
    }
    List<Rectangle> parts = boxes.stream().map(box -> pixels(box, scale)).toList();
    if (vertices <= SMALL) {
      redraw(now, view, theme, scale, image, image.getRaster().getBounds(), parts);
    } else {
      // The parts may overlap; the bands do not.
      IntStream.range(0, (image.getHeight() + BAND - 1) / BAND)
          .mapToObj(band -> new Rectangle(0, band * BAND, image.getWidth(), BAND))
          .parallel()
          .forEach(band -> redraw(now, view, theme, scale, image, band, parts));
    }
    return true;
  }

  private static void redraw(
      Scene scene,
      Viewport view,
      Theme theme,
      double scale,
      BufferedImage image,
      Rectangle within,
      List<Rectangle> parts) {
    Rectangle all = within.intersection(image.getRaster().getBounds());
    for (Rectangle each : parts) {
      Rectangle part = each.intersection(all);
      if (!part.isEmpty()) {
        RasterPen pen = new RasterPen(image, part, scale, theme);
        pen.ground();
        ScenePainter.paintShapes(scene, view, screen(part, scale), pen);
      }
    }
  }

  /** All pixels of the image of which a box holds a part. */
  private static Rectangle pixels(Box box, double scale) {
    int left = (int) Math.floor(box.minX() * scale);
    int top = (int) Math.floor(box.minY() * scale);
    int right = (int) Math.ceil((box.maxX() + 1) * scale);
    int bottom = (int) Math.ceil((box.maxY() + 1) * scale);
    return new Rectangle(left, top, right - left, bottom - top);
  }

  private static Box screen(Rectangle part, double scale) {
    return new Box(
        part.x / scale,
        part.y / scale,
        (part.x + part.width) / scale,
        (part.y + part.height) / scale);
  }

  private static void drawRows(
      Scene scene,
      Viewport view,
      Theme theme,
      Gauge gauge,
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
    ScenePainter.paintShapes(scene, view, rows, gauge, new ProgressPen(pen, progress));
  }
}
