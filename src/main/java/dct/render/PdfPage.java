package dct.render;

import de.rototor.pdfbox.graphics2d.PdfBoxGraphics2D;
import de.rototor.pdfbox.graphics2d.PdfBoxGraphics2DFontTextDrawer;
import java.awt.Font;
import java.awt.FontFormatException;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.font.FontRenderContext;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import org.apache.pdfbox.pdfwriter.compress.CompressParameters;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.apache.pdfbox.pdmodel.PDPage;
import org.apache.pdfbox.pdmodel.PDPageContentStream;
import org.apache.pdfbox.pdmodel.common.PDRectangle;
import org.apache.pdfbox.pdmodel.font.PDFont;
import org.apache.pdfbox.pdmodel.font.PDType0Font;
import org.apache.pdfbox.util.Matrix;

/** A PDF document of one page, as large as its drawing. The same drawing gives the same bytes. */
public final class PdfPage {
  private static final String FONT = "/org/apache/pdfbox/resources/ttf/LiberationSans-Regular.ttf";

  private PdfPage() {}

  /** The font of all text: without serifs, the letters used embedded. */
  static PDType0Font font(PDDocument document) throws IOException {
    try (InputStream letters = PDDocument.class.getResourceAsStream(FONT)) {
      return PDType0Font.load(document, Objects.requireNonNull(letters, FONT), true);
    }
  }

  /** The same font, for text that is laid out before it is drawn on a page. */
  public static Font letters() {
    try (InputStream letters = PDDocument.class.getResourceAsStream(FONT)) {
      return Font.createFont(Font.TRUETYPE_FONT, Objects.requireNonNull(letters, FONT));
    } catch (IOException | FontFormatException e) {
      throw new IllegalStateException(FONT, e);
    }
  }

  /**
   * Writes what is drawn on a page of this size; text is text, also where the outlines of its
   * {@link #letters} are filled.
   *
   * @param points the points of a printer for each unit of the size and of what is drawn
   */
  public static void write(
      String title,
      int width,
      int height,
      double points,
      Consumer<Graphics2D> drawing,
      OutputStream out)
      throws IOException {
    try (PDDocument document = new PDDocument()) {
      document.setDocumentId(1L); // otherwise it is the time
      document.getDocumentInformation().setTitle(title);
      PDPage page =
          new PDPage(new PDRectangle((float) (points * width), (float) (points * height)));
      document.addPage(page);
      PdfBoxGraphics2D graphics = new TextGraphics(document, width, height);
      graphics.setFontTextDrawer(new OneFont(font(document)));
      drawing.accept(graphics);
      graphics.dispose();
      try (PDPageContentStream content = new PDPageContentStream(document, page)) {
        content.transform(Matrix.getScaleInstance((float) points, (float) points));
        content.drawForm(graphics.getXFormObject());
      }
      document.save(out, CompressParameters.NO_COMPRESSION); // PDF 1.4, for older TeX
    }
  }

  /** Writes text where the outlines of its letters are filled. */
  private static final class TextGraphics extends PdfBoxGraphics2D {
    TextGraphics(PDDocument document, int width, int height) throws IOException {
      super(document, width, height);
    }

    @Override
    public FontRenderContext getFontRenderContext() {
      return OutlinedText.MEASURE;
    }

    @Override
    public void fill(Shape shape) {
      Optional<OutlinedText> found =
          shape instanceof Path2D ? OutlinedText.of(shape, getFont()) : Optional.empty();
      if (found.isPresent()) {
        AffineTransform before = getTransform();
        transform(found.get().at());
        drawString(found.get().text(), 0, 0);
        setTransform(before);
      } else {
        super.fill(shape);
      }
    }
  }

  /** Draws all text with one font, whatever was asked for. */
  private static final class OneFont extends PdfBoxGraphics2DFontTextDrawer {
    private final PDFont font;

    OneFont(PDFont font) {
      this.font = font;
    }

    @Override
    protected PDFont mapFont(Font asked, IFontTextDrawerEnv env) {
      return font;
    }
  }
}
