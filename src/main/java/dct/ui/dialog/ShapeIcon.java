package dct.ui.dialog;

import dct.core.geometry.Box;
import dct.core.geometry.Points;
import dct.io.format.Shape;
import dct.render.Viewport;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import javax.swing.Icon;

/** A small picture of a shape: its outline, or its sites. Of many points only some are drawn. */
final class ShapeIcon implements Icon {
  static final int HEIGHT = 44;
  private static final int WIDTH = 64;
  private static final int MOST = 400;
  private static final double DOT = 3;

  private final Shape shape;

  ShapeIcon(Shape shape) {
    this.shape = shape;
  }

  @Override
  public int getIconWidth() {
    return WIDTH;
  }

  @Override
  public int getIconHeight() {
    return HEIGHT;
  }

  @Override
  public void paintIcon(Component c, Graphics g, int x, int y) {
    Points points = shape.points();
    if (points.size() == 0) {
      return;
    }
    Graphics2D graphics = (Graphics2D) g.create(x, y, WIDTH, HEIGHT);
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.setColor(c.getForeground());
    Viewport view = Viewport.fit(Box.of(points), WIDTH, HEIGHT, DOT, true);
    int step = Math.max(1, points.size() / MOST);
    if (shape.kind() == Shape.Kind.SITES) {
      dots(graphics, view, step);
    } else {
      graphics.draw(outline(view, step));
    }
    graphics.dispose();
  }

  private void dots(Graphics2D graphics, Viewport view, int step) {
    for (int v = 0; v < shape.points().size(); v += step) {
      double px = view.screenX(shape.points().x(v));
      double py = view.screenY(shape.points().y(v));
      graphics.fill(new Ellipse2D.Double(px - DOT / 2, py - DOT / 2, DOT, DOT));
    }
  }

  private Path2D outline(Viewport view, int step) {
    Path2D path = new Path2D.Double();
    for (int v = 0; v < shape.points().size(); v += step) {
      double px = view.screenX(shape.points().x(v));
      double py = view.screenY(shape.points().y(v));
      if (v == 0) {
        path.moveTo(px, py);
      } else {
        path.lineTo(px, py);
      }
    }
    path.closePath();
    return path;
  }
}
