package dct.io.format.drawing;

/**
 * The page of an SVG.
 *
 * @param viewBox the four numbers of its attribute {@code viewBox}, as they are written
 * @param width its attribute of this name
 * @param height its attribute of this name
 */
record SvgPage(String viewBox, String width, String height) {

  /** The page of the element that has just been opened. */
  static SvgPage of(XmlText xml) {
    return new SvgPage(xml.attribute("viewBox"), xml.attribute("width"), xml.attribute("height"));
  }

  /** Whether a rectangle covers the page exactly. */
  boolean isCoveredBy(double x, double y, double w, double h) {
    NumberText numbers = new NumberText(viewBox);
    double[] box = {0, 0, NumberText.length(width), NumberText.length(height)};
    for (int i = 0; i < box.length && !viewBox.isBlank(); i++) {
      numbers.skipComma();
      box[i] = numbers.number();
    }
    return x == box[0] && y == box[1] && w == box[2] && h == box[3];
  }
}
