package dct.io.format.mesh;

import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.Rows;
import dct.io.format.Shapes;
import java.io.IOException;
import java.util.Set;
import java.util.regex.Pattern;

/** Wavefront's format in the plane: vertices, faces, and polylines. */
public final class ObjFormat implements Format {
  private static final Pattern VERTEX = Pattern.compile("v\\s+[-+.0-9].*");
  private static final Pattern BEFORE = Pattern.compile("(mtllib|usemtl|o|g|s|vn|vt)(\\s.*)?");
  private static final Set<String> KNOWN = Set.of("mtllib", "usemtl", "o", "g", "s", "vn", "vt");

  @Override
  public String title() {
    return "OBJ";
  }

  @Override
  public boolean fits(Head head) {
    return Rows.of(head)
        .dropWhile(line -> BEFORE.matcher(line).matches())
        .findFirst()
        .filter(line -> VERTEX.matcher(line).matches())
        .isPresent();
  }

  @Override
  public Shapes read(Input input) throws IOException {
    Rows rows = new Rows(input);
    Mesh mesh = new Mesh();
    int unknown = 0;
    while (rows.next()) {
      String keyword = rows.words().get(0);
      switch (keyword) {
        case "v" -> mesh.vertex(rows, 1);
        case "f" -> mesh.face(corners(rows, mesh.size(), 3), rows.line());
        case "l" -> mesh.polyline(corners(rows, mesh.size(), 2));
        default -> unknown += KNOWN.contains(keyword) ? 0 : 1;
      }
    }
    if (unknown > 0) {
      mesh.note(
          unknown == 1
              ? "1 line that is no v, f or l is left out"
              : unknown + " lines that are no v, f or l are left out");
    }
    return mesh.shapes(title(), rows);
  }

  private static int[] corners(Rows rows, int vertices, int least) {
    int size = rows.words().size() - 1;
    if (size < least) {
      throw rows.fault("there are only " + size + " corners; correct or remove the line");
    }
    int[] corners = new int[size];
    for (int i = 0; i < size; i++) {
      String word = rows.words().get(i + 1);
      int slash = word.indexOf('/');
      int number = rows.whole(slash < 0 ? word : word.substring(0, slash));
      corners[i] = number < 0 ? vertices + number : number - 1;
      if (corners[i] < 0 || corners[i] >= vertices) {
        throw rows.fault(
            "there is no vertex "
                + number
                + ", "
                + vertices
                + " stand before this line, numbered from 1 on; correct the line");
      }
    }
    return corners;
  }
}
