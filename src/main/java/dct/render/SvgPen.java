package dct.render;

import dct.core.Decimals;
import java.util.List;
import java.util.Locale;

/**
 * Writes a drawing as an SVG 1.1 document: valid XML, numbers with a point whatever the locale, one
 * element a shape, grouped by what the colour stands for; a style sheet says which colour that is.
 */
public final class SvgPen implements Pen {
  private static final double MM = 25.4 / 72; // for each point

  private final StringBuilder out = new StringBuilder();
  private final Theme theme;
  private final List<int[]> rings; // of a region that is there as a whole
  private final Sheet sheet;
  private Part part = Part.POLYGON;
  private boolean inGroup;
  private boolean isInside; // whether the inside of a polygon or region is drawn

  /** A drawing for a sheet, on a ground of its theme's colour. */
  SvgPen(Sheet sheet, Title title) {
    this.theme = sheet.theme();
    this.sheet = sheet;
    rings = sheet.isWhole() ? sheet.scene().rings() : List.of();
    double unit = sheet.isPaper() ? sheet.points() * MM : 1;
    String length = sheet.isPaper() ? "mm" : "px";
    out.append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    out.append("<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" role=\"img\"");
    out.append(" width=\"").append(Decimals.rounded(sheet.width() * unit)).append(length);
    out.append("\" height=\"").append(Decimals.rounded(sheet.height() * unit)).append(length);
    out.append("\" viewBox=\"0 0 ").append(Decimals.rounded(sheet.width())).append(' ');
    out.append(Decimals.rounded(sheet.height())).append("\">\n<title>");
    escaped(title.title());
    out.append("</title>\n<desc>");
    escaped(title.description());
    out.append("</desc>\n<style>\n");
    for (Ink ink : Ink.values()) {
      String hex = hex(ink);
      out.append('.').append(word(ink)).append(" { fill: ").append(hex);
      out.append("; stroke: ").append(hex).append(" }\n");
    }
    out.append("text { font-family: sans-serif; stroke: ").append(hex(Ink.BACKGROUND));
    out.append("; stroke-width: 3.5; stroke-linejoin: round; paint-order: stroke }\n</style>\n");
    out.append("<rect class=\"background\" width=\"");
    number(sheet.width());
    attribute("height", sheet.height());
    out.append(" stroke=\"none\"/>\n");
  }

  /** The whole document; nothing can be drawn after. */
  public String finish() {
    closeGroup();
    return out.append("</svg>\n").toString();
  }

  @Override
  public void part(Part following) {
    part = following;
  }

  @Override
  public void style(Stroke stroke) {
    closeGroup();
    inGroup = true;
    isInside = stroke.ink() == Ink.INSIDE;
    out.append("<g class=\"").append(word(stroke.ink())).append('"');
    out.append(part == Part.COUNTS ? " data-part=\"counts\"" : "");
    attribute("stroke-width", stroke.width());
    out.append(stroke.dashed() ? " stroke-dasharray=\"5 5\">\n" : ">\n");
  }

  private void closeGroup() {
    if (inGroup) {
      out.append("</g>\n");
      inGroup = false;
    }
  }

  @Override
  public void line(double x1, double y1, double x2, double y2) {
    out.append("<line x1=\"");
    number(x1);
    attribute("y1", y1);
    attribute("x2", x2);
    attribute("y2", y2);
    out.append("/>\n");
  }

  @Override
  public void disc(double x, double y, double radius) {
    circle(x, y, radius);
    out.append(" stroke=\"none\"/>\n");
  }

  @Override
  public void ring(double x, double y, double radius) {
    circle(x, y, radius);
    out.append(" fill=\"none\"/>\n");
  }

  private void circle(double x, double y, double radius) {
    out.append("<circle cx=\"");
    number(x);
    attribute("cy", y);
    attribute("r", radius);
  }

  @Override
  public void rectangle(double x, double y, double width, double height) {
    out.append("<rect x=\"");
    number(x);
    attribute("y", y);
    attribute("width", width);
    attribute("height", height);
    out.append(" stroke=\"none\"/>\n");
  }

  @Override
  public void polygon(double[] x, double[] y) {
    if (isInside && rings.size() > 1) {
      path();
      return;
    }
    out.append("<polygon points=\"");
    for (int i = 0; i < x.length; i++) {
      out.append(i == 0 ? "" : " ");
      number(x[i]);
      out.append(',');
      number(y[i]);
    }
    out.append("\" fill-rule=\"evenodd\" stroke=\"none\"/>\n");
  }

  /** The rings of a region; as a walk along all of them they would not be read back. */
  private void path() {
    out.append("<path d=\"");
    for (int[] ring : rings) {
      out.append(ring == rings.get(0) ? "M" : " M");
      for (int k = 0; k < ring.length; k++) {
        out.append(k == 0 ? "" : " ");
        number(sheet.view().screenX(sheet.scene().x(ring[k])));
        out.append(',');
        number(sheet.view().screenY(sheet.scene().y(ring[k])));
      }
      out.append('Z');
    }
    out.append("\" fill-rule=\"evenodd\" stroke=\"none\"/>\n");
  }

  @Override
  public void text(double x, double y, Anchor anchor, double size, String text) {
    out.append("<text x=\"");
    number(x);
    attribute("y", y);
    attribute("font-size", size);
    out.append(" text-anchor=\"").append(anchor.name().toLowerCase(Locale.ROOT)).append("\">");
    escaped(text);
    out.append("</text>\n");
  }

  /** Closes the attribute before and writes this one, its quotes included. */
  private void attribute(String name, double value) {
    if (out.charAt(out.length() - 1) != '"') {
      out.append('"');
    }
    out.append(' ').append(name).append("=\"");
    number(value);
    out.append('"');
  }

  private void number(double value) {
    out.append(Decimals.rounded(value));
  }

  private void escaped(String text) {
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      switch (c) {
        case '&' -> out.append("&amp;");
        case '<' -> out.append("&lt;");
        case '>' -> out.append("&gt;");
        default -> out.append(c);
      }
    }
  }

  private static String word(Ink ink) {
    return ink.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  private String hex(Ink ink) {
    return "#" + Integer.toHexString(0x1000000 | ink.rgb(theme)).substring(1);
  }
}
