package dct.render;

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
import javax.imageio.ImageIO;

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
   */
  public static void write(Scene scene, Path file) throws CannotWriteException {
    write(scene, fitted(scene), WIDTH, HEIGHT, file);
  }

  /**
   * Writes what this viewport shows of the scene on a screen of this size.
   *
   * @throws IllegalArgumentException if the ending is that of no picture
   * @throws CannotWriteException if writing failed; nothing is changed then
   */
  public static void write(Scene scene, Viewport view, int width, int height, Path file)
      throws CannotWriteException {
    FileEnding ending = FileEnding.require(file, Content.PICTURE);
    AtomicFile.write(file, out -> write(scene, view, width, height, ending, out));
  }

  /** The viewport of a picture of the whole scene. */
  public static Viewport fitted(Scene scene) {
    return ScenePainter.fitted(scene, WIDTH, HEIGHT, false);
  }

  private static void write(
      Scene scene, Viewport view, int width, int height, FileEnding ending, OutputStream out)
      throws IOException {
    switch (ending) {
      case PNG -> ImageIO.write(image(scene, view, width, height), "png", out);
      case SVG -> write(svg(scene, view, width, height), out);
      case PDF -> PdfPage.write(width, height, g -> draw(scene, view, width, height, g), out);
      case IPE -> write(ipe(scene, view, width, height), out);
      case TEX -> write(tex(scene, view, width, height), out);
      default -> throw new IllegalArgumentException(ending + " is no picture");
    }
  }

  private static void write(String text, OutputStream out) throws IOException {
    out.write(text.getBytes(StandardCharsets.UTF_8));
  }

  private static void draw(Scene scene, Viewport view, int width, int height, Graphics2D graphics) {
    GraphicsPen pen = new GraphicsPen(graphics, THEME);
    pen.ground(width, height);
    ScenePainter.paint(scene, view, new Box(0, 0, width, height), pen);
  }

  /** The scene as an image, smoothed. */
  static BufferedImage image(Scene scene, Viewport view, int width, int height) {
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    SceneRaster.draw(scene, view, THEME, 1, image);
    Graphics2D graphics = image.createGraphics();
    ScenePainter.paintCounts(scene, new Box(0, 0, width, height), new GraphicsPen(graphics, THEME));
    graphics.dispose();
    return image;
  }

  /** The scene as an SVG document. */
  static String svg(Scene scene, Viewport view, int width, int height) {
    SvgPen pen = new SvgPen(width, height, THEME);
    ScenePainter.paint(scene, view, new Box(0, 0, width, height), pen);
    return pen.finish();
  }

  /** The scene as a document of Ipe. */
  static String ipe(Scene scene, Viewport view, int width, int height) {
    IpePen pen = new IpePen(width, height, THEME);
    ScenePainter.paint(scene, view, new Box(0, 0, width, height), pen);
    return pen.finish();
  }

  /** The scene as a LaTeX document. */
  static String tex(Scene scene, Viewport view, int width, int height) {
    TikzPen pen = new TikzPen(width, height, THEME);
    ScenePainter.paint(scene, view, new Box(0, 0, width, height), pen);
    return pen.finish();
  }
}
