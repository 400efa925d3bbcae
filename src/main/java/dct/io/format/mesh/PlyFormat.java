package dct.io.format.mesh;

import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.Rows;
import dct.io.format.Shapes;
import dct.io.text.Shown;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;

/** Stanford's polygon format as text: x, y and z of the vertices, and the faces. */
public final class PlyFormat implements Format {
  private static final Pattern HEADER = Pattern.compile("ply");
  private static final Set<String> CORNERS = Set.of("vertex_indices", "vertex_index");

  /**
   * A kind of thing that the file holds.
   *
   * @param properties their names; that of a list starts with {@code list}
   */
  private record Element(String name, int count, List<String> properties) {
    int place(String property) {
      return properties.indexOf(property);
    }
  }

  @Override
  public String title() {
    return "PLY";
  }

  @Override
  public boolean fits(Head head) {
    return Rows.startsWith(head, HEADER);
  }

  @Override
  public Shapes read(Input input) throws IOException {
    Rows rows = new Rows(input);
    rows.next(0, 1, "headers");
    Mesh mesh = new Mesh();
    for (Element element : header(rows)) {
      for (int i = 0; i < element.count; i++) {
        rows.next(i, element.count, "lines of the element " + Shown.word(element.name));
        if (element.name.equals("vertex")) {
          vertex(rows, element, mesh);
        } else if (element.name.equals("face")) {
          mesh.face(OffFormat.face(rows, mesh.size()), rows.line());
        }
      }
    }
    return mesh.shapes(title(), rows);
  }

  private static List<Element> header(Rows rows) throws IOException {
    List<Element> elements = new ArrayList<>();
    while (true) {
      rows.next(0, 1, "lines end_header");
      List<String> words = rows.words();
      switch (words.get(0)) {
        case "format" -> requireText(rows);
        case "element" ->
            elements.add(new Element(name(rows, 1), rows.count(2), new ArrayList<>()));
        case "property" -> property(rows, elements);
        case "comment", "obj_info" -> {}
        case "end_header" -> {
          requireOrder(rows, elements);
          return elements;
        }
        default ->
            throw rows.fault(
                "\"" + Shown.word(words.get(0)) + "\" is no word of a PLY header; correct it");
      }
    }
  }

  private static String name(Rows rows, int word) {
    if (word >= rows.words().size()) {
      throw rows.fault("a name is missing at the end of the line; correct it");
    }
    return rows.words().get(word);
  }

  private static void requireText(Rows rows) {
    if (!name(rows, 1).equals("ascii")) {
      throw rows.fault("this is binary PLY, only PLY in ASCII is read; save it as ASCII or as OFF");
    }
  }

  private static void property(Rows rows, List<Element> elements) {
    if (elements.isEmpty()) {
      throw rows.fault("this property belongs to no element; correct the order of the lines");
    }
    boolean isList = name(rows, 1).equals("list");
    String name = isList ? "list " + name(rows, 4) : name(rows, 2);
    elements.get(elements.size() - 1).properties.add(name);
  }

  /** Vertices with x and y stand before the faces, of which the corners come first. */
  private static void requireOrder(Rows rows, List<Element> elements) {
    boolean hasVertices = false;
    for (Element element : elements) {
      if (element.name.equals("vertex")) {
        hasVertices = true;
        boolean isPlain = element.properties.stream().noneMatch(name -> name.startsWith("list "));
        if (element.place("x") < 0 || element.place("y") < 0 || !isPlain) {
          throw rows.fault(
              "the vertices need properties x and y and no lists; write them so, or save it as"
                  + " OFF");
        }
      }
      boolean isFace = element.name.equals("face") && element.count > 0;
      if (isFace
          && (!hasVertices
              || element.properties.isEmpty()
              || !CORNERS.contains(element.properties.get(0).replace("list ", "")))) {
        throw rows.fault(
            "the faces do not start with a list vertex_indices behind the vertices; save it as"
                + " OFF");
      }
    }
  }

  private static void vertex(Rows rows, Element element, Mesh mesh) {
    int z = element.place("z");
    mesh.add(
        rows.number(element.place("x")),
        rows.number(element.place("y")),
        z < 0 ? 0 : rows.number(z),
        rows.line());
  }
}
