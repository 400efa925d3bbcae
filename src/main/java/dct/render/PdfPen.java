package dct.render;

import java.awt.Font;
import java.awt.font.FontRenderContext;
import java.awt.geom.AffineTransform;
import java.awt.geom.PathIterator;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import org.apache.pdfbox.pdfwriter.compress.CompressParameters;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.apache.pdfbox.pdmodel.PDDocumentInformation;
import org.apache.pdfbox.pdmodel.PDPage;
import org.apache.pdfbox.pdmodel.PDPageContentStream;
import org.apache.pdfbox.pdmodel.common.PDRectangle;
import org.apache.pdfbox.pdmodel.font.PDType0Font;
import org.apache.pdfbox.pdmodel.graphics.state.RenderingMode;
import org.apache.pdfbox.util.Matrix;

/**
 * Writes a drawing as a PDF document of one page as large as it is. Text is text, in a font of
 * which the letters used are embedded; what the font lacks is drawn as shapes. The same drawing
 * gives the same bytes.
 */
final class PdfPen implements Pen, AutoCloseable {
  private static final double CIRCLE = 4 * (Math.sqrt(2) - 1) / 3; // by four curves of Bézier
  private static final float[] SOLID = {};
  private static final FontRenderContext SHAPES = new FontRenderContext(null, true, true);

  private final PDDocument document = new PDDocument();
  private final PDPageContentStream out;
  private final PDType0Font font;
  private final Theme theme;
  private Stroke stroke = Stroke.fill(Ink.LABEL);

  /** A page for a sheet, with its ground. */
  PdfPen(Sheet sheet, Title title) throws IOException {
    theme = sheet.theme();
    document.setDocumentId(1L); // otherwise it is the time
    PDDocumentInformation about = document.getDocumentInformation();
    about.setTitle(title.title());
    about.setSubject(title.description());
    about.setCreator("Degree Constrained Triangulation");
    PDPage page =
        new PDPage(new PDRectangle((float) sheet.pointsWide(), (float) sheet.pointsHigh()));
    document.addPage(page);
    font = PdfPage.font(document);
    out = new PDPageContentStream(document, page);
    // From here on the units are the drawing's, and y runs down.
    float unit = (float) sheet.points();
    out.transform(new Matrix(unit, 0, 0, -unit, 0, (float) sheet.pointsHigh()));
    out.setLineJoinStyle(1);
    style(Stroke.fill(Ink.BACKGROUND));
    rectangle(0, 0, sheet.width(), sheet.height());
  }

  /** Writes the whole document; nothing can be drawn after. */
  void finish(OutputStream to) throws IOException {
    out.close();
    document.save(to, CompressParameters.NO_COMPRESSION); // PDF 1.4, for older TeX
  }

  @Override
  public void close() throws IOException {
    document.close();
  }

  /** Something that writes to the page. */
  private interface Drawing {
    void draw() throws IOException;
  }

