package dct.render.chart;

import dct.core.Progress;
import dct.io.AtomicFile;
import dct.io.CannotWriteException;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import dct.render.PdfPage;
import dct.render.PngEncoder;
import dct.render.Theme;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/**
 * Writes charts as pictures, light on white. A PDF is as wide as both columns of a paper, with
 * letters of 7 to 9 pt.
 */
public final class ChartFile {
  private static final int WIDTH = 900;
  private static final int HEIGHT = 480;
  private static final int PAGE_WIDTH = 774; // of a PDF: 174 mm, both columns of a paper
  private static final int PAGE_HEIGHT = 430;
  private static final double POINTS = 0.637; // of each unit there: letters of 11 are 7 pt
  private static final int DOTS = 2; // of an image, for each unit

  private ChartFile() {}

  /**
   * Writes a chart in the format of the file's ending, whole or not at all.
   *
   * @throws IllegalArgumentException if the ending is no format
   * @throws CannotWriteException if writing failed; nothing is changed then
   */
  public static void write(Chart chart, Path file) throws CannotWriteException {
    FileEnding ending = FileEnding.require(file, Content.CHART);
    AtomicFile.write(file, Progress.NONE, out -> write(chart, ending, out));
  }

  private static void write(Chart chart, FileEnding ending, OutputStream out) throws IOException {
    switch (ending) {
      case PNG -> PngEncoder.write(image(chart), out);
      case SVG -> out.write(svg(chart).getBytes(StandardCharsets.UTF_8));
      case PDF ->
          PdfPage.write(
              chart.title(),
              PAGE_WIDTH,
              PAGE_HEIGHT,
              POINTS,
              graphics ->
                  ChartPainter.paint(
                      chart, graphics, PAGE_WIDTH, PAGE_HEIGHT, Theme.LIGHT, PdfPage.letters()),
              out);
      default -> throw new IllegalArgumentException(ending + " is no chart");
    }
  }

  private static void paint(Chart chart, Graphics2D graphics) {
    ChartPainter.paint(chart, graphics, WIDTH, HEIGHT, Theme.LIGHT);
  }

  private static BufferedImage image(Chart chart) {
    BufferedImage image =
        new BufferedImage(DOTS * WIDTH, DOTS * HEIGHT, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = image.createGraphics();
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.scale(DOTS, DOTS);
    paint(chart, graphics);
    graphics.dispose();
    return image;
  }

  private static String svg(Chart chart) {
    SvgGraphics graphics = new SvgGraphics(chart.title(), WIDTH, HEIGHT);
    paint(chart, graphics);
    return graphics.finish();
  }
}
