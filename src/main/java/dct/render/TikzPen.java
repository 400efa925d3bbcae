package dct.render;

import dct.core.Decimals;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;

/**
 * Writes a drawing as a TikZ picture, as large as the sheet. The colours are named after what they
 * stand for, as {@code dct-even}; a paper that has defined one keeps its own.
 *
 * <p>Shapes of one look share a path of at most some dozens, each on a line of its own: so TeX
 * reads no long line, keeps no long path, and needs a fraction of the time.
 */
final class TikzPen implements Pen {
  private static final int SHARE = 50; // shapes of one path

  private final StringBuilder body = new StringBuilder();
  private final Set<Ink> used = new TreeSet<>();
  private final Sheet sheet;
  private final Title title;
  private Part part = Part.POLYGON;
  private Stroke stroke;
  private String open = ""; // how the path that is being written began; empty for none
  private int shapes; // in it

  /** A drawing for a sheet. */
  TikzPen(Sheet sheet, Title title) {
    this.sheet = sheet;
    this.title = title;
    style(Stroke.fill(Ink.BACKGROUND));
    if (sheet.theme() == Theme.DARK) {
      rectangle(0, 0, sheet.width(), sheet.height());
    }
  }

  /** The picture, to be read into a document that uses TikZ; nothing can be drawn after. */
  String fragment() {
    end();
    StringBuilder out = new StringBuilder();
    out.append("% ").append(line(title.title())).append('\n');
    out.append("% ").append(line(title.description())).append('\n');
    out.append("% \\usepackage{tikz}, then \\input this file.\n");
    out.append(
        String.format(
            Locale.ROOT,
            "\\begin{tikzpicture}[x=%1$sbp, y=-%1$sbp]\n",
            Decimals.rounded(sheet.points())));
    for (Ink ink : used) {
      String hex = Integer.toHexString(0x1000000 | ink.rgb(sheet.theme())).substring(1);
      out.append("\\providecolor{").append(name(ink)).append("}{HTML}{");
      out.append(hex.toUpperCase(Locale.ROOT)).append("}\n");
    }
    out.append("\\useasboundingbox (0,0) rectangle ");
    out.append(point(sheet.width(), sheet.height())).append(";\n");
    return out.append(body).append("\\end{tikzpicture}\n").toString();
  }

  /** The same as a document of its own. */
  String document() {
    return "\\documentclass[tikz]{standalone}\n\\begin{document}\n"
        + fragment()
        + "\\end{document}\n";
  }

  private static String line(String text) {
    return text.replaceAll("\\R", " ");
  }

  @Override
  public void part(Part following) {
    part = following;
  }

  @Override
  public void style(Stroke following) {
    end();
    stroke = following;
  }

  /** Goes on with the path that began so, or begins one. */
  private void path(String start) {
    if (!open.equals(start) || shapes == SHARE) {
      end();
      body.append(start);
      open = start;
      used.add(stroke.ink());
    }
    shapes++;
    body.append('\n');
  }

  private void end() {
    if (!open.isEmpty()) {
      body.append(";\n");
    }
    open = "";
    shapes = 0;
  }

  @Override
  public void line(double x1, double y1, double x2, double y2) {
    path(draw());
    body.append(point(x1, y1)).append(" -- ").append(point(x2, y2));
  }

  @Override
  public void disc(double x, double y, double radius) {
    path(fill());
    circle(x, y, radius);
  }

  @Override
  public void ring(double x, double y, double radius) {
    path(draw());
    circle(x, y, radius);
  }

  private void circle(double x, double y, double radius) {
    body.append(point(x, y)).append(" circle[radius=").append(points(radius)).append(']');
  }

  @Override
  public void rectangle(double x, double y, double width, double height) {
    path(fill());
    body.append(point(x, y)).append(" rectangle ").append(point(x + width, y + height));
  }

  @Override
  public void polygon(double[] x, double[] y) {
    end();
    path("\\fill[" + name(stroke.ink()) + ", even odd rule]");
    for (int i = 0; i < x.length; i++) {
      body.append(point(x[i], y[i])).append("\n -- ");
    }
    body.append("cycle");
    end();
  }

  @Override
  public void text(double x, double y, Anchor anchor, double size, String text) {
    end();
    String side =
        switch (anchor) {
          case START -> "base west";
          case MIDDLE -> "base";
          case END -> "base east";
        };
    // TeX's fonts come in whole points.
    long letters = Math.round(size * sheet.points());
    used.add(stroke.ink());
    body.append("\\node[anchor=").append(side).append(", inner sep=");
    body.append(part == Part.LABELS ? "0.4bp, fill=" + name(Ink.BACKGROUND) : "0");
    if (part == Part.LABELS) {
      used.add(Ink.BACKGROUND);
    }
    body.append(", text=").append(name(stroke.ink())).append(",\n  font=\\fontsize{");
    body.append(letters).append("}{").append(letters).append("}\\selectfont] at ");
    body.append(point(x, y)).append(" {").append(TexText.of(text)).append("};\n");
  }

  private String draw() {
    return "\\draw["
        + name(stroke.ink())
        + ", line width="
        + points(stroke.width())
        + (stroke.dashed() ? dashes() : "]");
  }

  private String dashes() {
    return ", dash pattern=on " + points(5) + " off " + points(5) + "]";
  }

  private String fill() {
    return "\\fill[" + name(stroke.ink()) + "]";
  }

  private static String point(double x, double y) {
    return "(" + Decimals.rounded(x) + "," + Decimals.rounded(y) + ")";
  }

  private String points(double units) {
    return Decimals.rounded(sheet.points() * units) + "bp";
  }

  private static String name(Ink ink) {
    return "dct-" + ink.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
