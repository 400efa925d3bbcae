package dct.io.format.mesh;

import dct.core.triangulate.EdgeKind;
import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.Rim;
import dct.io.format.Rows;
import dct.io.format.Shapes;
import dct.io.format.StoredFaces;
import dct.io.format.Triangulated;
import dct.problem.verify.ClaimedEdges;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/**
 * Edges of Shewchuk's Triangle ({@code .edge}), those of the rim marked; their vertices stand
 * beside them in a file of the same name that ends in {@code .node} or {@code .poly}.
 */
public final class EdgeFormat implements Format {
  private static final Pattern UNMARKED = Pattern.compile("0*[1-9][0-9]*\\s+0");
  private static final Pattern EDGE = Pattern.compile("[01]\\s+[0-9]+\\s+[0-9]+");
  private static final Pattern MARKED = Pattern.compile("0*[1-9][0-9]*\\s+1");
  private static final Pattern MARKED_EDGE = Pattern.compile(EDGE + "\\s+-?[0-9]+");
  private static final String CURE = "correct the edge";

  @Override
  public String title() {
    return "Triangle";
  }

  @Override
  public boolean fits(Head head) {
    return Rows.startsWith(head, UNMARKED, EDGE) || Rows.startsWith(head, MARKED, MARKED_EDGE);
  }

  @Override
  public Shapes read(Input input) throws IOException {
    Rows rows = new Rows(input);
    rows.next(0, 1, "counts");
    int count = rows.count(0);
    boolean marked = rows.count(1) > 0;
    List<String> notes = new ArrayList<>();
    NodeList nodes = NodeFile.read(input, "edges", rows, notes);
    ClaimedEdges edges = new ClaimedEdges();
    Rim rim = new Rim(nodes.points().size());
    rows.rest(
        count,
        "edge",
        () -> {
          int u = nodes.vertex(rows, 1, CURE);
          int v = nodes.vertex(rows, 2, CURE);
          edges.add(u, v, EdgeKind.DIAGONAL, rows.line());
          if (marked && rows.whole(3) != 0) {
            rim.add(u, v);
          }
        });
    StoredFaces faces = StoredFaces.of(edges, rim);
    return new Shapes(title(), List.of(Triangulated.shape("", nodes.points(), faces)), notes);
  }
}
