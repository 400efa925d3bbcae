package dct.render;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.font.TextLayout;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.EnumMap;
import java.util.Map;

/** Draws on any {@link Graphics2D}: the screen or an image. */
public final class GraphicsPen implements Pen {
  /** The width of the line round letters; half of it lies outside. */
  static final float RIM = 3.5f;

  private final Graphics2D graphics;
  private final Map<Ink, Color> colours = new EnumMap<>(Ink.class);
  private final Line2D.Double line = new Line2D.Double();
  private final Ellipse2D.Double ellipse = new Ellipse2D.Double();
  private final Rectangle2D.Double rectangle = new Rectangle2D.Double();

  /** A pen for these graphics, whose state it changes. */
  public GraphicsPen(Graphics2D graphics, Theme theme) {
    this.graphics = graphics;
    for (Ink ink : Ink.values()) {
      colours.put(ink, new Color(ink.rgb(theme)));
    }
    graphics.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    // Whole coordinates are the centres of pixels: level and upright lines come out sharp.
    graphics.translate(0.5, 0.5);
  }

  /** Fills a screen of this size with the colour of the ground. */
  public void ground(int width, int height) {
    graphics.setColor(colours.get(Ink.BACKGROUND));
    graphics.fillRect(-1, -1, width + 2, height + 2);
  }

  @Override
  public void style(Stroke stroke) {
    graphics.setColor(colours.get(stroke.ink()));
    float[] dash = stroke.dashed() ? new float[] {5, 5} : null;
    float width = (float) stroke.width();
    graphics.setStroke(
        new BasicStroke(width, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, dash, 0));
  }

  @Override
  public void line(double x1, double y1, double x2, double y2) {
    line.setLine(x1, y1, x2, y2);
    graphics.draw(line);
  }

  @Override
  public void disc(double x, double y, double radius) {
    ellipse.setFrame(x - radius, y - radius, 2 * radius, 2 * radius);
    graphics.fill(ellipse);
  }

  @Override
  public void rectangle(double x, double y, double width, double height) {
    rectangle.setFrame(x, y, width, height);
    graphics.fill(rectangle);
  }

  @Override
  public void polygon(double[] x, double[] y) {
    Path2D.Double path = new Path2D.Double(Path2D.WIND_EVEN_ODD, x.length + 1);
    path.moveTo(x[0], y[0]);
    for (int i = 1; i < x.length; i++) {
      path.lineTo(x[i], y[i]);
    }
    path.closePath();
    graphics.fill(path);
  }

  @Override
  public void ring(double x, double y, double radius) {
    ellipse.setFrame(x - radius, y - radius, 2 * radius, 2 * radius);
    graphics.draw(ellipse);
  }

  @Override
  public void text(double x, double y, Anchor anchor, double size, String text) {
    Font font = new Font(Font.SANS_SERIF, Font.PLAIN, 1).deriveFont((float) size);
    TextLayout layout = new TextLayout(text, font, graphics.getFontRenderContext());
    double width = layout.getAdvance();
    double left =
        switch (anchor) {
          case START -> x;
          case MIDDLE -> x - width / 2;
          case END -> x - width;
        };
    Shape outline = layout.getOutline(AffineTransform.getTranslateInstance(left, y));
    Color colour = graphics.getColor();
    java.awt.Stroke stroke = graphics.getStroke();
    graphics.setColor(colours.get(Ink.BACKGROUND));
    graphics.setStroke(new BasicStroke(RIM, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    graphics.draw(outline);
    graphics.setColor(colour);
    graphics.setStroke(stroke);
    layout.draw(graphics, (float) left, (float) y);
  }
}
