package dct.render.chart;

import dct.render.OutlinedText;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Composite;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.GraphicsConfiguration;
import java.awt.Image;
import java.awt.Paint;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.Stroke;
import java.awt.font.FontRenderContext;
import java.awt.font.GlyphVector;
import java.awt.geom.AffineTransform;
import java.awt.geom.Arc2D;
import java.awt.geom.Area;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import java.awt.image.BufferedImageOp;
import java.awt.image.ImageObserver;
import java.awt.image.RenderedImage;
import java.awt.image.renderable.RenderableImage;
import java.text.AttributedCharacterIterator;
import java.util.Map;
import java.util.Optional;

/**
 * Graphics that keep the state of a drawing and reduce all of it to lines drawn, shapes filled and
 * text, which is found where its letters are filled. What charts do not draw, images above all, is
 * refused.
 *
 * <p>Longer than other classes because {@link Graphics2D} has so many methods; each is a line.
 */
abstract class ShapeGraphics extends Graphics2D {
  private AffineTransform transform = new AffineTransform();
  private Color colour = Color.BLACK;
  private Color background = Color.WHITE;
  private Stroke stroke = new BasicStroke();
  private Font font = new Font(Font.SANS_SERIF, Font.PLAIN, 12);
  private Shape clip; // in device space; null for none
  private final RenderingHints hints = new RenderingHints(Map.of());

  /** Fills a shape given in device space, within this clip if there is one. */
  abstract void fill(Shape shape, Color paint, Shape within);

  /** Draws the outline of a shape given in device space. */
  abstract void draw(Shape shape, Color paint, BasicStroke pen, Shape within);

  /**
   * Writes text.
   *
   * @param at from the start of its baseline to device space: moved, turned and enlarged
   * @param width how far it advances, before it is enlarged
   */
  abstract void write(
      String text, Font letters, AffineTransform at, double width, Color paint, Shape within);

  @Override
  public final void fill(Shape shape) {
    Optional<OutlinedText> found =
        shape instanceof Path2D ? OutlinedText.of(shape, font) : Optional.empty();
    if (found.isPresent()) {
      write(found.get());
    } else {
      fill(transform.createTransformedShape(shape), colour, clip);
    }
  }

  private void write(OutlinedText found) {
    AffineTransform at = getTransform();
    at.concatenate(found.at());
    write(found.text(), font, at, found.width(), colour, clip);
  }

  @Override
  public final void draw(Shape shape) {
    if (stroke instanceof BasicStroke pen) {
      draw(transform.createTransformedShape(shape), colour, pen, clip);
    } else {
      fill(stroke.createStrokedShape(shape));
    }
  }

  @Override
  public final void drawString(String text, float x, float y) {
    AffineTransform at = AffineTransform.getTranslateInstance(x, y);
    write(new OutlinedText(text, at, OutlinedText.advance(font, text)));
  }

  @Override
  public final void drawString(String text, int x, int y) {
    drawString(text, (float) x, (float) y);
  }

  @Override
  public final void drawGlyphVector(GlyphVector glyphs, float x, float y) {
    fill(glyphs.getOutline(x, y));
  }

  @Override
  public final void drawLine(int x1, int y1, int x2, int y2) {
    draw(new Line2D.Double(x1, y1, x2, y2));
  }

  @Override
  public final void fillRect(int x, int y, int width, int height) {
    fill(new Rectangle(x, y, width, height));
  }

  @Override
  public final void clearRect(int x, int y, int width, int height) {
    fill(transform.createTransformedShape(new Rectangle(x, y, width, height)), background, clip);
  }

  @Override
  public final void drawRoundRect(int x, int y, int width, int height, int arcX, int arcY) {
    draw(new RoundRectangle2D.Double(x, y, width, height, arcX, arcY));
  }

  @Override
  public final void fillRoundRect(int x, int y, int width, int height, int arcX, int arcY) {
    fill(new RoundRectangle2D.Double(x, y, width, height, arcX, arcY));
  }

