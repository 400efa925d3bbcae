package dct.io.format.drawing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dct.io.format.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Element;
import org.w3c.dom.Node;

/** Random drawings, read by us and by a second reader on the JDK's document object model. */
class SecondXmlReaderTest {
  private static final int ROUNDS = Integer.getInteger("dct.fuzz", 300);
  private static final Pattern NUMBER =
      Pattern.compile("[-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?");
  private static final Pattern COMMAND = Pattern.compile("([A-Za-z])([^A-DF-Za-df-z]*)");
  private static final Pattern TRANSFORM = Pattern.compile("(\\w+)\\s*\\(([^)]*)\\)");

  private final Random random = new Random(29);
  private final List<List<Point2D>> found = new ArrayList<>(); // by the second reader
  private List<Point2D> marks = new ArrayList<>();

  private static double[] numbers(String text) {
    return NUMBER.matcher(text).results().mapToDouble(m -> Double.parseDouble(m.group())).toArray();
  }

  private static void compose(AffineTransform to, String name, double[] n) {
    switch (name) {
      case "translate" -> to.translate(n[0], n.length > 1 ? n[1] : 0);
      case "scale" -> to.scale(n[0], n.length > 1 ? n[1] : n[0]);
      case "rotate" -> {
        if (n.length > 1) {
          to.rotate(Math.toRadians(n[0]), n[1], n[2]);
        } else {
          to.rotate(Math.toRadians(n[0]));
        }
      }
      case "skewX" -> to.shear(Math.tan(Math.toRadians(n[0])), 0);
      default -> to.concatenate(new AffineTransform(n));
    }
  }

  private void add(AffineTransform map, List<Point2D> points) {
    if (points.size() > 2) {
      found.add(points.stream().map(p -> map.transform(p, null)).toList());
    }
  }

  private void readSvg(Element element, AffineTransform outer) {
    AffineTransform map = new AffineTransform(outer);
    Matcher transforms = TRANSFORM.matcher(element.getAttribute("transform"));
    while (transforms.find()) {
      compose(map, transforms.group(1), numbers(transforms.group(2)));
    }
    switch (element.getTagName()) {
      case "polygon", "polyline" -> add(map, pairs(numbers(element.getAttribute("points"))));
      case "rect" -> {
        double x = Double.parseDouble(element.getAttribute("x"));
        double y = Double.parseDouble(element.getAttribute("y"));
        double w = Double.parseDouble(element.getAttribute("width"));
        double h = Double.parseDouble(element.getAttribute("height"));
        add(map, pairs(x, y, x + w, y, x + w, y + h, x, y + h));
      }
      case "path" -> path(map, element.getAttribute("d"));
      default -> {}
    }
    children(element).forEach(child -> readSvg(child, map));
  }

  private static List<Point2D> pairs(double... numbers) {
    List<Point2D> points = new ArrayList<>();
    for (int i = 0; i + 1 < numbers.length; i += 2) {
      points.add(new Point2D.Double(numbers[i], numbers[i + 1]));
    }
    return points;
  }

  private static List<Element> children(Element element) {
    List<Element> children = new ArrayList<>();
    for (Node node = element.getFirstChild(); node != null; node = node.getNextSibling()) {
      if (node instanceof Element child) {
        children.add(child);
      }
    }
    return children;
  }

  private void path(AffineTransform map, String data) {
    List<Point2D> points = new ArrayList<>();
    double x = 0;
    double y = 0;
    Matcher commands = COMMAND.matcher(data);
    while (commands.find()) {
      char command = commands.group(1).charAt(0);
      boolean relative = Character.isLowerCase(command);
      double[] n = numbers(commands.group(2));
      switch (Character.toUpperCase(command)) {
        case 'Z' -> {
          x = points.get(0).getX();
          y = points.get(0).getY();
          add(map, points);
          points = new ArrayList<>();
        }
        case 'H', 'V' -> {
          for (double to : n) {
            boolean across = Character.toUpperCase(command) == 'H';
            x = across ? to + (relative ? x : 0) : x;
            y = across ? y : to + (relative ? y : 0);
            points.add(new Point2D.Double(x, y));
          }
        }
        default -> {
          if (Character.toUpperCase(command) == 'M') {
            add(map, points);
            points = new ArrayList<>();
          }
          for (Point2D to : pairs(n)) {
            x = to.getX() + (relative ? x : 0);
            y = to.getY() + (relative ? y : 0);
            points.add(new Point2D.Double(x, y));
          }
        }
      }
    }
    add(map, points);
  }

