package dct.render;

import dct.core.Decimals;
import java.util.Locale;
import java.util.function.IntFunction;

/**
 * Writes a drawing for the drawing editor Ipe (version 7.2): a layer for each part of it, vertices
 * as marks, colours by the names of what they stand for in a style of its own. The page is as large
 * as the sheet; y runs upwards there.
 *
 * <p>Where the page shows the whole scene, the marks and the outline of a polygon have the
 * coordinates of the scene and a matrix that maps them to the page. The keywords of the document
 * name that matrix, so that the points are read from it as they were.
 */
final class IpePen implements Pen {
  private static final double MARK = 0.6; // half the side of a mark of size 1, as Ipe's own

  private static final String KEYWORD = "dct-points "; // and the matrix; IpeReader knows it, too

  private final StringBuilder out = new StringBuilder();
  private final double unit;
  private final double height;
  private final Scene scene;
  private final String matrix; // from the scene to the page; empty if it does not show the whole
  private final String[] marks; // by vertex; null where none is drawn
  private int vertex = -1; // that is drawn next, -1 for none
  private Part part = Part.POLYGON;
  private Stroke stroke = Stroke.fill(Ink.BACKGROUND);

  /** A drawing for a sheet. */
  IpePen(Sheet sheet, Title title) {
    unit = sheet.points();
    height = sheet.height();
    scene = sheet.scene();
    matrix = sheet.isWhole() ? matrix(sheet.view()) : "";
    marks = new String[scene.size()];
    out.append("<?xml version=\"1.0\"?>\n");
    out.append("<ipe version=\"70206\" creator=\"Degree Constrained Triangulation\">\n");
    out.append("<info title=\"").append(attribute(title.title()));
    out.append("\" subject=\"").append(attribute(title.description()));
    out.append(matrix.isEmpty() ? "" : "\" keywords=\"" + KEYWORD + matrix).append("\"/>\n");
    style(sheet);
    out.append("<page>\n");
    StringBuilder layers = new StringBuilder();
    for (Part each : Part.values()) {
      out.append("<layer name=\"").append(each.word()).append("\"/>\n");
      layers.append(layers.length() == 0 ? "" : " ").append(each.word());
    }
    out.append("<view layers=\"").append(layers).append("\" active=\"polygon\"/>\n");
    if (sheet.theme() == Theme.DARK) {
      rectangle(0, 0, sheet.width(), sheet.height());
    }
  }

  private String matrix(Viewport view) {
    double down = view.yUp() ? view.scale() : -view.scale();
    return Decimals.format(unit * view.scale())
        + " 0 0 "
        + Decimals.format(unit * down)
        + " "
        + Decimals.format(unit * view.screenX(0))
        + " "
        + Decimals.format(unit * (height - view.screenY(0)));
  }

  private void style(Sheet sheet) {
    String size = Decimals.rounded(sheet.pointsWide()) + " " + Decimals.rounded(sheet.pointsHigh());
    out.append("<ipestyle name=\"dct\">\n");
    mark("disk", MARK + " 0 0 " + MARK + " 0 0 e\n");
    String half = Double.toString(MARK);
    mark(
        "square",
        String.format(
            Locale.ROOT, "-%1$s -%1$s m\n%1$s -%1$s l\n%1$s %1$s l\n-%1$s %1$s l\nh\n", half));
    for (Ink ink : Ink.values()) {
      out.append("<color name=\"").append(name(ink)).append("\" value=\"");
      out.append(value(ink.rgb(sheet.theme()))).append("\"/>\n");
    }
    out.append("<layout paper=\"").append(size).append("\" origin=\"0 0\" frame=\"");
    out.append(size).append("\" crop=\"no\"/>\n</ipestyle>\n");
  }

  private void mark(String name, String path) {
    out.append("<symbol name=\"mark/").append(name);
    out.append("(sx)\" transformations=\"translations\">\n<path fill=\"sym-stroke\">\n");
    out.append(path).append("</path>\n</symbol>\n");
  }

  /** The whole document; nothing can be drawn after. */
  String finish() {
    flush();
    return out.append("</page>\n</ipe>\n").toString();
  }

  @Override
  public void part(Part following) {
    flush();
    part = following;
  }

  /** Writes the marks in the order of the vertices. */
  private void flush() {
    for (int v = 0; v < marks.length; v++) {
      if (marks[v] != null) {
        out.append(marks[v]);
        marks[v] = null;
      }
    }
  }

  @Override
  public void vertex(int following) {
    vertex = matrix.isEmpty() ? -1 : following;
  }

