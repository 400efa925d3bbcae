package dct.render;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.font.FontRenderContext;
import java.awt.font.GlyphVector;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;

/**
 * The letters of one size as masks of pixels, each drawn once and kept: labels by the hundred cost
 * nothing. Safe for use by several threads.
 */
final class Letters {
  private static final Map<Double, Letters> BY_SIZE = new ConcurrentHashMap<>();

  private final Font font;
  private final FontRenderContext context;
  private final BasicStroke rim;
  private final Map<Integer, Letter> letters = new ConcurrentHashMap<>();

  /** How much of each pixel a letter and its rim cover, out of 255. */
  static final class Letter {
    /** The pixels, when the letter begins at the origin, on the baseline. */
    final Rectangle box;

    /** What the rim covers of them, row by row. */
    final byte[] rim;

    /** What the letter covers of them. */
    final byte[] ink;

    /** Where the next letter begins. */
    final int advance;

    private Letter(Rectangle box, byte[] rim, byte[] ink, int advance) {
      this.box = box;
      this.rim = rim;
      this.ink = ink;
      this.advance = advance;
    }
  }

  private Letters(double size, double scale) {
    font = new Font(Font.SANS_SERIF, Font.PLAIN, 1).deriveFont((float) (size * scale));
    context = new FontRenderContext(null, true, false);
    float width = (float) (GraphicsPen.RIM * scale);
    rim = new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
  }

  /**
   * Letters of this size.
   *
   * @param scale pixels for each unit of the size
   */
  static Letters of(double size, double scale) {
    return BY_SIZE.computeIfAbsent(size * scale, key -> new Letters(size, scale));
  }

  /** A letter, by its code point. */
  Letter letter(int codePoint) {
    return letters.computeIfAbsent(codePoint, this::draw);
  }

  private Letter draw(int codePoint) {
    GlyphVector glyphs = font.createGlyphVector(context, Character.toString(codePoint));
    Shape outline = glyphs.getOutline();
    Shape around = rim.createStrokedShape(outline);
    Rectangle box = around.getBounds();
    box.add(glyphs.getPixelBounds(context, 0, 0));
    box.grow(1, 1);
    byte[] covered =
        mask(
            box,
            graphics -> {
              graphics.fill(around);
              graphics.fill(outline);
            });
    byte[] ink = mask(box, graphics -> graphics.drawGlyphVector(glyphs, 0, 0));
    return new Letter(box, covered, ink, Math.round(glyphs.getGlyphMetrics(0).getAdvance()));
  }

  private static byte[] mask(Rectangle box, Consumer<Graphics2D> drawing) {
    BufferedImage image = new BufferedImage(box.width, box.height, BufferedImage.TYPE_BYTE_GRAY);
    Graphics2D graphics = image.createGraphics();
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    graphics.transform(AffineTransform.getTranslateInstance(-box.x, -box.y));
    graphics.setColor(Color.WHITE);
    drawing.accept(graphics);
    graphics.dispose();
    byte[] covered = new byte[box.width * box.height];
    image.getRaster().getDataElements(0, 0, box.width, box.height, covered);
    return covered;
  }
}
