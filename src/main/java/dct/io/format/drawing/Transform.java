package dct.io.format.drawing;

import dct.io.text.Shown;
import java.util.Arrays;
import java.util.List;

/** The maps in an attribute {@code transform} of SVG, or {@code matrix} of Ipe. */
final class Transform {
  private static final int MOST = 6; // numbers of one map

  private final XmlText xml;
  private final String place;
  private final NumberText text;

  private Transform(XmlText xml, String attribute, String value) {
    this.xml = xml;
    this.place = "the attribute " + attribute;
    this.text = new NumberText(value);
  }

  /**
   * All maps of {@code transform} together.
   *
   * @throws dct.io.text.BadInputException if it is no list of maps
   */
  static Affine ofSvg(XmlText xml, String value) {
    Transform transform = new Transform(xml, "transform", value);
    return value.strip().equals("none") ? Affine.IDENTITY : transform.list();
  }

  /**
   * The map of {@code matrix}; the identity if it is empty.
   *
   * @throws dct.io.text.BadInputException if it is not of six numbers
   */
  static Affine ofIpe(XmlText xml, String value) {
    Transform transform = new Transform(xml, "matrix", value);
    transform.text.skipSpace();
    return transform.text.isAtEnd() ? Affine.IDENTITY : transform.map("matrix");
  }

  private Affine list() {
    Affine all = Affine.IDENTITY;
    text.skipSpace();
    while (!text.isAtEnd()) {
      String name = name();
      all = all.of(map(name));
      if (text.peek() != ')') {
        throw xml.fault("a closing parenthesis is missing in " + place + "; add it");
      }
      text.advance();
      text.skipComma();
    }
    return all;
  }

  private String name() {
    StringBuilder name = new StringBuilder();
    while (Character.isLetterOrDigit(text.peek())) {
      name.append(text.peek());
      text.advance();
    }
    text.skipSpace();
    if (text.peek() != '(') {
      String word = name + text.word();
      throw xml.fault(
          "\"" + Shown.word(word) + "\" in " + place + " is no map with numbers; correct it");
    }
    text.advance();
    text.skipSpace();
    return name.toString();
  }

  private Affine map(String name) {
    double[] v = new double[MOST];
    int count = 0;
    while (!text.isAtEnd() && text.peek() != ')') {
      double number = text.number();
      if (Double.isNaN(number)) {
        throw xml.noNumber(xml.line(), text.word(), place);
      }
      if (count == MOST) {
        throw wrongCount(name);
      }
      v[count++] = number;
      text.skipComma();
    }
    return map(name, Arrays.copyOf(v, count));
  }

  private Affine map(String name, double[] v) {
    int n = v.length;
    boolean fits =
        switch (name) {
          case "matrix" -> n == 6;
          case "translate", "scale" -> n == 1 || n == 2;
          case "rotate" -> n == 1 || n == 3;
          case "skewX", "skewY" -> n == 1;
          default ->
              throw xml.fault(
                  "\"" + Shown.word(name) + "\" in " + place + " is not known; use matrix");
        };
    if (!fits) {
      throw wrongCount(name);
    }
    return switch (name) {
      case "matrix" -> new Affine(v[0], v[1], v[2], v[3], v[4], v[5]);
      case "translate" -> new Affine(1, 0, 0, 1, v[0], n == 2 ? v[1] : 0);
      case "scale" -> new Affine(v[0], 0, 0, n == 2 ? v[1] : v[0], 0, 0);
      case "rotate" -> n == 1 ? rotation(v[0]) : rotation(v[0], v[1], v[2]);
      case "skewX" -> new Affine(1, 0, tangent(v[0]), 1, 0, 0);
      default -> new Affine(1, tangent(v[0]), 0, 1, 0, 0);
    };
  }

  private RuntimeException wrongCount(String name) {
    return xml.fault(name + " in " + place + " has not as many numbers as it needs; correct it");
  }

  private static Affine rotation(double degrees, double x, double y) {
    Affine back = new Affine(1, 0, 0, 1, -x, -y);
    return new Affine(1, 0, 0, 1, x, y).of(rotation(degrees)).of(back);
  }

  /** A rotation; by quarters of a turn it is exact. */
  private static Affine rotation(double degrees) {
    double quarters = degrees / 90;
    if (quarters == Math.rint(quarters)) {
      int quarter = (int) (((quarters % 4) + 4) % 4);
      double cos = List.of(1.0, 0.0, -1.0, 0.0).get(quarter);
      double sin = List.of(0.0, 1.0, 0.0, -1.0).get(quarter);
      return new Affine(cos, sin, -sin + 0.0, cos, 0, 0);
    }
    double radians = StrictMath.toRadians(degrees);
    double cos = StrictMath.cos(radians);
    double sin = StrictMath.sin(radians);
    return new Affine(cos, sin, -sin, cos, 0, 0);
  }

  private static double tangent(double degrees) {
    return StrictMath.tan(StrictMath.toRadians(degrees));
  }
}
