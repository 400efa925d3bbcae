package dct.render;

import dct.core.Decimals;
import java.util.Locale;

/**
 * Writes a drawing for the drawing editor Ipe (version 7), a group for each run of shapes of one
 * colour. The page is as large as the drawing, in points; y runs upwards there.
 */
public final class IpePen implements Pen {
  private final StringBuilder out = new StringBuilder();
  private final int height;
  private final Theme theme;
  private Stroke stroke;

  /** A drawing of this size, in pixels; one is a point of the page. */
  public IpePen(int width, int height, Theme theme) {
    this.height = height;
    this.theme = theme;
    out.append("<?xml version=\"1.0\"?>\n");
    out.append("<ipe version=\"70206\" creator=\"Degree Constrained Triangulation\">\n");
    out.append(
        String.format(
            Locale.ROOT,
            "<ipestyle name=\"page\">\n<layout paper=\"%1$d %2$d\" origin=\"0 0\"",
            width,
            height));
    out.append(
        String.format(Locale.ROOT, " frame=\"%d %d\"/>\n</ipestyle>\n<page>\n", width, height));
    out.append("<layer name=\"alpha\"/>\n<view layers=\"alpha\" active=\"alpha\"/>\n");
  }

  /** The whole document; nothing can be drawn after. */
  public String finish() {
    closeGroup();
    return out.append("</page>\n</ipe>\n").toString();
  }

  @Override
  public void style(Stroke following) {
    closeGroup();
    stroke = following;
    out.append("<group>\n");
  }

  private void closeGroup() {
    if (stroke != null) {
      out.append("</group>\n");
      stroke = null;
    }
  }

  @Override
  public void line(double x1, double y1, double x2, double y2) {
    stroked();
    out.append(point(x1, y1)).append(" m ").append(point(x2, y2)).append(" l\n</path>\n");
  }

  @Override
  public void disc(double x, double y, double radius) {
    filled();
    circle(x, y, radius);
  }

  @Override
  public void ring(double x, double y, double radius) {
    stroked();
    circle(x, y, radius);
  }

  private void circle(double x, double y, double radius) {
    String r = Decimals.rounded(radius);
    out.append(r).append(" 0 0 ").append(r).append(' ').append(point(x, y)).append(" e\n</path>\n");
  }

  @Override
  public void rectangle(double x, double y, double width, double height) {
    filled();
    out.append(point(x, y)).append(" m ").append(point(x + width, y)).append(" l ");
    out.append(point(x + width, y + height)).append(" l ");
    out.append(point(x, y + height)).append(" l h\n</path>\n");
  }

  @Override
  public void polygon(double[] x, double[] y) {
    out.append("<path fill=\"").append(colour()).append("\" fillrule=\"eofill\">\n");
    for (int i = 0; i < x.length; i++) {
      out.append(point(x[i], y[i])).append(i == 0 ? " m\n" : " l\n");
    }
    out.append("h\n</path>\n");
  }

  @Override
  public void text(double x, double y, Anchor anchor, double size, String text) {
    String side =
        switch (anchor) {
          case START -> "left";
          case MIDDLE -> "center";
          case END -> "right";
        };
    out.append("<text type=\"label\" valign=\"baseline\" halign=\"").append(side);
    out.append("\" pos=\"").append(point(x, y)).append("\" size=\"").append(Decimals.rounded(size));
    out.append("\" stroke=\"").append(colour()).append("\">");
    out.append(TexText.of(text).replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;"));
    out.append("</text>\n");
  }

  private void stroked() {
    out.append("<path stroke=\"").append(colour()).append("\" pen=\"");
    out.append(Decimals.rounded(stroke.width()));
    out.append(stroke.dashed() ? "\" dash=\"[5 5] 0\">\n" : "\">\n");
  }

  private void filled() {
    out.append("<path fill=\"").append(colour()).append("\">\n");
  }

  private String point(double x, double y) {
    return Decimals.rounded(x) + " " + Decimals.rounded(height - y);
  }

  /** The three parts of the colour, from 0 to 1. */
  private String colour() {
    int rgb = stroke.ink().rgb(theme);
    return String.format(
        Locale.ROOT,
        "%.3f %.3f %.3f",
        (rgb >> 16 & 0xFF) / 255.0,
        (rgb >> 8 & 0xFF) / 255.0,
        (rgb & 0xFF) / 255.0);
  }
}
