package dct.io.format.drawing;

import dct.io.format.Input;
import dct.io.format.Shapes;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import java.util.regex.Pattern;

/** Goes through the elements of an SVG and collects what has straight edges. */
final class SvgReader {
  private static final String SVG = "http://www.w3.org/2000/svg";
  private static final Set<String> GROUPS = Set.of("g", "a", "switch");
  private static final Set<String> SHAPES =
      Set.of("polygon", "polyline", "rect", "path", "circle", "ellipse");
  private static final String INSIDE = "inside"; // the class of the rings of a figure of ours
  private static final String FIXED = "fixed";
  private static final Set<String> MARKS = Set.of("even", "odd", "vertex");
  private static final Set<String> EDGES =
      Set.of("boundary", "diagonal", "partition", "flipped", FIXED);
  private static final String BESIDE = "counts"; // the part with them and the legend
  private static final Set<String> DEFINITIONS =
      Set.of("defs", "symbol", "clipPath", "mask", "pattern", "marker");
  private static final Map<String, LeftOut> OTHERS =
      Map.of(
          "text", LeftOut.TEXT,
          "image", LeftOut.IMAGE,
          "use", LeftOut.USE,
          "line", LeftOut.LINE,
          "svg", LeftOut.EMBEDDED,
          "foreignObject", LeftOut.EMBEDDED);
  private static final Pattern NOT_SHOWN = Pattern.compile("(^|;)\\s*display\\s*:\\s*none\\b");
  private static final Pattern STYLED = Pattern.compile("(^|;)\\s*(transform|rotate|scale)\\s*:");

  private final XmlText xml;
  private final DrawnShapes shapes;
  private final Deque<Frame> open = new ArrayDeque<>();
  private SvgShape shape;

  /** An element that is open, and how it maps what is in it. */
  private record Frame(Affine matrix, SvgLabel label, String part) {}

  SvgReader(Input input, String title) throws IOException {
    xml = new XmlText(input);
    shapes = new DrawnShapes(input.name(), title);
  }

  /** Everything that is drawn. */
  Shapes read() throws IOException {
    while (true) {
      switch (xml.next()) {
        case OPENED -> opened();
        case CLOSED -> open.pop();
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
    String name = xml.element();
    if (open.isEmpty()) {
      shape = new SvgShape(xml, shapes, SvgPage.of(xml));
      open.push(new Frame(Transform.ofSvg(xml, xml.attribute("transform")), null, ""));
    } else if (!xml.namespace().isEmpty() && !xml.namespace().equals(SVG)) {
      xml.skip();
    } else if (isHidden()) {
      shapes.leaveOut(LeftOut.HIDDEN);
      xml.skip();
    } else if (xml.attribute("class").equals("background")) {
      shapes.leaveOut(LeftOut.BACKGROUND);
      xml.skip();
    } else if (!shapes.figure().isEmpty() && xml.attribute("data-part").equals(BESIDE)) {
      xml.skip();
    } else if (name.equals("title")) {
      title(xml.text());
    } else if (GROUPS.contains(name)) {
      open.push(inside(open.peek()));
    } else if (SHAPES.contains(name)) {
      Frame frame = inside(open.peek());
      shape(frame, open.peek());
      open.push(frame);
    } else if (name.equals("line") && isOfFigure(open.peek(), EDGES)) {
      edge(open.peek());
    } else {
      leaveOut(name);
    }
  }

  private void shape(Frame frame, Frame outer) {
    if (isOfFigure(outer, MARKS)) {
      shape.addMark(frame.matrix);
      return;
    }
    int others = shapes.count();
    shape.add(frame.matrix, frame.label, group(outer));
    if (outer.part.equals(INSIDE)) {
      shapes.areOfFigure(others);
    }
  }

  /** Whether what is in this group is drawn from the points of a figure whose rings are read. */
  private boolean isOfFigure(Frame group, Set<String> parts) {
    return !shapes.figure().isEmpty() && parts.contains(group.part);
  }

  private void edge(Frame outer) throws IOException {
    if (outer.part.equals(FIXED)) {
      shape.addFixed(inside(outer).matrix);
    }
    xml.skip();
  }

  private void title(String text) {
    SvgLabel label = open.peek().label;
    if (label != null) { // the title of the whole is that of no shape
      label.title(text);
    }
  }

  private Frame inside(Frame outer) {
    if (STYLED.matcher(xml.attribute("style")).find()) {
      throw xml.fault("a style turns or moves the element; write an attribute transform instead");
    }
    Affine own = Transform.ofSvg(xml, xml.attribute("transform"));
    return new Frame(outer.matrix.of(own), new SvgLabel(xml, group(outer)), xml.attribute("class"));
  }

  private static Supplier<String> group(Frame frame) {
    return frame.label == null ? () -> "" : frame.label;
  }

  private boolean isHidden() {
    return xml.attribute("display").strip().equals("none")
        || NOT_SHOWN.matcher(xml.attribute("style")).find();
  }

  private void leaveOut(String name) throws IOException {
    if (DEFINITIONS.contains(name)) {
      int outside = xml.depth() - 1;
      while (xml.depth() > outside) {
        if (xml.next() == XmlText.Event.OPENED && SHAPES.contains(xml.element())) {
          shapes.leaveOut(LeftOut.DEFINITION);
        }
      }
      return;
    }
    if (OTHERS.containsKey(name)) {
      shapes.leaveOut(OTHERS.get(name));
    }
    xml.skip();
  }
}
