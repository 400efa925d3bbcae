package dct.render;

import dct.core.Progress;
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
  private static final Theme THEME = Theme.LIGHT;

  private PictureFile() {}

  /**
   * Writes a picture of the whole scene without a legend, y downwards.
   *
   * @see #write(Scene, PictureView, int, Path, Progress)
   */
  public static void write(Scene scene, Path file, Progress progress) throws CannotWriteException {
    write(scene, PictureView.whole(scene, false), 1, file, progress);
  }

  /**
   * Writes a picture in the format of the file's ending. The file is written whole or not at all.
   *
   * @param view what it shows
   * @param scale pixels of a PNG for each pixel of the screen; other pictures have no pixels
   * @throws IllegalArgumentException if the ending is that of no picture
   * @throws CannotWriteException if writing failed; nothing is changed then
   * @throws java.util.concurrent.CancellationException if cancelled; nothing is changed then
   */
  public static void write(Scene scene, PictureView view, int scale, Path file, Progress progress)
      throws CannotWriteException {
    FileEnding ending = FileEnding.require(file, Content.PICTURE);
    Picture picture = new Picture(scene, view, scale, progress);
    AtomicFile.write(file, progress, out -> picture.write(ending, out));
  }

  /**
   * What is to be seen in a picture, and who is asked whether to go on drawing it.
   *
   * @param scale pixels of an image for each of a screen
   */
  record Picture(Scene scene, PictureView view, int scale, Progress progress) {

    void write(FileEnding ending, OutputStream out) throws IOException {
      switch (ending) {
        case PNG -> PngEncoder.write(image(), out);
        case SVG -> write(svg(), out);
        case PDF -> PdfPage.write(view.width(), view.height(), this::draw, out);
        case IPE -> write(ipe(), out);
        case TEX -> write(tex(), out);
        default -> throw new IllegalArgumentException(ending + " is no picture");
      }
    }

    private static void write(String text, OutputStream out) throws IOException {
      out.write(text.getBytes(StandardCharsets.UTF_8));
    }

    private void paint(Pen pen) {
      ScenePainter.paint(scene, view.viewport(), view.screen(), new ProgressPen(pen, progress));
      view.notes().paint(scene, view.screen(), pen, "");
    }

    private void draw(Graphics2D graphics) {
      GraphicsPen pen = new GraphicsPen(graphics, THEME);
      pen.ground(view.width(), view.height());
      paint(pen);
    }

    /** An image, smoothed. */
    BufferedImage image() {
      BufferedImage image =
          new BufferedImage(
              scale * view.width(), scale * view.height(), BufferedImage.TYPE_INT_RGB);
      SceneRaster.draw(scene, view.viewport(), THEME, scale, image, progress);
      Graphics2D graphics = image.createGraphics();
      graphics.scale(scale, scale);
      view.notes().paint(scene, view.screen(), new GraphicsPen(graphics, THEME), "");
      graphics.dispose();
      return image;
    }

    /** An SVG document. */
    String svg() {
      SvgPen pen = new SvgPen(view.width(), view.height(), THEME);
      paint(pen);
      return pen.finish();
    }

    /** A document of Ipe. */
    String ipe() {
      IpePen pen = new IpePen(view.width(), view.height(), THEME);
      paint(pen);
      return pen.finish();
    }

    /** A LaTeX document. */
    String tex() {
      TikzPen pen = new TikzPen(view.width(), view.height(), THEME);
      paint(pen);
      return pen.finish();
    }
  }
}
