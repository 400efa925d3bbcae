package dct.io.format.drawing;

import dct.core.Decimals;
import dct.io.format.Input;
import dct.io.format.Shapes;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Goes through the elements of a file or selection of Ipe and collects paths and marks. */
final class IpeReader {
  private static final Pattern LINE =
      Pattern.compile("\\s*(\\S+)\\s+(\\S+)\\s+m\\s+(\\S+)\\s+(\\S+)\\s+l\\s*");

  private final XmlText xml;
  private final DrawnShapes shapes;
  private final Deque<Affine> open = new ArrayDeque<>(); // page and groups, of which each maps
  private int pages;
  private String layer = "";
  private Optional<OwnFigure> figure = Optional.empty(); // if this program wrote the file

  IpeReader(Input input, String title) throws IOException {
    xml = new XmlText(input);
    shapes = new DrawnShapes(input.name(), title);
  }

  /** Everything that is drawn on any page. */
  Shapes read() throws IOException {
    xml.next();
    if (xml.element().equals("ipeselection")) {
      openPage();
    }
    while (true) {
      switch (xml.next()) {
        case OPENED -> opened();
        case CLOSED -> open.poll(); // the outermost element stands not among them
        case END -> {
          return shapes.finished();
        }
        default -> {
          // text between elements
        }
      }
    }
  }

  private void opened() throws IOException {
    if (!open.isEmpty()) {
      object();
    } else if (xml.element().equals("page")) {
      openPage();
    } else {
      if (xml.element().equals("info")) {
        figure = OwnFigure.of(xml);
        figure.ifPresent(own -> shapes.figure().mapBy(own.toPage()));
      }
      xml.skip(); // styles and what else belongs to no page
    }
  }

  private void openPage() {
    open.push(Affine.IDENTITY);
    pages++;
    layer = "";
  }

  private void object() throws IOException {
    if (open.size() == 1 && !xml.attribute("layer").isEmpty()) {
      layer = xml.attribute("layer");
    }
    if (isDrawn()) {
      xml.skip();
      return;
    }
    switch (xml.element()) {
      case "group" -> open.push(matrix());
      case "path" -> path();
      case "use" -> use();
      case "text" -> leaveOut(LeftOut.TEXT);
      case "image" -> leaveOut(LeftOut.IMAGE);
      case "layer" -> layer();
      default -> xml.skip();
    }
  }

  /** Whether an object of a figure of this program is only drawn from the points. */
  private boolean isDrawn() {
    return figure.isPresent()
        && !xml.element().equals("group")
        && !xml.element().equals("layer")
        && !figure.get().isInput(xml, layer);
  }

  private void leaveOut(LeftOut what) throws IOException {
    shapes.leaveOut(what);
    xml.skip();
  }

  /** An object is in the first layer if none before it names another. */
  private void layer() throws IOException {
    layer = layer.isEmpty() ? xml.attribute("name") : layer;
    xml.skip();
  }

  private Affine matrix() {
    return open.peek().of(Transform.ofIpe(xml, xml.attribute("matrix")));
  }

  /** The map of an object to the plane of the points. */
  private Affine toPoints() {
    Affine matrix = matrix();
    return figure.map(own -> own.toPoints(matrix)).orElse(matrix);
  }

  private String label() {
    return pages == 1 ? layer : "page " + pages + (layer.isEmpty() ? "" : ", " + layer);
  }

  private void path() throws IOException {
    if (figure.isPresent() && OwnFigure.isFixedEdge(xml, layer)) {
      fixedEdge();
      return;
    }
    String label = label();
    Affine matrix = toPoints();
    int start = xml.lineBehind();
    int others = shapes.count();
    new IpePath(xml, shapes, matrix, () -> label).add(xml.text(), start);
    if (figure.isPresent() && OwnFigure.isOutline(layer)) {
      shapes.areOfFigure(others);
    }
  }

  /** A line from one place of the page to another. */
  private void fixedEdge() throws IOException {
    Affine matrix = matrix();
    Matcher line = LINE.matcher(xml.text());
    if (line.matches()) {
      double[] ends = new double[4];
      Arrays.setAll(ends, k -> Decimals.parse(line.group(k + 1)));
      shapes
          .figure()
          .addFixed(
              matrix.x(ends[0], ends[1]),
              matrix.y(ends[0], ends[1]),
              matrix.x(ends[2], ends[3]),
              matrix.y(ends[2], ends[3]));
    }
  }

  private void use() throws IOException {
    if (!xml.attribute("name").startsWith("mark/")) {
      leaveOut(LeftOut.SYMBOL);
      return;
    }
    Affine matrix = toPoints();
    String written = xml.attribute("pos"); // Ipe leaves out that of the origin
    NumberText position = new NumberText(written.isEmpty() ? "0 0" : written);
    double px = number(position);
    double py = number(position);
    double x = matrix.x(px, py);
    double y = matrix.y(px, py);
    xml.checkFinite(x, y, xml.line());
    if (figure.isPresent() && OwnFigure.isMarks(layer) && !shapes.figure().isEmpty()) {
      shapes.figure().addMark(x, y, xml.line());
    } else {
      shapes.addMark(label(), x, y, xml.line());
    }
    xml.skip();
  }

  private double number(NumberText position) {
    position.skipSpace();
    double number = position.number();
    if (Double.isNaN(number)) {
      throw xml.noNumber(xml.line(), position.word(), "the attribute pos");
    }
    return number;
  }
}
