package dct.render;

import dct.core.Decimals;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;

/**
 * Writes a drawing as a LaTeX document with one TikZ picture, half a point for each pixel. The
 * colours are named after what they stand for, so that a paper can choose its own.
 */
public final class TikzPen implements Pen {
  private static final double POINTS = 0.5; // of the page, for each pixel

  private final StringBuilder body = new StringBuilder();
  private final Set<Ink> used = new TreeSet<>();
  private final int width;
  private final int height;
  private final Theme theme;
  private Stroke stroke;

  /** A drawing of this size, in pixels. */
  public TikzPen(int width, int height, Theme theme) {
    this.width = width;
    this.height = height;
    this.theme = theme;
  }

  /** The whole document; nothing can be drawn after. */
  public String finish() {
    StringBuilder out = new StringBuilder();
    out.append("\\documentclass[tikz]{standalone}\n");
    for (Ink ink : used) {
      String hex = Integer.toHexString(0x1000000 | ink.rgb(theme)).substring(1);
      out.append("\\definecolor{").append(name(ink)).append("}{HTML}{");
      out.append(hex.toUpperCase(Locale.ROOT)).append("}\n");
    }
    out.append("\\begin{document}\n");
    out.append(
        String.format(
            Locale.ROOT, "\\begin{tikzpicture}[x=%1$sbp, y=-%1$sbp]\n", Decimals.rounded(POINTS)));
    out.append(
        String.format(Locale.ROOT, "\\useasboundingbox (0,0) rectangle (%d,%d);\n", width, height));
    out.append(body).append("\\end{tikzpicture}\n\\end{document}\n");
    return out.toString();
  }

  @Override
  public void style(Stroke following) {
    stroke = following;
    used.add(following.ink());
  }

  @Override
  public void line(double x1, double y1, double x2, double y2) {
    draw();
    body.append(point(x1, y1)).append(" -- ").append(point(x2, y2)).append(";\n");
  }

  @Override
  public void disc(double x, double y, double radius) {
    fill();
    circle(x, y, radius);
  }

  @Override
  public void ring(double x, double y, double radius) {
    draw();
    circle(x, y, radius);
  }

  private void circle(double x, double y, double radius) {
    body.append(point(x, y)).append(" circle[radius=").append(points(radius)).append("];\n");
  }

  @Override
  public void rectangle(double x, double y, double width, double height) {
    fill();
    body.append(point(x, y)).append(" rectangle ").append(point(x + width, y + height));
    body.append(";\n");
  }

  @Override
  public void polygon(double[] x, double[] y) {
    body.append("\\fill[").append(name(stroke.ink())).append(", even odd rule] ");
    for (int i = 0; i < x.length; i++) {
      // A corner a line, so that no line is longer than TeX reads at once.
      body.append(point(x[i], y[i])).append("\n -- ");
    }
    body.append("cycle;\n");
  }

  @Override
  public void text(double x, double y, Anchor anchor, double size, String text) {
    String side =
        switch (anchor) {
          case START -> "base west";
          case MIDDLE -> "base";
          case END -> "base east";
        };
    body.append("\\node[anchor=").append(side).append(", inner sep=0, text=");
    body.append(name(stroke.ink())).append(", font=\\fontsize{").append(points(size));
    body.append("}{").append(points(size)).append("}\\selectfont] at ").append(point(x, y));
    body.append(" {").append(TexText.of(text)).append("};\n");
  }

  private void draw() {
    body.append("\\draw[").append(name(stroke.ink())).append(", line width=");
    body.append(points(stroke.width())).append(stroke.dashed() ? ", dashed] " : "] ");
  }

  private void fill() {
    body.append("\\fill[").append(name(stroke.ink())).append("] ");
  }

  private static String point(double x, double y) {
    return "(" + Decimals.rounded(x) + "," + Decimals.rounded(y) + ")";
  }

  private static String points(double pixels) {
    return Decimals.rounded(POINTS * pixels) + "bp";
  }

  private static String name(Ink ink) {
    return ink.name().toLowerCase(Locale.ROOT).replace("_", "");
  }
}
