package dct.io.format.json;

import com.google.gson.stream.JsonToken;
import dct.core.geometry.Points;
import dct.io.format.PointColumns;
import dct.io.format.Shape;
import dct.io.format.TriangleList;
import dct.io.format.Triangulated;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * An object with a list of vertices: that of earcut, {@code {"vertices": [x, y, x, y, …], "holes":
 * [first vertex of each], "dimensions": 2}}, or one with {@code "triangles"} that number vertices
 * from 0 on.
 */
final class VertexLists {
  private final JsonScanner scanner;
  private Optional<Nested> vertices = Optional.empty();
  private Optional<Nested> holes = Optional.empty();
  private int dimensions = 2;
  private int line; // where the vertices end
  private final List<double[]> corners = new ArrayList<>(); // of each triangle
  private final List<Integer> lines = new ArrayList<>(); // of each triangle

  VertexLists(JsonScanner scanner) {
    this.scanner = scanner;
  }

  /** Reads the value of a field if it is one of these; says whether it was. */
  boolean read(String field) throws IOException {
    JsonToken value = scanner.json.peek();
    boolean isArray = value == JsonToken.BEGIN_ARRAY;
    if (isArray && field.equals("vertices")) {
      vertices = scanner.nestedOrNumbers();
      line = scanner.line();
    } else if (isArray && field.equals("holes")) {
      holes = scanner.nestedOrNumbers();
    } else if (isArray && field.equals("triangles")) {
      triangles();
    } else if (value == JsonToken.NUMBER && field.equals("dimensions")) {
      dimensions = whole(scanner.number());
    } else {
      return false;
    }
    return true;
  }

  private void triangles() throws IOException {
    if (!scanner.begin()) {
      return;
    }
    while (scanner.json.hasNext()) {
      if (scanner.json.peek() == JsonToken.BEGIN_ARRAY) {
        add(scanner.numbers());
      } else {
        double a = scanner.number();
        double b = scanner.json.hasNext() ? scanner.number() : Double.NaN;
        add(new double[] {a, b, scanner.json.hasNext() ? scanner.number() : Double.NaN});
      }
    }
    scanner.json.endArray();
  }

  private void add(double[] triangle) {
    if (triangle.length != 3 || Double.isNaN(triangle[2])) {
      throw scanner.fault("a triangle has not three corners; write [u, v, w]");
    }
    corners.add(triangle);
    lines.add(scanner.line());
  }

  private int whole(double number) {
    if (number != (int) number) {
      throw scanner.fault(number + " is no whole number; correct it");
    }
    return (int) number;
  }

  /** Whether there is a list of vertices. */
  boolean isPresent() {
    return vertices.isPresent();
  }

  /** The list of holes, if there is one. */
  Optional<Nested> holes() {
    return holes;
  }

  /**
   * What there is.
   *
   * @param notes hears what is left out
   */
  List<Shape> shapes(List<String> notes) {
    PointColumns all = points(notes);
    if (all.size() == 0) {
      return List.of();
    }
    double[] starts = holes.map(found -> found.numbers).orElse(new double[0]);
    if (!corners.isEmpty() && starts.length == 0) {
      return List.of(Triangulated.shape("", all, triangles(all.size())));
    }
    if (holes.isEmpty()) {
      return List.of(Shape.of(Shape.Kind.POINTS, "", all));
    }
    return rings(all, starts);
  }

  private PointColumns points(List<String> notes) {
    Nested list = vertices.orElseThrow();
    double[] numbers = list.numbers;
    if (numbers.length == 0) {
      noteBeyond(list.beyond, notes);
      return list.rings().isEmpty() ? new PointColumns() : list.rings().get(0);
    }
    if (dimensions < 2 || numbers.length % dimensions != 0) {
      throw scanner.fault(
          "there are "
              + numbers.length
              + " numbers, which are no vertices of "
              + dimensions
              + " dimensions; give x and y of each");
    }
    noteBeyond(dimensions - 2, notes);
    PointColumns points = new PointColumns();
    for (int i = 0; i < numbers.length; i += dimensions) {
      points.add(numbers[i], numbers[i + 1], line);
    }
    return points;
  }

  private static void noteBeyond(int beyond, List<String> notes) {
    if (beyond > 0) {
      notes.add("Numbers behind x and y are left out");
    }
  }

  private TriangleList triangles(int vertices) {
    TriangleList triangles = new TriangleList();
    for (int t = 0; t < corners.size(); t++) {
      double[] triangle = corners.get(t);
      for (double corner : triangle) {
        if (whole(corner) < 0 || corner >= vertices) {
          throw scanner.fault(
              lines.get(t),
              "there is no vertex "
                  + (int) corner
                  + ", they count from 0 to "
                  + (vertices - 1)
                  + "; correct the triangle");
        }
      }
      triangles.add((int) triangle[0], (int) triangle[1], (int) triangle[2], lines.get(t));
    }
    return triangles;
  }

  /** The outer ring and the holes, each up to where the next begins. */
  private List<Shape> rings(PointColumns all, double[] starts) {
    Points points = all.points();
    List<Shape> rings = new ArrayList<>();
    int from = 0;
    for (int hole = 0; hole <= starts.length; hole++) {
      int to = hole == starts.length ? all.size() : whole(starts[hole]);
      if (to <= from || to > all.size()) {
        throw scanner.fault(
            "the holes do not begin at increasing numbers from 1 to "
                + (all.size() - 1)
                + "; correct \"holes\"");
      }
      PointColumns ring = new PointColumns();
      for (int v = from; v < to; v++) {
        ring.add(points.x(v), points.y(v), line);
      }
      rings.add(Shape.of(hole == 0 ? Shape.Kind.RING : Shape.Kind.HOLE, "", ring));
      from = to;
    }
    return rings;
  }
}
