package dct.io.format.mesh;

import dct.core.geometry.Points;
import dct.io.format.CannotHold;
import dct.io.format.Drawing;
import dct.io.format.TextOut;
import java.io.IOException;

/**
 * Writes the formats of mesh programs: the vertices in the user's order with z = 0, then the
 * triangles, or a polygon that is not triangulated as one face.
 */
public final class MeshWriter {
  private MeshWriter() {}

  /** Writes the Object File Format of Geomview. */
  public static void writeOff(Drawing drawing, TextOut out) throws IOException {
    int[] triangles = triangles(drawing);
    boolean face = isFace(drawing);
    int n = drawing.points().size();
    out.add("OFF\n").add(n).add(" ").add(face ? 1 : triangles.length / 3).add(" 0\n");
    vertices(drawing.points(), "", out);
    if (face) {
      out.add(n);
      for (int v = 0; v < n; v++) {
        out.add(" ").add(v);
      }
      out.add("\n");
    }
    faces(triangles, "3", 0, out);
  }

  /** Writes Wavefront's format, which numbers vertices from 1 on. */
  public static void writeObj(Drawing drawing, TextOut out) throws IOException {
    vertices(drawing.points(), "v ", out);
    if (isFace(drawing)) {
      out.add("f");
      for (int v = 1; v <= drawing.points().size(); v++) {
        out.add(" ").add(v);
      }
      out.add("\n");
    }
    faces(triangles(drawing), "f", 1, out);
  }

  /** Whether there is a polygon that is not triangulated. */
  private static boolean isFace(Drawing drawing) throws CannotHold {
    if (drawing.rings().isPresent() && drawing.solution().isEmpty()) {
      throw new CannotHold(
          "it holds no region that is not triangulated; triangulate first, or choose .txt or .poly");
    }
    return drawing.isRing() && drawing.solution().isEmpty() && drawing.points().size() > 2;
  }

  private static int[] triangles(Drawing drawing) {
    return drawing.triangulation().map(made -> made.triangles()).orElse(new int[0]);
  }

  private static void vertices(Points points, String word, TextOut out) throws IOException {
    for (int v = 0; v < points.size(); v++) {
      out.tick(v, points.size());
      out.add(word).add(points.x(v)).add(" ").add(points.y(v)).add(" 0\n");
    }
  }

  private static void faces(int[] triangles, String word, int first, TextOut out)
      throws IOException {
    for (int t = 0; t < triangles.length; t += 3) {
      out.add(word);
      for (int corner = t; corner < t + 3; corner++) {
        out.add(" ").add(triangles[corner] + first);
      }
      out.add("\n");
    }
  }
}
