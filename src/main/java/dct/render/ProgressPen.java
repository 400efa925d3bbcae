package dct.render;

import dct.core.Progress;

/** Draws with another pen and asks now and then whether to go on. */
final class ProgressPen implements Pen {
  private final Pen pen;
  private final Progress progress;
  private int shapes;

  /** A pen whose methods throw a CancellationException when cancelled. */
  ProgressPen(Pen pen, Progress progress) {
    this.pen = pen;
    this.progress = progress;
  }

  private Pen next() {
    Progress.check(progress, shapes++);
    return pen;
  }

  @Override
  public void part(Part part) {
    next().part(part);
  }

  @Override
  public void vertex(int vertex) {
    pen.vertex(vertex);
  }

  @Override
  public void style(Stroke stroke) {
    next().style(stroke);
  }

  @Override
  public void line(double x1, double y1, double x2, double y2) {
    next().line(x1, y1, x2, y2);
  }

  @Override
  public void disc(double x, double y, double radius) {
    next().disc(x, y, radius);
  }

  @Override
  public void rectangle(double x, double y, double width, double height) {
    next().rectangle(x, y, width, height);
  }

  @Override
  public void square(double x, double y, double halfSide) {
    next().square(x, y, halfSide);
  }

  @Override
  public void polygon(double[] x, double[] y) {
    next().polygon(x, y);
  }

  @Override
  public void ring(double x, double y, double radius) {
    next().ring(x, y, radius);
  }

  @Override
  public void text(double x, double y, Anchor anchor, double size, String text) {
    next().text(x, y, anchor, size, text);
  }
}
