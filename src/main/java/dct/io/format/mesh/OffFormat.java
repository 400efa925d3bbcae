package dct.io.format.mesh;

import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.Rows;
import dct.io.format.Shapes;
import java.io.IOException;
import java.util.List;
import java.util.regex.Pattern;

/**
 * Geomview's Object File Format in the plane, also with colours, normals or textures, with a fourth
 * coordinate by which the others are divided, or with a dimension of its own.
 */
public final class OffFormat implements Format {
  private static final Pattern HEADER = Pattern.compile("(ST)?C?N?4?n?OFF(\\s.*)?");

  private static final int PLANE = 2;
  private static final int SPACE = 3;

  @Override
  public String title() {
    return "OFF";
  }

  @Override
  public boolean fits(Head head) {
    return Rows.startsWith(head, HEADER);
  }

  @Override
  public Shapes read(Input input) throws IOException {
    Rows rows = new Rows(input);
    rows.next(0, 1, "lines of counts");
    String header = rows.words().get(0);
    int word = nextNumber(rows, 0);
    int dimension = SPACE;
    if (header.endsWith("nOFF")) {
      dimension = dimension(rows, word);
      word = nextNumber(rows, word);
    }
    int vertices = rows.count(word);
    int faces = rows.count(word + 1);
    Mesh mesh = new Mesh();
    while (mesh.size() < vertices) {
      rows.next(mesh.size(), vertices, "vertices");
      if (header.contains("4") && rows.number(dimension) != 1) {
        throw rows.fault(
            "the coordinate behind x, y and z is not 1; divide the others by it and write OFF");
      }
      mesh.vertex(rows, 0, dimension);
    }
    for (int f = 0; f < faces; f++) {
      rows.next(f, faces, "faces");
      mesh.face(face(rows, vertices), rows.line());
    }
    if (!header.matches("4?n?OFF")) {
      mesh.note("What " + header + " holds behind the coordinates is left out");
    }
    return mesh.shapes(title(), rows);
  }

  /** The place of the next number, in this row or at the start of the next one. */
  private static int nextNumber(Rows rows, int word) throws IOException {
    if (word + 1 < rows.words().size()) {
      return word + 1;
    }
    rows.next(0, 1, "lines of counts");
    return 0;
  }

  private static int dimension(Rows rows, int word) {
    int dimension = rows.count(word);
    if (dimension != PLANE && dimension != SPACE) {
      throw rows.fault(
          "the vertices have " + dimension + " coordinates; write two or three, x y or x y z");
    }
    return dimension;
  }

  /** The corners of a face, behind their number. */
  static int[] face(Rows rows, int vertices) {
    int size = rows.count(0);
    List<String> words = rows.words();
    if (size >= words.size()) {
      throw rows.fault(
          "the face has " + (words.size() - 1) + " corners, not " + size + "; correct the line");
    }
    int[] corners = new int[size];
    for (int i = 0; i < size; i++) {
      corners[i] = rows.whole(i + 1);
      if (corners[i] < 0 || corners[i] >= vertices) {
        throw rows.fault(
            "there is no vertex "
                + corners[i]
                + ", there are "
                + vertices
                + ", numbered from 0 on; correct the face");
      }
    }
    return corners;
  }
}