  @Override
  public final void drawOval(int x, int y, int width, int height) {
    draw(new Ellipse2D.Double(x, y, width, height));
  }

  @Override
  public final void fillOval(int x, int y, int width, int height) {
    fill(new Ellipse2D.Double(x, y, width, height));
  }

  @Override
  public final void drawArc(int x, int y, int width, int height, int start, int extent) {
    draw(new Arc2D.Double(x, y, width, height, start, extent, Arc2D.OPEN));
  }

  @Override
  public final void fillArc(int x, int y, int width, int height, int start, int extent) {
    fill(new Arc2D.Double(x, y, width, height, start, extent, Arc2D.PIE));
  }

  @Override
  public final void drawPolyline(int[] xs, int[] ys, int n) {
    draw(path(xs, ys, n, false));
  }

  @Override
  public final void drawPolygon(int[] xs, int[] ys, int n) {
    draw(path(xs, ys, n, true));
  }

  @Override
  public final void fillPolygon(int[] xs, int[] ys, int n) {
    fill(path(xs, ys, n, true));
  }

  private static Path2D path(int[] xs, int[] ys, int n, boolean closed) {
    Path2D path = new Path2D.Double();
    for (int i = 0; i < n; i++) {
      if (i == 0) {
        path.moveTo(xs[i], ys[i]);
      } else {
        path.lineTo(xs[i], ys[i]);
      }
    }
    if (closed && n > 0) {
      path.closePath();
    }
    return path;
  }

  @Override
  public final void translate(int x, int y) {
    transform.translate(x, y);
  }

  @Override
  public final void translate(double x, double y) {
    transform.translate(x, y);
  }

  @Override
  public final void rotate(double angle) {
    transform.rotate(angle);
  }

  @Override
  public final void rotate(double angle, double x, double y) {
    transform.rotate(angle, x, y);
  }

  @Override
  public final void scale(double x, double y) {
    transform.scale(x, y);
  }

  @Override
  public final void shear(double x, double y) {
    transform.shear(x, y);
  }

  @Override
  public final void transform(AffineTransform further) {
    transform.concatenate(further);
  }

  @Override
  public final void setTransform(AffineTransform given) {
    transform = new AffineTransform(given);
  }

  @Override
  public final AffineTransform getTransform() {
    return new AffineTransform(transform);
  }

  @Override
  public final void clip(Shape shape) {
    if (clip == null) {
      setClip(shape);
    } else if (shape != null) {
      Area both = new Area(clip);
      both.intersect(new Area(transform.createTransformedShape(shape)));
      clip = both;
    }
  }

  @Override
  public final void clipRect(int x, int y, int width, int height) {
    clip(new Rectangle(x, y, width, height));
  }

  @Override
  public final void setClip(Shape shape) {
    clip = shape == null ? null : transform.createTransformedShape(shape);
  }

  @Override
  public final void setClip(int x, int y, int width, int height) {
    setClip(new Rectangle(x, y, width, height));
  }

  @Override
  public final Shape getClip() {
    try {
      return clip == null ? null : transform.createInverse().createTransformedShape(clip);
    } catch (java.awt.geom.NoninvertibleTransformException e) {
      throw new IllegalStateException(e);
    }
  }

  @Override
  public final Rectangle getClipBounds() {
    Shape shape = getClip();
    return shape == null ? null : shape.getBounds();
  }

  @Override
  public final void setPaint(Paint paint) {
    if (!(paint instanceof Color given)) {
      throw refused("a paint that is no colour");
    }
    colour = given;
  }

  @Override
  public final Paint getPaint() {
    return colour;
  }

  @Override
  public final void setColor(Color given) {
    colour = given;
  }

  @Override
  public final Color getColor() {
    return colour;
  }

  @Override
  public final void setBackground(Color given) {
    background = given;
  }

  @Override
  public final Color getBackground() {
    return background;
  }

  @Override
  public final void setStroke(Stroke given) {
    stroke = given;
  }

