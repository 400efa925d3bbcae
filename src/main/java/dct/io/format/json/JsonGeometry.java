package dct.io.format.json;

import com.google.gson.stream.JsonToken;
import dct.core.geometry.Points;
import dct.io.format.Input;
import dct.io.format.PointColumns;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Reads shapes of JSON: of a geometry, feature or collection of GeoJSON, an instance of CG:SHOP, or
 * plain arrays. Unknown fields are skipped.
 */
final class JsonGeometry {
  private static final List<String> NAMES =
      List.of("name", "NAME", "Name", "title", "id", "ID", "label");

  private final JsonScanner scanner;
  private final List<Shape> shapes = new ArrayList<>();
  private String format = "GeoJSON";
  private int beyond; // numbers behind x and y
  private int empty; // geometries without points
  private int left; // triangulations of an instance

  private JsonGeometry(Input input) {
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
    List<String> notes = new ArrayList<>();
    if (beyond > 0) {
      notes.add("Numbers behind x and y are left out");
    }
    if (empty > 0) {
      notes.add(empty + (empty == 1 ? " geometry" : " geometries") + " without points left out");
    }
    if (left > 0) {
      notes.add(left + (left == 1 ? " triangulation is" : " triangulations are") + " left out");
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
    beyond += nested.beyond;
    for (PointColumns ring : nested.rings()) {
      shapes.add(Shape.of(Shape.Kind.POINTS, "", ring));
    }
  }

  /** One object: the fields may come in any order, so the type may follow what it is of. */
  private void object() throws IOException {
    Map<String, Nested> nested = new HashMap<>();
    Map<String, double[]> lists = new HashMap<>();
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
        case "name", "instance_uid", "id" ->
            name = isText || value == JsonToken.NUMBER ? scanner.json.nextString() : skipped(name);
        case "coordinates", "points", "outer_boundary", "holes", "triangulations" -> {
          if (isArray) {
            nested.put(field, scanner.nested());
          } else {
            scanner.json.skipValue();
          }
        }
        case "points_x", "points_y", "region_boundary" -> lists.put(field, scanner.numbers());
        case "geometry" -> {
          if (value == JsonToken.BEGIN_OBJECT) {
            object();
          } else {
            scanner.json.skipValue();
            empty++;
          }
        }
        case "geometries", "features" -> objects();
        case "properties" -> name = properties(name);
        default -> scanner.json.skipValue();
      }
    }
    scanner.json.endObject();
    add(type, nested, lists);
    label(first, name);
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

  private void add(String type, Map<String, Nested> nested, Map<String, double[]> lists) {
    if (lists.containsKey("points_x") && lists.containsKey("points_y")) {
      format = "CG:SHOP";
      challenge(lists, Optional.ofNullable(nested.get("triangulations")));
    } else if (nested.containsKey("outer_boundary")) {
      format = "CG:SHOP";
      rings(Shape.Kind.RING, nested.get("outer_boundary"));
      Optional.ofNullable(nested.get("holes")).ifPresent(h -> rings(Shape.Kind.HOLE, h));
    } else if (nested.containsKey("points")) {
      format = "CG:SHOP";
      rings(Shape.Kind.SITES, nested.get("points"));
    } else if (nested.containsKey("coordinates")) {
      geometry(type, nested.get("coordinates"));
    } else if (type.startsWith("CG")) {
      format = "solution of CG:SHOP";
    }
  }

  private void rings(Shape.Kind kind, Nested nested) {
    nested.rings().forEach(ring -> shapes.add(Shape.of(kind, "", ring)));
  }

  private void challenge(Map<String, double[]> lists, Optional<Nested> triangulations) {
    PointColumns all = scanner.columns(lists.get("points_x"), lists.get("points_y"));
    Points points = all.points();
    int[] lines = all.lines();
    PointColumns ring = new PointColumns();
    for (double index : lists.getOrDefault("region_boundary", new double[0])) {
      int v = vertex(index, all.size());
      ring.add(points.x(v), points.y(v), lines[v]);
    }
    if (ring.size() > 0) {
      shapes.add(Shape.of(Shape.Kind.RING, "region", ring));
    }
    shapes.add(Shape.of(Shape.Kind.SITES, ring.size() > 0 ? "all points" : "", all));
    left += triangulations.map(list -> list.rings().size()).orElse(0);
  }

  private int vertex(double index, int vertices) {
    if (index != (int) index || index < 0 || index >= vertices) {
      throw scanner.fault(
          "there is no point with the number " + (long) index + "; they count from 0 on");
    }
    return (int) index;
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
              throw scanner.fault("the type of a geometry is missing; write \"type\": \"Polygon\"");
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
