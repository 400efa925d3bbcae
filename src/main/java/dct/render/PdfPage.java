package dct.render;

import de.rototor.pdfbox.graphics2d.PdfBoxGraphics2D;
import de.rototor.pdfbox.graphics2d.PdfBoxGraphics2DFontTextDrawer;
import java.awt.Font;
import java.awt.Graphics2D;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Objects;
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

  /**
   * Writes what is drawn on a page of this size; text is text.
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
      PdfBoxGraphics2D graphics = new PdfBoxGraphics2D(document, width, height);
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
