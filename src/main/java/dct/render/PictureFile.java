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
import java.util.Locale;
import java.util.Optional;

/** Writes scenes as pictures. */
public final class PictureFile {
  private static final int MOST_FOR_TEX = 3_000; // edges that TeX draws in about a second
  private static final int TOO_MANY_FOR_TEX = 20_000; // that nearly fill its usual memory

  private PictureFile() {}

  /**
   * Writes a picture in the format of the file's ending. The file is written whole or not at all.
   *
   * @param name what the picture shows, for its title; may be empty
   * @throws IllegalArgumentException if the ending is that of no picture
   * @throws CannotWriteException if writing failed; nothing is changed then
   * @throws java.util.concurrent.CancellationException if cancelled; nothing is changed then
   */
  public static void write(
      Scene scene, PictureStyle style, String name, Path file, Progress progress)
      throws CannotWriteException {
    FileEnding ending = FileEnding.require(file, Content.PICTURE);
    AtomicFile.write(file, progress, out -> write(scene, style, name, ending, out, progress));
  }

  /** The same to a stream, in the format of this ending. */
  public static void write(
      Scene scene,
      PictureStyle style,
      String name,
      FileEnding ending,
      OutputStream out,
      Progress progress)
      throws IOException {
    Picture.of(scene, style, name, progress).write(ending, out);
  }

  /**
   * A picture as the image that a PNG holds; it is opaque.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static BufferedImage image(Scene scene, PictureStyle style, Progress progress) {
    Picture picture = Picture.of(scene, style, "", progress);
    return picture.image(picture.sheet.pixels());
  }

  /**
   * A picture as an image of about this width, for a look at it before it is written.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static BufferedImage preview(
      Scene scene, PictureStyle style, int width, Progress progress) {
    Picture picture = Picture.of(scene, style, "", progress);
    return picture.image(width / picture.sheet.width());
  }

  /** What should be said before a scene is written to a file of this ending, if anything. */
  public static Optional<String> warning(Scene scene, FileEnding ending) {
    boolean isSlow = ending == FileEnding.TEX && scene.edgeCount() > MOST_FOR_TEX;
    return isSlow
        ? Optional.of(
            String.format(
                Locale.ROOT,
                "TeX needs seconds for %d edges each time, and above some %d it runs out of memory;"
                    + " a .pdf of the same picture is included at once",
                scene.edgeCount(),
                TOO_MANY_FOR_TEX))
        : Optional.empty();
  }

  /**
   * What is to be seen in a picture, and who is asked whether to go on drawing it.
   *
   * @param shown what a window shows, with its notes; nothing for a figure
   * @param isStandalone whether TikZ is a document of its own
   */
  record Picture(
      Sheet sheet,
      Optional<PictureView> shown,
      boolean isStandalone,
      Title title,
      Progress progress) {

    static Picture of(Scene scene, PictureStyle style, String name, Progress progress) {
      Title title = Title.of(name, scene);
      if (style instanceof Figure figure) {
        Sheet sheet = SheetLayout.of(scene, figure);
        return new Picture(sheet, Optional.empty(), figure.isStandalone(), title, progress);
      }
      PictureView view = (PictureView) style;
      return new Picture(Sheet.of(scene, view), Optional.of(view), false, title, progress);
    }

    void write(FileEnding ending, OutputStream out) throws IOException {
      switch (ending) {
        case PNG -> PngEncoder.write(image(sheet.pixels()), out);
        case SVG -> write(svg(), out);
        case PDF -> pdf(out);
        case IPE -> write(ipe(), out);
        case TEX -> write(tex(), out);
        default -> throw new IllegalArgumentException(ending + " is no picture");
      }
    }

    private static void write(String text, OutputStream out) throws IOException {
      out.write(text.getBytes(StandardCharsets.UTF_8));
    }

    private void paint(Pen pen) {
      sheet.paint(new ProgressPen(pen, progress));
      notes(pen);
    }

    private void notes(Pen pen) {
      shown.ifPresent(view -> view.notes().paint(sheet.scene(), view.screen(), pen, ""));
    }

    /** An image, smoothed, with so many pixels for each unit of the sheet. */
    BufferedImage image(double pixels) {
      BufferedImage image =
          new BufferedImage(
              (int) Math.max(1, Math.round(pixels * sheet.width())),
              (int) Math.max(1, Math.round(pixels * sheet.height())),
              BufferedImage.TYPE_INT_RGB);
      SceneRaster.drawShapes(
          sheet.scene(), sheet.view(), sheet.theme(), sheet.gauge(), pixels, image, progress);
      Graphics2D graphics = image.createGraphics();
      graphics.scale(pixels, pixels);
      GraphicsPen pen = new GraphicsPen(graphics, sheet.theme());
      sheet.paintWords(new ProgressPen(pen, progress));
      notes(pen);
      graphics.dispose();
      return image;
    }

    private void pdf(OutputStream out) throws IOException {
      try (PdfPen pen = new PdfPen(sheet, title)) {
        paint(pen);
        pen.finish(out);
      }
    }

    /** An SVG document. */
    String svg() {
      SvgPen pen = new SvgPen(sheet, title);
      paint(pen);
      return pen.finish();
    }

    /** A document of Ipe. */
    String ipe() {
      IpePen pen = new IpePen(sheet, title);
      paint(pen);
      return pen.finish();
    }

    /** TikZ: a part of a LaTeX document, or one of its own. */
    String tex() {
      TikzPen pen = new TikzPen(sheet, title);
      paint(pen);
      return isStandalone ? pen.document() : pen.fragment();
    }
  }
}