  @Override
  public final Stroke getStroke() {
    return stroke;
  }

  @Override
  public final void setFont(Font given) {
    font = given;
  }

  @Override
  public final Font getFont() {
    return font;
  }

  @Override
  public final FontMetrics getFontMetrics(Font of) {
    return new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics().getFontMetrics(of);
  }

  @Override
  public final FontRenderContext getFontRenderContext() {
    return OutlinedText.MEASURE;
  }

  @Override
  public final void setRenderingHint(RenderingHints.Key key, Object value) {
    hints.put(key, value);
  }

  @Override
  public final Object getRenderingHint(RenderingHints.Key key) {
    return hints.get(key);
  }

  @Override
  public final void setRenderingHints(Map<?, ?> given) {
    hints.clear();
    hints.putAll(given);
  }

  @Override
  public final void addRenderingHints(Map<?, ?> given) {
    hints.putAll(given);
  }

  @Override
  public final RenderingHints getRenderingHints() {
    return (RenderingHints) hints.clone();
  }

  @Override
  public final boolean hit(Rectangle area, Shape shape, boolean onStroke) {
    return transform
        .createTransformedShape(onStroke ? stroke.createStrokedShape(shape) : shape)
        .intersects(area);
  }

  @Override
  public final void dispose() {}

  @Override
  public final GraphicsConfiguration getDeviceConfiguration() {
    throw refused("a device");
  }

  @Override
  public final java.awt.Graphics create() {
    throw refused("a copy");
  }

  @Override
  public final void setComposite(Composite composite) {
    throw refused("mixing of colours");
  }

  @Override
  public final Composite getComposite() {
    return java.awt.AlphaComposite.SrcOver;
  }

  @Override
  public final void setPaintMode() {
    // there is no other
  }

  @Override
  public final void setXORMode(Color other) {
    throw refused("mixing of colours");
  }

  @Override
  public final void copyArea(int x, int y, int width, int height, int dx, int dy) {
    throw refused("copying");
  }

  @Override
  public final void drawString(AttributedCharacterIterator text, int x, int y) {
    throw refused("text of several styles");
  }

  @Override
  public final void drawString(AttributedCharacterIterator text, float x, float y) {
    throw refused("text of several styles");
  }

  @Override
  public final boolean drawImage(Image image, AffineTransform at, ImageObserver observer) {
    throw refused("an image");
  }

  @Override
  public final void drawImage(BufferedImage image, BufferedImageOp op, int x, int y) {
    throw refused("an image");
  }

  @Override
  public final void drawRenderedImage(RenderedImage image, AffineTransform at) {
    throw refused("an image");
  }

  @Override
  public final void drawRenderableImage(RenderableImage image, AffineTransform at) {
    throw refused("an image");
  }

  @Override
  public final boolean drawImage(Image image, int x, int y, ImageObserver observer) {
    throw refused("an image");
  }

  @Override
  public final boolean drawImage(
      Image image, int x, int y, int width, int height, ImageObserver observer) {
    throw refused("an image");
  }

  @Override
  public final boolean drawImage(Image image, int x, int y, Color ground, ImageObserver observer) {
    throw refused("an image");
  }

  @Override
  public final boolean drawImage(
      Image image, int x, int y, int width, int height, Color ground, ImageObserver observer) {
    throw refused("an image");
  }

  @Override
  public final boolean drawImage(
      Image image,
      int dx1,
      int dy1,
      int dx2,
      int dy2,
      int sx1,
      int sy1,
      int sx2,
      int sy2,
      ImageObserver observer) {
    throw refused("an image");
  }

  @Override
  public final boolean drawImage(
      Image image,
      int dx1,
      int dy1,
      int dx2,
      int dy2,
      int sx1,
      int sy1,
      int sx2,
      int sy2,
      Color ground,
      ImageObserver observer) {
    throw refused("an image");
  }

  private static UnsupportedOperationException refused(String what) {
    return new UnsupportedOperationException(what + " in a drawing of shapes");
  }
}