  @Override
  public void style(Stroke following) {
    stroke = following;
  }

  @Override
  public void line(double x1, double y1, double x2, double y2) {
    stroked();
    out.append(point(x1, y1)).append(" m\n").append(point(x2, y2)).append(" l\n</path>\n");
  }

  @Override
  public void disc(double x, double y, double radius) {
    use("disk", x, y, radius);
  }

  @Override
  public void square(double x, double y, double halfSide) {
    use("square", x, y, halfSide);
  }

  private void use(String mark, double x, double y, double radius) {
    boolean isOwn = vertex >= 0;
    String text =
        (isOwn ? place(vertex) : "\" pos=\"" + point(x, y))
            + "\" name=\"mark/"
            + mark
            + "(sx)\" size=\""
            + Decimals.rounded(unit * radius / MARK)
            + "\" stroke=\""
            + name(stroke.ink())
            + "\"/>\n";
    if (isOwn) {
      marks[vertex] = "<use" + unclosedLayer() + text;
    } else {
      out.append("<use").append(unclosedLayer()).append(text);
    }
    vertex = -1;
  }

  private String place(int v) {
    return "\" matrix=\"" + matrix + "\" pos=\"" + exact(v);
  }

  @Override
  public void ring(double x, double y, double radius) {
    String r = Decimals.rounded(unit * radius);
    stroked();
    out.append(r).append(" 0 0 ").append(r).append(' ').append(point(x, y)).append(" e\n</path>\n");
  }

  @Override
  public void rectangle(double x, double y, double width, double wide) {
    polygon(new double[] {x, x + width, x + width, x}, new double[] {y, y, y + wide, y + wide});
  }

  @Override
  public void polygon(double[] x, double[] y) {
    boolean isOwn = !matrix.isEmpty() && stroke.ink() == Ink.INSIDE;
    out.append("<path").append(layer()).append(" fill=\"").append(name(stroke.ink()));
    out.append(isOwn ? "\" matrix=\"" + matrix : "").append("\" fillrule=\"eofill\">\n");
    if (isOwn) {
      scene.rings().forEach(ring -> subpath(ring.length, k -> exact(ring[k])));
    } else {
      subpath(x.length, k -> point(x[k], y[k]));
    }
    out.append("</path>\n");
  }

  private void subpath(int corners, IntFunction<String> place) {
    for (int k = 0; k < corners; k++) {
      out.append(place.apply(k)).append(k == 0 ? " m\n" : " l\n");
    }
    out.append("h\n");
  }

  @Override
  public void text(double x, double y, Anchor anchor, double size, String text) {
    String side =
        switch (anchor) {
          case START -> "left";
          case MIDDLE -> "center";
          case END -> "right";
        };
    out.append("<text").append(layer()).append(" type=\"label\" valign=\"baseline\" halign=\"");
    out.append(side).append("\" pos=\"").append(point(x, y)).append("\" size=\"");
    out.append(Math.round(unit * size)).append("\" stroke=\"").append(name(stroke.ink()));
    out.append("\">").append(escaped(TexText.of(text))).append("</text>\n");
  }

  private void stroked() {
    out.append("<path").append(layer()).append(" stroke=\"").append(name(stroke.ink()));
    out.append("\" pen=\"").append(Decimals.rounded(unit * stroke.width()));
    String dash = Decimals.rounded(unit * 5);
    out.append(stroke.dashed() ? "\" dash=\"[" + dash + " " + dash + "] 0\">\n" : "\">\n");
  }

  private String layer() {
    return unclosedLayer() + "\"";
  }

  private String unclosedLayer() {
    return " layer=\"" + part.word();
  }

  private String exact(int v) {
    return Decimals.format(scene.x(v)) + " " + Decimals.format(scene.y(v));
  }

  private String point(double x, double y) {
    return Decimals.rounded(unit * x) + " " + Decimals.rounded(unit * (height - y));
  }

  private static String name(Ink ink) {
    return ink.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  private static String attribute(String text) {
    return escaped(text).replace("\"", "&quot;").replaceAll("\\R", " ");
  }

  private static String escaped(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
  }

  /** The three parts of a colour, from 0 to 1. */
  private static String value(int rgb) {
    return String.format(
        Locale.ROOT,
        "%.3f %.3f %.3f",
        (rgb >> 16 & 0xFF) / 255.0,
        (rgb >> 8 & 0xFF) / 255.0,
        (rgb & 0xFF) / 255.0);
  }
}
