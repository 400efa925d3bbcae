package dct.ui.icon;

import dct.render.Ink;
import dct.render.Theme;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;

/** Draws the lines and shapes of icons, smoothed, in the colours of pictures or all in one. */
final class Brush {
  private static final float LINE = 1.5f;

  private final Graphics2D graphics;
  private final Theme theme;
  private final Color only; // null if shapes have their own colours

  /**
   * A brush.
   *
   * @param only the one colour of everything, or null for those of pictures
   */
  Brush(Graphics2D graphics, Theme theme, Color only) {
    this.graphics = graphics;
    this.theme = theme;
    this.only = only;
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    width(LINE);
    ink(Ink.VERTEX);
  }

  /** The width of lines from now on. */
  Brush width(double width) {
    graphics.setStroke(
        new BasicStroke((float) width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    return this;
  }

  /** The colour of what follows. */
  Brush ink(Ink ink) {
    graphics.setColor(only == null ? new Color(ink.rgb(theme)) : only);
    return this;
  }

  /** A line through these points: x0, y0, x1, y1, …. */
  Brush line(double... points) {
    graphics.draw(path(points));
    return this;
  }

  /** The outline of the polygon with these corners. */
  Brush outline(double... points) {
    Path2D path = path(points);
    path.closePath();
    graphics.draw(path);
    return this;
  }

  /** The polygon with these corners. */
  Brush filled(double... points) {
    Path2D path = path(points);
    path.closePath();
    graphics.fill(path);
    return this;
  }

  private static Path2D path(double... points) {
    Path2D path = new Path2D.Double();
    path.moveTo(points[0], points[1]);
    for (int i = 2; i < points.length; i += 2) {
      path.lineTo(points[i], points[i + 1]);
    }
    return path;
  }

  /** A line that bends: from (x1, y1) to (x2, y2), drawn to two points between. */
  Brush curve(
      double x1, double y1, double ax, double ay, double bx, double by, double x2, double y2) {
    Path2D path = new Path2D.Double();
    path.moveTo(x1, y1);
    path.curveTo(ax, ay, bx, by, x2, y2);
    graphics.draw(path);
    return this;
  }

  /** A circle. */
  Brush ring(double x, double y, double radius) {
    graphics.draw(new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius));
    return this;
  }

  /** An even vertex. */
  Brush even(double x, double y, double radius) {
    ink(Ink.EVEN);
    graphics.fill(new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius));
    return ink(Ink.VERTEX);
  }

  /** An odd vertex. */
  Brush odd(double x, double y, double radius) {
    double half = 0.9 * radius;
    ink(Ink.ODD);
    graphics.fill(new Rectangle2D.Double(x - half, y - half, 2 * half, 2 * half));
    return ink(Ink.VERTEX);
  }
}
