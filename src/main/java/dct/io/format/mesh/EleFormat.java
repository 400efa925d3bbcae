package dct.io.format.mesh;

import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.Rows;
import dct.io.format.Shapes;
import dct.io.format.TriangleList;
import dct.io.format.Triangulated;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/**
 * Triangles of Shewchuk's Triangle ({@code .ele}); their vertices stand beside them in a file of
 * the same name that ends in {@code .node} or {@code .poly}.
 */
public final class EleFormat implements Format {
  private static final Pattern COUNTS = Pattern.compile("[0-9]+\\s+[36]\\s+[0-9]+");
  private static final Pattern TRIANGLE = Pattern.compile("[01](\\s+[0-9]+){3}(\\s.*)?");
  private static final String CURE = "correct the triangle";

  @Override
  public String title() {
    return "Triangle";
  }

  @Override
  public boolean fits(Head head) {
    return Rows.startsWith(head, COUNTS, TRIANGLE);
  }

  @Override
  public Shapes read(Input input) throws IOException {
    Rows rows = new Rows(input);
    rows.next(0, 1, "counts");
    int count = rows.count(0);
    if (rows.count(1) != 3) {
      throw rows.fault("the triangles have 6 nodes each; make them anew without the option -o2");
    }
    List<String> notes = new ArrayList<>();
    if (rows.count(2) > 0) {
      notes.add("Attributes of the triangles are left out");
    }
    NodeList nodes = NodeFile.read(input, "triangles", rows, notes);
    TriangleList triangles = new TriangleList();
    rows.rest(
        count,
        "triangle",
        () ->
            triangles.add(
                nodes.vertex(rows, 1, CURE),
                nodes.vertex(rows, 2, CURE),
                nodes.vertex(rows, 3, CURE),
                rows.line()));
    return new Shapes(title(), List.of(Triangulated.shape("", nodes.points(), triangles)), notes);
  }
}
