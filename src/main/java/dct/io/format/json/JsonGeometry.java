package dct.io.format.json;

import com.google.gson.stream.JsonToken;
import dct.io.format.Input;
import dct.io.format.PointColumns;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import dct.io.text.PlainText;
import dct.io.text.Shown;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Reads shapes of JSON: of a geometry, feature or collection of GeoJSON, of the challenge {@link
 * CgShop}, or plain arrays. Unknown fields are skipped.
 */
final class JsonGeometry {
  private static final List<String> NAMES =
      List.of("name", "NAME", "Name", "title", "id", "ID", "label");

  private final Input input;
  private final JsonScanner scanner;
  private final List<Shape> shapes = new ArrayList<>();
  private String format = "GeoJSON";
  private int beyond; // numbers behind x and y
  private int empty; // geometries without points
  private final List<String> notes = new ArrayList<>();

  private JsonGeometry(Input input) {
    this.input = input;
    scanner = new JsonScanner(input);
  }

  static Shapes read(Input input) throws IOException {
    JsonGeometry geometry = new JsonGeometry(input);
    geometry.scanner.whole(geometry::top);
    return geometry.shapes();
  }

  private Shapes shapes() {
    if (shapes.isEmpty()) {
      throw scanner.fault(
          "there is no geometry with points in this "
              + format
              + "; write \"type\": \"Polygon\", \"coordinates\": [[[x, y], …]]");
    }
    if (beyond > 0) {
      notes.add("Numbers behind x and y are left out");
    }
    if (empty > 0) {
      notes.add(empty + (empty == 1 ? " geometry" : " geometries") + " without points left out");
    }
    int rounded = scanner.rounded();
    if (rounded > 0) {
      notes.add(
          rounded
              + (rounded == 1 ? " coordinate is a fraction" : " coordinates are fractions")
              + " that no double equals; the nearest is read");
    }
    return new Shapes(format, shapes, notes);
  }

  private void top() throws IOException {
    if (scanner.json.peek() == JsonToken.BEGIN_ARRAY) {
      format = "JSON";
      arrays();
    } else {
      object();
    }
  }

  /** Plain arrays of points. */
  private void arrays() throws IOException {
    Nested nested = scanner.nested();
    if (nested.depth == 1) { // all numbers in one array
      throw scanner.fault("the numbers stand in one list; write [[x, y], [x, y], …]");
    }
    beyond += nested.isFlat() ? 0 : nested.beyond;
    for (PointColumns ring : nested.isFlat() ? nested.flat : nested.rings()) {
      shapes.add(Shape.of(Shape.Kind.POINTS, "", ring));
    }
  }

  /** One object: the fields may come in any order, so the type may follow what it is of. */
  private void object() throws IOException {
    CgShop challenge = new CgShop(scanner);
    VertexLists vertices = new VertexLists(scanner);
    Optional<Nested> coordinates = Optional.empty();
    String type = "";
    String name = "";
    int first = shapes.size();
    scanner.json.beginObject();
    while (scanner.json.hasNext()) {
      String field = scanner.json.nextName();
      JsonToken value = scanner.json.peek();
      boolean isArray = value == JsonToken.BEGIN_ARRAY;
      boolean isText = value == JsonToken.STRING;
      switch (field) {
        case "type", "content_type" -> type = isText ? scanner.json.nextString() : skipped(type);
        case "name", "instance_uid", "instance_name", "id" ->
            name = isText || value == JsonToken.NUMBER ? scanner.json.nextString() : skipped(name);
        case "coordinates" -> {
          if (isArray) {
            coordinates = Optional.of(scanner.nested());
          } else {
            scanner.json.skipValue();
          }
        }
        case "geometry" -> {
          if (value == JsonToken.BEGIN_OBJECT) {
            object();
          } else {
            scanner.json.skipValue();
            empty++;
          }
        }
        case "container" -> {
          if (value == JsonToken.BEGIN_OBJECT) {
            object();
          } else {
            scanner.json.skipValue();
          }
        }
        case "items" -> items();
        case "geometries", "features" -> objects();
        case "properties" -> name = properties(name);
        default -> {
          if (!vertices.read(field) && !challenge.read(field)) {
            scanner.json.skipValue();
          }
        }
      }
    }
    scanner.json.endObject();
    if (coordinates.isPresent()) {
      geometry(type, coordinates.get());
    } else if (vertices.isPresent()) {
      format = "JSON";
      shapes.addAll(vertices.shapes(notes));
    } else {
      vertices.holes().ifPresent(challenge::holes);
      List<Shape> flipped = flipped(challenge.flips(), name);
      add(flipped.isEmpty() ? challenge.shapes(type, name, notes) : flipped);
    }
    label(first, name);
  }

