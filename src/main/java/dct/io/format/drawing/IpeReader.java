package dct.io.format.drawing;

import dct.io.format.Input;
import dct.io.format.Shapes;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/** Goes through the elements of a file or selection of Ipe and collects paths and marks. */
final class IpeReader {
  private final XmlText xml;
  private final DrawnShapes shapes;
  private final Deque<Affine> open = new ArrayDeque<>(); // page and groups, of which each maps
  private int pages;
  private String layer = "";
  private Optional<OwnFigure> figure = Optional.empty(); // if this program wrote the file
  private boolean isPolygon; // whether an outline of a figure has been read

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
        && !figure.get().isInput(xml, layer, isPolygon);
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
    String label = label();
    Affine matrix = toPoints();
    isPolygon |= figure.isPresent() && OwnFigure.isOutline(layer);
    int start = xml.lineBehind();
    new IpePath(xml, shapes, matrix, () -> label).add(xml.text(), start);
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
    shapes.addMark(label(), x, y, xml.line());
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
