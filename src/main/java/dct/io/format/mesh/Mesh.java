package dct.io.format.mesh;

import dct.core.geometry.Points;
import dct.io.format.PointColumns;
import dct.io.format.Rows;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import dct.io.format.TriangleList;
import dct.io.format.Triangulated;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The vertices and faces of a mesh as they are read: one face alone is a ring, polylines are paths,
 * and of several faces the vertices are taken as sites, or as a polygon if the faces are triangles
 * that make one.
 */
final class Mesh {
  private final PointColumns vertices = new PointColumns();
  private final List<int[]> paths = new ArrayList<>();
  private final List<String> notes = new ArrayList<>();
  private int[] face = new int[0]; // the first one
  private int faces;
  private final TriangleList triangles = new TriangleList();
  private int segments; // polylines of two vertices
  private double height; // of the first vertex
  private boolean isUneven;

  int size() {
    return vertices.size();
  }

  /** Adds the vertex whose x stands in this word of the row. */
  void vertex(Rows rows, int word) {
    vertex(rows, word, 3);
  }

  /** The same of a vertex that has so many coordinates, 2 or 3. */
  void vertex(Rows rows, int word, int dimension) {
    boolean hasHeight = dimension > 2 && rows.words().size() > word + 2;
    add(
        rows.number(word),
        rows.number(word + 1),
        hasHeight ? rows.number(word + 2) : 0,
        rows.line());
  }

  /** Adds a vertex. */
  void add(double x, double y, double z, int line) {
    if (size() == 0) {
      height = z;
    }
    isUneven |= z != height;
    vertices.add(x, y, line);
  }

  void face(int[] corners, int line) {
    if (faces++ == 0) {
      face = corners;
    }
    if (corners.length == 3) {
      triangles.add(corners[0], corners[1], corners[2], line);
    }
  }

  void polyline(int[] corners) {
    if (corners.length > 2) {
      paths.add(corners);
    } else {
      segments++;
    }
  }

  void note(String note) {
    notes.add(note);
  }

  /**
   * What there is, all lists of vertices checked to be in range.
   *
   * @param rows the rows of the file, at the last that was to be read
   * @throws dct.io.text.BadInputException if it goes on, or has no vertex
   */
  Shapes shapes(String title, Rows rows) throws IOException {
    rows.end("the last line that its counts announce", "counts");
    if (size() == 0) {
      throw rows.fault("there is no vertex in the file; choose another");
    }
    if (isUneven) {
      notes.add("z differs from vertex to vertex and is left out");
    }
    if (segments > 0) {
      notes.add(segments == 1 ? "1 segment is left out" : segments + " segments are left out");
    }
    return new Shapes(title, kept(), notes);
  }

  private List<Shape> kept() {
    if (!paths.isEmpty()) {
      if (faces > 0) {
        notes.add(faces == 1 ? "1 face is left out" : faces + " faces are left out");
      }
      Points points = vertices.points();
      int[] lines = vertices.lines();
      return paths.stream()
          .map(path -> Shape.of(Shape.Kind.PATH, "", along(path, points, lines)))
          .toList();
    }
    if (faces == 1) {
      int unused = size() - (int) Arrays.stream(face).distinct().count();
      if (unused > 0) {
        notes.add(
            unused == 1
                ? "1 vertex is no corner of the face and is left out"
                : unused + " vertices are no corners of the face and are left out");
      }
      return List.of(
          Shape.of(Shape.Kind.RING, "", along(face, vertices.points(), vertices.lines())));
    }
    if (faces > 1 && triangles.size() == faces && !isUneven) {
      return List.of(Triangulated.shape("", vertices, triangles));
    }
    if (faces > 1) {
      String which = triangles.size() < faces ? ", not all of them triangles," : "";
      notes.add(faces + " faces" + which + " are left out, their vertices are read as sites");
      return List.of(Shape.of(Shape.Kind.SITES, "", vertices));
    }
    return List.of(Shape.of(Shape.Kind.POINTS, "", vertices));
  }

  private static PointColumns along(int[] corners, Points points, int[] lines) {
    PointColumns ring = new PointColumns();
    for (int v : corners) {
      ring.add(points.x(v), points.y(v), lines[v]);
    }
    return ring;
  }
}