  /** The triangulations of the instance that stands beside its solution; none if it does not. */
  private List<Shape> flipped(Optional<CgShopFlips> flips, String instance) throws IOException {
    Optional<Path> file = flips.flatMap(found -> CgShopFlips.instanceBeside(input, instance));
    if (file.isEmpty()) {
      return List.of();
    }
    String beside = file.get().toString();
    try (InputStream in = Files.newInputStream(file.get())) {
      List<Shape> read = read(Input.of(beside, PlainText.of(beside, in))).shapes();
      notes.add("The instance is read from " + file.get().getFileName());
      return flips.get().appliedTo(read);
    }
  }

  private String skipped(String before) throws IOException {
    scanner.json.skipValue();
    return before;
  }

  private void objects() throws IOException {
    scanner.json.beginArray();
    while (scanner.json.hasNext()) {
      object();
    }
    scanner.json.endArray();
  }

  /** The polygons to be packed of CG:SHOP 2024, or whatever else has this name. */
  private void items() throws IOException {
    if (scanner.json.peek() != JsonToken.BEGIN_ARRAY) {
      scanner.json.skipValue();
      return;
    }
    scanner.json.beginArray();
    while (scanner.json.hasNext()) {
      if (scanner.json.peek() == JsonToken.BEGIN_OBJECT) {
        object();
      } else {
        scanner.json.skipValue();
      }
    }
    scanner.json.endArray();
  }

  /** The first property that looks like a name, or else the first text. */
  private String properties(String before) throws IOException {
    if (scanner.json.peek() != JsonToken.BEGIN_OBJECT) {
      return skipped(before);
    }
    Map<String, String> texts = new HashMap<>();
    String first = before;
    scanner.json.beginObject();
    while (scanner.json.hasNext()) {
      String field = scanner.json.nextName();
      JsonToken value = scanner.json.peek();
      if (value == JsonToken.STRING || value == JsonToken.NUMBER) {
        String text = scanner.json.nextString();
        texts.put(field, text);
        first = first.isEmpty() && value == JsonToken.STRING ? text : first;
      } else {
        scanner.json.skipValue();
      }
    }
    scanner.json.endObject();
    return NAMES.stream().map(texts::get).filter(text -> text != null).findFirst().orElse(first);
  }

  private void label(int first, String name) {
    if (name.isEmpty()) {
      return;
    }
    for (int i = first; i < shapes.size(); i++) {
      Shape shape = shapes.get(i);
      if (shape.label().isEmpty()) {
        shapes.set(i, new Shape(shape.kind(), name, shape.points(), shape.lines(), shape.faces()));
      }
    }
  }

  private void add(List<Shape> found) {
    if (!found.isEmpty()) {
      format = CgShop.TITLE;
      shapes.addAll(found);
    }
  }

  private void rings(Shape.Kind kind, Nested nested) {
    nested.rings().forEach(ring -> shapes.add(Shape.of(kind, "", ring)));
  }

  private void geometry(String type, Nested coordinates) {
    beyond += coordinates.beyond;
    if (coordinates.rings().isEmpty()) {
      empty++;
      return;
    }
    int depth =
        switch (type) {
          case "Point" -> 1;
          case "MultiPoint", "LineString" -> 2;
          case "Polygon", "MultiLineString" -> 3;
          case "MultiPolygon" -> 4;
          default ->
              throw scanner.fault(
                  (type.isEmpty()
                          ? "the type of a geometry is missing"
                          : "\"" + Shown.word(type) + "\" is no type of a geometry with points")
                      + "; write \"type\": \"Polygon\"");
        };
    if (coordinates.depth != depth) {
      throw scanner.fault(
          "the coordinates of a " + type + " are not nested as they should be; see RFC 7946");
    }
    switch (type) {
      case "Point", "MultiPoint" -> rings(Shape.Kind.SITES, coordinates);
      case "LineString", "MultiLineString" ->
          coordinates.rings().forEach(line -> add(Shape.Kind.PATH, line));
      default -> coordinates.polygons.forEach(this::polygon);
    }
  }

  private void polygon(List<PointColumns> rings) {
    Shape.Kind kind = Shape.Kind.RING;
    for (PointColumns ring : rings) {
      if (ring.size() > 0) {
        add(kind, ring);
        kind = Shape.Kind.HOLE;
      }
    }
  }

  /** Adds a ring, or a line; GeoJSON repeats the first vertex of what is closed. */
  private void add(Shape.Kind kind, PointColumns columns) {
    boolean closed = columns.size() > 3 && columns.isClosed();
    if (closed) {
      columns.removeLast();
    }
    boolean isRing = closed && kind == Shape.Kind.PATH;
    shapes.add(Shape.of(isRing ? Shape.Kind.RING : kind, "", columns));
  }
}
