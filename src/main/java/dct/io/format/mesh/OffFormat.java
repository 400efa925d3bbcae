package dct.io.format.mesh;

import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.Rows;
import dct.io.format.Shapes;
import java.io.IOException;
import java.util.List;
import java.util.regex.Pattern;

/** Geomview's Object File Format in the plane, also with colours, normals or textures. */
public final class OffFormat implements Format {
  private static final Pattern HEADER = Pattern.compile("(ST)?C?N?OFF(\\s.*)?");

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
    boolean onOneLine = rows.words().size() > 1;
    String header = rows.words().get(0);
    if (!onOneLine) {
      rows.next(0, 1, "lines of counts");
    }
    int word = onOneLine ? 1 : 0;
    int vertices = rows.count(word);
    int faces = rows.count(word + 1);
    if (vertices == 0) {
      throw rows.fault("there is no vertex in the file; choose another");
    }
    Mesh mesh = new Mesh();
    while (mesh.size() < vertices) {
      rows.next(mesh.size(), vertices, "vertices");
      mesh.vertex(rows, 0);
    }
    for (int f = 0; f < faces; f++) {
      rows.next(f, faces, "faces");
      mesh.face(face(rows, vertices), rows.line());
    }
    if (rows.next()) {
      throw rows.fault("the file goes on behind its last face; correct the counts");
    }
    if (!header.equals("OFF")) {
      mesh.note("What " + header + " holds behind x, y and z is left out");
    }
    return mesh.shapes(title());
  }

  private static int[] face(Rows rows, int vertices) {
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
                + ", they are numbered from 0 to "
                + (vertices - 1)
                + "; correct the face");
      }
    }
    return corners;
  }
}
