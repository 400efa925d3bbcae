package dct.render;

import dct.core.Progress;
import dct.core.geometry.Box;
import dct.io.AtomicFile;
import dct.io.CannotWriteException;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/** Writes scenes as pictures: light on white, the whole scene with a margin round it. */
public final class PictureFile {
  /** The width of a picture unless asked otherwise: that of the thesis's canvas. */
  public static final int WIDTH = 1000;

  /** The height of a picture unless asked otherwise. */
  public static final int HEIGHT = 700;

  private static final Theme THEME = Theme.LIGHT;

  private PictureFile() {}

  /**
   * Writes a picture of the whole scene, y downwards, in the format of the file's ending. The file
   * is written whole or not at all.
   *
   * @throws IllegalArgumentException if the ending is that of no picture
   * @throws CannotWriteException if writing failed; nothing is changed then
   * @throws java.util.concurrent.CancellationException if cancelled; nothing is changed then
   */
  public static void write(Scene scene, Path file, Progress progress) throws CannotWriteException {
    write(scene, fitted(scene), WIDTH, HEIGHT, 1, file, progress);
  }

  /**
   * Writes what this viewport shows of the scene on a screen of this size.
   *
   * @param scale pixels of a PNG for each pixel of the screen; other pictures have no pixels
   * @throws IllegalArgumentException if the ending is that of no picture
   * @throws CannotWriteException if writing failed; nothing is changed then
   * @throws java.util.concurrent.CancellationException if cancelled; nothing is changed then
   */
  public static void write(
      Scene scene, Viewport view, int width, int height, int scale, Path file, Progress progress)
      throws CannotWriteException {
    FileEnding ending = FileEnding.require(file, Content.PICTURE);
    Picture picture = new Picture(scene, view, width, height, scale, progress);
    AtomicFile.write(file, progress, out -> picture.write(ending, out));
  }

  /** The viewport of a picture of the whole scene. */
  public static Viewport fitted(Scene scene) {
    return ScenePainter.fitted(scene, WIDTH, HEIGHT, false);
  }

  /**
   * What is to be seen in a picture, and who is asked whether to go on drawing it.
   *
   * @param width of the picture, as {@code height} in pixels of a screen
   * @param scale pixels of an image for each of those
   */
  record Picture(Scene scene, Viewport view, int width, int height, int scale, Progress progress) {

    void write(FileEnding ending, OutputStream out) throws IOException {
      switch (ending) {
        case PNG -> PngEncoder.write(image(), out);
        case SVG -> write(svg(), out);
        case PDF -> PdfPage.write(width, height, this::draw, out);
        case IPE -> write(ipe(), out);
        case TEX -> write(tex(), out);
        default -> throw new IllegalArgumentException(ending + " is no picture");
      }
    }

    private static void write(String text, OutputStream out) throws IOException {
      out.write(text.getBytes(StandardCharsets.UTF_8));
    }

    private void paint(Pen pen) {
      ScenePainter.paint(scene, view, new Box(0, 0, width, height), new ProgressPen(pen, progress));
    }

    private void draw(Graphics2D graphics) {
      GraphicsPen pen = new GraphicsPen(graphics, THEME);
      pen.ground(width, height);
      paint(pen);
    }

    /** An image, smoothed. */
    BufferedImage image() {
      BufferedImage image =
          new BufferedImage(scale * width, scale * height, BufferedImage.TYPE_INT_RGB);
      SceneRaster.draw(scene, view, THEME, scale, image, progress);
      Graphics2D graphics = image.createGraphics();
      graphics.scale(scale, scale);
      ScenePainter.paintCounts(
          scene, new Box(0, 0, width, height), new GraphicsPen(graphics, THEME));
      graphics.dispose();
      return image;
    }

    /** An SVG document. */
    String svg() {
      SvgPen pen = new SvgPen(width, height, THEME);
      paint(pen);
      return pen.finish();
    }

    /** A document of Ipe. */
    String ipe() {
      IpePen pen = new IpePen(width, height, THEME);
      paint(pen);
      return pen.finish();
    }

    /** A LaTeX document. */
    String tex() {
      TikzPen pen = new TikzPen(width, height, THEME);
      paint(pen);
      return pen.finish();
    }
  }
}
