package dct.io.format.drawing;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;

/** Adds what an element of SVG draws to the shapes. */
final class SvgShape {
  private final XmlText xml;
  private final DrawnShapes shapes;
  private final SvgPage page;

  /** Elements on a page. */
  SvgShape(XmlText xml, DrawnShapes shapes, SvgPage page) {
    this.xml = xml;
    this.shapes = shapes;
    this.page = page;
  }

  /**
   * Adds the element that has just been opened.
   *
   * @param matrix the map of its coordinates
   * @param label what it is called
   * @param group what the group is called that it is in
   */
  void add(Affine matrix, Supplier<String> label, Supplier<String> group) {
    switch (xml.element()) {
      case "polygon" -> polygon(matrix, label, true);
      case "polyline" -> polygon(matrix, label, false);
      case "rect" -> rectangle(matrix, label);
      case "path" -> path(matrix, label);
      default -> disc(matrix, group);
    }
  }

  /** Adds the circle or rectangle that has just been opened as the mark of a vertex. */
  void addMark(Affine matrix) {
    boolean isRectangle = xml.element().equals("rect");
    double half = isRectangle ? 0.5 : 0;
    double px = length(isRectangle ? "x" : "cx") + half * length("width");
    double py = length(isRectangle ? "y" : "cy") + half * length("height");
    double x = matrix.x(px, py);
    double y = matrix.y(px, py);
    if (Double.isFinite(x) && Double.isFinite(y)) {
      shapes.figure().addMark(x, y, xml.line());
    }
  }

  /** Adds the line that has just been opened as a fixed edge. */
  void addFixed(Affine matrix) {
    double x1 = length("x1");
    double y1 = length("y1");
    double x2 = length("x2");
    double y2 = length("y2");
    shapes
        .figure()
        .addFixed(matrix.x(x1, y1), matrix.y(x1, y1), matrix.x(x2, y2), matrix.y(x2, y2));
  }

  private double length(String attribute) {
    return NumberText.length(xml.attribute(attribute));
  }

  private void polygon(Affine matrix, Supplier<String> label, boolean isClosed) {
    NumberText numbers = new NumberText(xml.attribute("points"));
    Outline outline = new Outline(xml, matrix);
    numbers.skipSpace();
    while (!numbers.isAtEnd()) {
      double x = number(numbers);
      outline.add(x, number(numbers), xml.line());
    }
    if (isClosed) {
      outline.close();
    }
    shapes.add(label, outline);
  }

  private double number(NumberText numbers) {
    double number = numbers.number();
    if (Double.isNaN(number)) {
      throw xml.noNumber(xml.line(), numbers.word(), "the attribute points");
    }
    numbers.skipComma();
    return number;
  }

  private void path(Affine matrix, Supplier<String> label) {
    String data = xml.attribute("d");
    if (data.strip().equals("none")) {
      return;
    }
    Optional<List<Outline>> outlines = SvgPath.read(xml, data, xml.line(), matrix);
    outlines.ifPresentOrElse(
        straight -> straight.forEach(outline -> shapes.add(label, outline)),
        () -> shapes.leaveOut(LeftOut.CURVED));
  }

  private void rectangle(Affine matrix, Supplier<String> label) {
    double x = NumberText.length(xml.attribute("x"));
    double y = NumberText.length(xml.attribute("y"));
    double width = NumberText.length(xml.attribute("width"));
    double height = NumberText.length(xml.attribute("height"));
    if (isRounded("rx") || isRounded("ry")) {
      shapes.leaveOut(LeftOut.CURVED);
    } else if (width > 0 && height > 0 && !Double.isNaN(x + y)) {
      Outline outline = box(matrix, x, y, x + width, y + height);
      boolean isPage = matrix.isIdentity() && page.isCoveredBy(x, y, width, height);
      if (isPage && shapes.isEmpty()) {
        shapes.addBackground(label, outline);
      } else {
        shapes.add(label, outline);
      }
    } else {
      shapes.leaveOut(LeftOut.SIZELESS);
    }
  }

  private boolean isRounded(String radius) {
    String value = xml.attribute(radius).strip();
    return !value.equals("auto") && NumberText.length(value) != 0;
  }

  private Outline box(Affine matrix, double x1, double y1, double x2, double y2) {
    Outline outline = new Outline(xml, matrix);
    outline.add(x1, y1, xml.line());
    outline.add(x2, y1, xml.line());
    outline.add(x2, y2, xml.line());
    outline.add(x1, y2, xml.line());
    outline.close();
    return outline;
  }

  private void disc(Affine matrix, Supplier<String> group) {
    double px = NumberText.length(xml.attribute("cx"));
    double py = NumberText.length(xml.attribute("cy"));
    double x = matrix.x(px, py);
    double y = matrix.y(px, py);
    double radius =
        xml.element().equals("circle")
            ? NumberText.length(xml.attribute("r"))
            : Math.max(
                NumberText.length(xml.attribute("rx")), NumberText.length(xml.attribute("ry")));
    if (Double.isFinite(x) && Double.isFinite(y)) {
      shapes.addDisc(group, x, y, matrix.scale() * radius, xml.line());
    } else {
      shapes.leaveOut(LeftOut.CIRCLE);
    }
  }
}
