package dct.render;

import de.rototor.pdfbox.graphics2d.PdfBoxGraphics2D;
import java.awt.Graphics2D;
import java.io.IOException;
import java.io.OutputStream;
import java.util.function.Consumer;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.apache.pdfbox.pdmodel.PDPage;
import org.apache.pdfbox.pdmodel.PDPageContentStream;
import org.apache.pdfbox.pdmodel.common.PDRectangle;

/** A PDF document of one page, as large as its drawing. The same drawing gives the same bytes. */
public final class PdfPage {

  private PdfPage() {}

  /** Writes what is drawn on a page of this size, in points. */
  public static void write(int width, int height, Consumer<Graphics2D> drawing, OutputStream out)
      throws IOException {
    try (PDDocument document = new PDDocument()) {
      document.setDocumentId(1L); // otherwise it is the time
      PDPage page = new PDPage(new PDRectangle(width, height));
      document.addPage(page);
      PdfBoxGraphics2D graphics = new PdfBoxGraphics2D(document, width, height);
      drawing.accept(graphics);
      graphics.dispose();
      try (PDPageContentStream content = new PDPageContentStream(document, page)) {
        content.drawForm(graphics.getXFormObject());
      }
      document.save(out);
    }
  }
}