  private static void drawn(Drawing drawing) {
    try {
      drawing.draw();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void style(Stroke following) {
    stroke = following;
    drawn(
        () -> {
          colours(following.ink());
          out.setLineWidth((float) following.width());
          out.setLineDashPattern(following.dashed() ? new float[] {5, 5} : SOLID, 0);
        });
  }

  private void colours(Ink ink) throws IOException {
    float[] parts = new java.awt.Color(ink.rgb(theme)).getRGBColorComponents(null);
    out.setStrokingColor(parts[0], parts[1], parts[2]);
    out.setNonStrokingColor(parts[0], parts[1], parts[2]);
  }

  @Override
  public void line(double x1, double y1, double x2, double y2) {
    drawn(
        () -> {
          out.moveTo((float) x1, (float) y1);
          out.lineTo((float) x2, (float) y2);
          out.stroke();
        });
  }

  @Override
  public void disc(double x, double y, double radius) {
    drawn(
        () -> {
          circle(x, y, radius);
          out.fill();
        });
  }

  @Override
  public void ring(double x, double y, double radius) {
    drawn(
        () -> {
          circle(x, y, radius);
          out.stroke();
        });
  }

  private void circle(double x, double y, double r) throws IOException {
    double k = CIRCLE * r;
    out.moveTo((float) (x + r), (float) y);
    curve(x + r, y + k, x + k, y + r, x, y + r);
    curve(x - k, y + r, x - r, y + k, x - r, y);
    curve(x - r, y - k, x - k, y - r, x, y - r);
    curve(x + k, y - r, x + r, y - k, x + r, y);
    out.closePath();
  }

  private void curve(double x1, double y1, double x2, double y2, double x3, double y3)
      throws IOException {
    out.curveTo((float) x1, (float) y1, (float) x2, (float) y2, (float) x3, (float) y3);
  }

  @Override
  public void rectangle(double x, double y, double width, double height) {
    drawn(
        () -> {
          out.addRect((float) x, (float) y, (float) width, (float) height);
          out.fill();
        });
  }

  @Override
  public void polygon(double[] x, double[] y) {
    drawn(
        () -> {
          out.moveTo((float) x[0], (float) y[0]);
          for (int i = 1; i < x.length; i++) {
            out.lineTo((float) x[i], (float) y[i]);
          }
          out.closePath();
          out.fillEvenOdd();
        });
  }

  @Override
  public void text(double x, double y, Anchor anchor, double size, String text) {
    drawn(
        () -> {
          if (hasAll(text)) {
            letters(x, y, anchor, size, text);
          } else {
            outlines(x, y, anchor, size, text);
          }
        });
  }

  private boolean hasAll(String text) {
    try {
      font.encode(text);
      return true;
    } catch (IllegalArgumentException | IOException e) {
      return false;
    }
  }

  private static double left(double x, Anchor anchor, double width) {
    return switch (anchor) {
      case START -> x;
      case MIDDLE -> x - width / 2;
      case END -> x - width;
    };
  }

  /** Letters of the font, over a rim in the colour of the ground. */
  private void letters(double x, double y, Anchor anchor, double size, String text)
      throws IOException {
    double left = left(x, anchor, font.getStringWidth(text) * size / 1000);
    out.beginText();
    out.setFont(font, (float) size);
    out.setTextMatrix(new Matrix(1, 0, 0, -1, (float) left, (float) y));
    rim(true);
    out.showText(text);
    rim(false);
    out.setTextMatrix(new Matrix(1, 0, 0, -1, (float) left, (float) y));
    out.showText(text);
    out.endText();
  }

  private void rim(boolean isOn) throws IOException {
    out.setRenderingMode(isOn ? RenderingMode.STROKE : RenderingMode.FILL);
    out.setLineWidth(isOn ? GraphicsPen.RIM : (float) stroke.width());
    colours(isOn ? Ink.BACKGROUND : stroke.ink());
  }

  private void outlines(double x, double y, Anchor anchor, double size, String text)
      throws IOException {
    Font any = new Font(Font.SANS_SERIF, Font.PLAIN, 1).deriveFont((float) size);
    var glyphs = any.createGlyphVector(SHAPES, text);
    double left = left(x, anchor, glyphs.getLogicalBounds().getWidth());
    double[] at = new double[6];
    PathIterator path =
        glyphs.getOutline().getPathIterator(AffineTransform.getTranslateInstance(left, y));
    double fromX = 0;
    double fromY = 0;
    for (; !path.isDone(); path.next()) {
      int kind = path.currentSegment(at);
      switch (kind) {
        case PathIterator.SEG_MOVETO -> out.moveTo((float) at[0], (float) at[1]);
        case PathIterator.SEG_LINETO -> out.lineTo((float) at[0], (float) at[1]);
        case PathIterator.SEG_QUADTO ->
            curve(
                fromX + (at[0] - fromX) * 2 / 3,
                fromY + (at[1] - fromY) * 2 / 3,
                at[2] + (at[0] - at[2]) * 2 / 3,
                at[3] + (at[1] - at[3]) * 2 / 3,
                at[2],
                at[3]);
        case PathIterator.SEG_CUBICTO -> curve(at[0], at[1], at[2], at[3], at[4], at[5]);
        default -> out.closePath();
      }
      int end = kind == PathIterator.SEG_QUADTO ? 2 : kind == PathIterator.SEG_CUBICTO ? 4 : 0;
      fromX = at[end];
      fromY = at[end + 1];
    }
    out.fill();
  }
}
