package dct.ui.canvas;

import dct.render.Theme;
import dct.render.Viewport;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.util.function.DoubleUnaryOperator;

/**
 * A soft grid over the picture. Where its lines would crowd, only each fifth or tenth is drawn, and
 * so on.
 */
final class GridLines {
  private static final double LEAST_GAP = 9; // pixels between lines
  private static final int SOFT = 22; // of 255
  private static final int FIFTH = 5;

  private final Graphics2D graphics;
  private final double size; // between the lines drawn, in the model
  private final Color line;
  private final Color fifthLine;

  private GridLines(Graphics2D graphics, double size, Theme theme) {
    this.graphics = graphics;
    this.size = size;
    int shade = theme == Theme.LIGHT ? 0 : 255;
    line = new Color(shade, shade, shade, SOFT);
    fifthLine = new Color(shade, shade, shade, 2 * SOFT);
  }

  /** Draws the lines at the multiples of the size. */
  static void paint(Graphics2D graphics, double size, Viewport view, Dimension on, Theme theme) {
    double drawn = size;
    for (int factor = FIFTH; drawn * view.scale() < LEAST_GAP; factor = FIFTH + 2 - factor) {
      drawn *= factor;
      if (!Double.isFinite(drawn)) {
        return;
      }
    }
    GridLines lines = new GridLines(graphics, drawn, theme);
    lines.across(
        view.modelX(0),
        view.modelX(on.width),
        view::screenX,
        x -> new Line2D.Double(x, 0, x, on.height));
    lines.across(
        view.modelY(0),
        view.modelY(on.height),
        view::screenY,
        y -> new Line2D.Double(0, y, on.width, y));
  }

  private interface Line {
    Line2D at(double screen);
  }

  private void across(double from, double to, DoubleUnaryOperator screen, Line across) {
    double last = Math.floor(Math.max(from, to) / size);
    double first = Math.ceil(Math.min(from, to) / size);
    if (Math.abs(first) > 1L << 52 || Math.abs(last) > 1L << 52) {
      return; // numbers are too coarse here for a grid so fine
    }
    for (double k = first; k <= last; k++) {
      graphics.setColor(k % FIFTH == 0 ? fifthLine : line);
      double place = Math.rint(screen.applyAsDouble(k * size));
      graphics.draw(across.at(place));
    }
  }
}
