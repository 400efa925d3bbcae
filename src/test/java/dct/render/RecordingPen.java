package dct.render;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Remembers what was drawn. */
final class RecordingPen implements Pen {
  /** One shape: its kind, colour, and numbers or text. */
  record Shape(String kind, Ink ink, double x, double y, String text) {}

  final List<Shape> shapes = new ArrayList<>();
  private Ink ink;

  long count(String kind, Ink wanted) {
    return shapes.stream().filter(s -> s.kind.equals(kind) && s.ink == wanted).count();
  }

  List<String> texts() {
    return shapes.stream().filter(s -> s.kind.equals("text")).map(Shape::text).toList();
  }

  @Override
  public void style(Stroke stroke) {
    ink = stroke.ink();
  }

  @Override
  public void line(double x1, double y1, double x2, double y2) {
    shapes.add(new Shape("line", ink, x1, y1, x2 + " " + y2));
  }

  @Override
  public void disc(double x, double y, double radius) {
    shapes.add(new Shape("disc", ink, x, y, ""));
  }

  @Override
  public void rectangle(double x, double y, double width, double height) {
    shapes.add(new Shape("rectangle", ink, x, y, width + " " + height));
  }

  @Override
  public void polygon(double[] x, double[] y) {
    shapes.add(
        new Shape("polygon", ink, x[0], y[0], Arrays.toString(x) + " " + Arrays.toString(y)));
  }

  @Override
  public void square(double x, double y, double halfSide) {
    shapes.add(new Shape("square", ink, x, y, ""));
  }

  @Override
  public void ring(double x, double y, double radius) {
    shapes.add(new Shape("ring", ink, x, y, ""));
  }

  @Override
  public void text(double x, double y, Anchor anchor, double size, String text) {
    shapes.add(new Shape("text", ink, x, y, text));
  }
}
