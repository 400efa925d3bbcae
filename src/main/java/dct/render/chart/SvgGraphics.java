package dct.render.chart;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.PathIterator;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.StringJoiner;

/**
 * Writes what is drawn as an SVG 1.1 document: a path for each shape, and text as text, in the
 * viewer's letters without serifs, which take the width that was meant.
 */
final class SvgGraphics extends ShapeGraphics {
  private static final String COMMANDS = "mlqcz"; // by the numbers of PathIterator
  private static final int[] POINTS = {1, 1, 2, 3, 0}; // of each
  private static final double HUNDRED = 100;

  private final StringBuilder out = new StringBuilder();
  private Shape lastClip;
  private int clips;

  /** A drawing with a title and of this size, in pixels. */
  SvgGraphics(String title, int width, int height) {
    out.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    out.append("<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" role=\"img\"");
    out.append(" width=\"").append(width);
    out.append("\" height=\"").append(height).append("\" viewBox=\"0 0 ").append(width);
    out.append(' ').append(height).append("\" font-family=\"sans-serif\">\n<title>");
    out.append(escaped(title)).append("</title>\n");
  }

  /** The whole document; nothing can be drawn after. */
  String finish() {
    return out.append("</svg>\n").toString();
  }

  @Override
  void fill(Shape shape, Color paint, Shape within) {
    String path = path(shape);
    if (!path.isEmpty()) {
      clipTo(within);
      out.append("<path fill=\"").append(hex(paint)).append('"');
      opacity("fill", paint);
      end(shape, path, within);
    }
  }

  @Override
  void draw(Shape shape, Color paint, BasicStroke pen, Shape within) {
    clipTo(within);
    out.append("<path fill=\"none\" stroke=\"").append(hex(paint)).append('"');
    opacity("stroke", paint);
    out.append(" stroke-width=\"").append(number(pen.getLineWidth())).append('"');
    dashes(pen.getDashArray());
    end(shape, path(shape), within);
  }

  @Override
  void write(
      String text, Font letters, AffineTransform at, double width, Color paint, Shape within) {
    clipTo(within);
    double scale = Math.hypot(at.getScaleX(), at.getShearY());
    String x = number(at.getTranslateX());
    String y = number(at.getTranslateY());
    double degrees = Math.toDegrees(Math.atan2(at.getShearY(), at.getScaleX()));
    out.append("<text fill=\"").append(hex(paint)).append('"');
    opacity("fill", paint);
    out.append(" x=\"").append(x).append("\" y=\"").append(y);
    out.append("\" font-size=\"").append(number(scale * letters.getSize2D()));
    out.append(letters.isBold() ? "\" font-weight=\"bold" : "");
    if (!"0".equals(number(degrees))) {
      out.append("\" transform=\"rotate(").append(number(degrees));
      out.append(' ').append(x).append(' ').append(y).append(')');
    }
    out.append("\" textLength=\"").append(number(scale * width));
    out.append("\" lengthAdjust=\"spacingAndGlyphs\"");
    clipped(within);
    out.append('>').append(escaped(text)).append("</text>\n");
  }

  private static String escaped(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;");
  }

  /** Writes what is drawn and what is left out in turn; without gaps the line is not dashed. */
  private void dashes(float[] dashes) {
    if (dashes != null && dashes.length > 1 && dashes[1] > 0) {
      StringJoiner lengths = new StringJoiner(" ");
      for (float dash : dashes) {
        lengths.add(number(dash));
      }
      out.append(" stroke-dasharray=\"").append(lengths).append('"');
    }
  }

  private void opacity(String what, Color paint) {
    if (paint.getAlpha() < 255) {
      out.append(' ').append(what).append("-opacity=\"");
      out.append(number(paint.getAlpha() / 255.0)).append('"');
    }
  }

  private void end(Shape shape, String path, Shape within) {
    if (shape.getPathIterator(null).getWindingRule() == PathIterator.WIND_EVEN_ODD) {
      out.append(" fill-rule=\"evenodd\"");
    }
    clipped(within);
    out.append(" d=\"").append(path).append("\"/>\n");
  }

  private void clipped(Shape within) {
    if (within != null) {
      out.append(" clip-path=\"url(#c").append(clips).append(")\"");
    }
  }

  /** Makes the clip the last one that is defined. */
  private void clipTo(Shape within) {
    if (within != null && within != lastClip) {
      lastClip = within;
      clips++;
      out.append("<clipPath id=\"c").append(clips).append("\"><path d=\"");
      out.append(path(within)).append("\"/></clipPath>\n");
    }
  }

  /** The path, its coordinates from point to point in hundredths: half as long as otherwise. */
  private static String path(Shape shape) {
    StringBuilder path = new StringBuilder();
    double[] at = new double[6];
    long[] pen = new long[2];
    long[] start = pen.clone(); // of the part of the path that is open
    for (PathIterator i = shape.getPathIterator(null); !i.isDone(); i.next()) {
      int kind = i.currentSegment(at);
      path.append(COMMANDS.charAt(kind));
      for (int k = 0; k < 2 * POINTS[kind]; k++) {
        appendHundredths(path, Math.round(HUNDRED * at[k]) - pen[k & 1]);
      }
      if (kind == PathIterator.SEG_CLOSE) {
        pen = start.clone();
      } else {
        pen[0] = Math.round(HUNDRED * at[2 * POINTS[kind] - 2]);
        pen[1] = Math.round(HUNDRED * at[2 * POINTS[kind] - 1]);
      }
      start = kind == PathIterator.SEG_MOVETO ? pen.clone() : start;
    }
    return path.toString();
  }

  private static void appendHundredths(StringBuilder path, long hundredths) {
    boolean first = Character.isLetter(path.charAt(path.length() - 1));
    path.append(first || hundredths < 0 ? "" : " ").append(number(hundredths / HUNDRED));
  }

  private static String number(double value) {
    return BigDecimal.valueOf(value)
        .setScale(2, RoundingMode.HALF_EVEN)
        .stripTrailingZeros()
        .toPlainString();
  }

  private static String hex(Color paint) {
    return "#" + Integer.toHexString(0x1000000 | (paint.getRGB() & 0xFFFFFF)).substring(1);
  }
}