  private String number() {
    double value = (random.nextDouble() - 0.5) * 400;
    return switch (random.nextInt(6)) {
      case 0 -> Integer.toString((int) value);
      case 1 -> String.format(Locale.ROOT, "%.3f", value).replaceFirst("^(-?)0\\.", "$1.");
      case 2 -> String.format(Locale.ROOT, "%.4e", value);
      case 3 -> String.format(Locale.ROOT, "%+.2f", value);
      case 4 -> String.format(Locale.ROOT, "%.2E", value);
      default -> Double.toString(value);
    };
  }

  private String space() {
    return new String[] {" ", "\n  ", "\t", "  "}[random.nextInt(4)];
  }

  private String list(int count) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < count; i++) {
      String number = number();
      boolean signed = number.startsWith("-") || number.startsWith("+");
      String gap = random.nextInt(3) == 0 ? "," + (random.nextBoolean() ? "" : space()) : space();
      boolean none = signed && random.nextInt(3) == 0;
      text.append(i == 0 || none ? "" : gap).append(number);
    }
    return text.toString();
  }

  private String transform() {
    return switch (random.nextInt(7)) {
      case 0 -> " transform='translate(" + list(1 + random.nextInt(2)) + ")'";
      case 1 -> " transform=\"scale(" + (1 + random.nextInt(3)) + ") translate(" + list(2) + ")\"";
      case 2 -> " transform='matrix(1 .5 -.25 2 " + list(2) + ")'";
      case 3 -> " transform = 'rotate(" + list(random.nextBoolean() ? 1 : 3) + ")'";
      case 4 -> " transform='skewX(" + (5 + random.nextInt(40)) + "), scale(-1, 2)'";
      default -> "";
    };
  }

  private String data() {
    StringBuilder data = new StringBuilder();
    for (int part = 0; part <= random.nextInt(3); part++) {
      data.append(random.nextBoolean() ? "M" : "m").append(list(2 + 2 * random.nextInt(2)));
      for (int k = 0; k < 2 + random.nextInt(4); k++) {
        String command = "LlHhVv".substring(random.nextInt(6)).substring(0, 1);
        boolean pair = command.equalsIgnoreCase("l");
        data.append(random.nextBoolean() ? space() : "").append(command);
        data.append(list((pair ? 2 : 1) * (1 + random.nextInt(2))));
      }
      data.append(random.nextInt(3) > 0 ? random.nextBoolean() ? "z" : " Z " : "");
    }
    return data.toString();
  }

  private String svgElements(int depth) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 1 + random.nextInt(3); i++) {
      text.append(random.nextInt(5) == 0 ? "<!-- <polygon points='0'/> -->" : space());
      String more = transform() + (random.nextBoolean() ? " id='a&#x62;&lt;&amp;'" : "");
      text.append(
          switch (random.nextInt(depth > 0 ? 5 : 4)) {
            case 0 -> "<polygon" + more + " points='" + list(2 * (3 + random.nextInt(5))) + "'/>";
            case 1 ->
                "<polyline points=\""
                    + list(2 * (3 + random.nextInt(5)))
                    + "\""
                    + more
                    + "></polyline>";
            case 2 -> "<path d='" + data() + "'" + more + "><title>a</title></path>";
            case 3 ->
                "<rect x='"
                    + number()
                    + "' y='"
                    + number()
                    + "' width='7.5' height='12'"
                    + more
                    + "/>";
            default -> "<g" + more + ">" + svgElements(depth - 1) + "</g>";
          });
    }
    return text.toString();
  }

  private static Element root(String text) throws Exception {
    DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
    return factory
        .newDocumentBuilder()
        .parse(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)))
        .getDocumentElement();
  }

  private void compare(String text) throws Exception {
    List<Shape> shapes = Drawn.read(text).shapes();
    assertThat(shapes).as(text).hasSameSizeAs(found);
    for (int i = 0; i < shapes.size(); i++) {
      Shape shape = shapes.get(i);
      assertThat(shape.points().size())
          .as("shape %d of %s", i, text)
          .isEqualTo(found.get(i).size());
      for (int v = 0; v < shape.points().size(); v++) {
        Point2D theirs = found.get(i).get(v);
        double scale = 1e-9 * (1 + Math.abs(theirs.getX()) + Math.abs(theirs.getY()) + 1e4);
        assertThat(shape.points().x(v)).as(text).isEqualTo(theirs.getX(), within(scale));
        assertThat(shape.points().y(v)).as(text).isEqualTo(theirs.getY(), within(scale));
      }
    }
  }

  @Test
  void svg_is_read_as_by_another_reader() throws Exception {
    for (int round = 0; round < ROUNDS; round++) {
      String text =
          "<?xml version='1.0' encoding='UTF-8'?>\n<svg xmlns='http://www.w3.org/2000/svg'>"
              + svgElements(3)
              + "</svg>\n";
      found.clear();
      readSvg(root(text), new AffineTransform());
      if (!found.isEmpty()) {
        compare(text);
      }
    }
  }

  private static AffineTransform matrix(Element element, AffineTransform outer) {
    AffineTransform map = new AffineTransform(outer);
    if (element.hasAttribute("matrix")) {
      map.concatenate(new AffineTransform(numbers(element.getAttribute("matrix"))));
    }
    return map;
  }

  private void readIpe(Element element, AffineTransform outer) {
    AffineTransform map = matrix(element, outer);
    if (element.getTagName().equals("path")) {
      List<Point2D> points = new ArrayList<>();
      for (String part : element.getTextContent().strip().split("(?<=[mlh])\\s+", -1)) {
        if (part.endsWith("m")) {
          add(map, points);
          points = new ArrayList<>();
        }
        points.addAll(pairs(numbers(part)));
      }
      add(map, points);
    } else if (element.getTagName().equals("use")) {
      if (marks.isEmpty()) {
        found.add(marks);
      }
      double[] pos = numbers(element.getAttribute("pos"));
      marks.add(map.transform(new Point2D.Double(pos[0], pos[1]), null));
    }
    children(element).forEach(child -> readIpe(child, map));
  }

  private String ipeElements(int depth) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 1 + random.nextInt(4); i++) {
      String more = random.nextInt(3) == 0 ? " matrix=\"1 0.5 -2 1 " + pair() + "\"" : "";
      switch (random.nextInt(depth > 0 ? 4 : 3)) {
        case 0 -> text.append("<use name=\"mark/disk(sx)\" pos=\"" + pair() + "\"" + more + "/>\n");
        case 3 -> text.append("<group" + more + ">\n" + ipeElements(depth - 1) + "</group>\n");
        default -> {
          text.append("<path stroke=\"black\"" + more + ">\n");
          for (int part = 0; part <= random.nextInt(2); part++) {
            text.append(pair() + " m\n");
            for (int k = 0; k < 2 + random.nextInt(4); k++) {
              text.append(pair() + (random.nextBoolean() ? " l\n" : "   l "));
            }
            text.append(random.nextBoolean() ? "h\n" : "");
          }
          text.append("</path>\n");
        }
      }
    }
    return text.toString();
  }

  private String pair() {
    return number() + " " + number();
  }

  @Test
  void ipe_is_read_as_by_another_reader() throws Exception {
    for (int round = 0; round < ROUNDS; round++) {
      String text =
          "<?xml version=\"1.0\"?>\n<ipe version=\"70218\" creator=\"Ipe 7.2.26\">\n<page>\n"
              + ipeElements(3)
              + "</page>\n</ipe>\n";
      found.clear();
      marks = new ArrayList<>();
      readIpe(root(text), new AffineTransform());
      compare(text);
    }
  }
}
