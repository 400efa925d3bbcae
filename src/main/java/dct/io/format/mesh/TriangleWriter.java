package dct.io.format.mesh;

import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.io.format.CannotHold;
import dct.io.format.Drawing;
import dct.io.format.TextOut;
import java.io.IOException;

/** Writes the files of Shewchuk's Triangle; vertices are numbered from 0 on. */
public final class TriangleWriter {
  private static final String UNTRIANGULATED =
      "it holds a triangulation, and there is none; triangulate first, or choose .node or .poly";

  private TriangleWriter() {}

  /** Writes the vertices: {@code .node}. */
  public static void writeNode(Drawing drawing, TextOut out) throws IOException {
    Points points = drawing.points();
    out.add(points.size()).add(" 2 0 0\n");
    for (int v = 0; v < points.size(); v++) {
      out.tick(v, points.size());
      out.add(v).add(" ").add(points.x(v)).add(" ").add(points.y(v)).add("\n");
    }
  }

  /**
   * Writes the vertices and, of a polygon or a region, its edges: {@code .poly}.
   *
   * @throws CannotHold if a hole is no simple polygon, or too small to place a point in it
   */
  public static void writePoly(Drawing drawing, TextOut out) throws IOException {
    if (drawing.rings().isPresent()) {
      writePoly(drawing, drawing.rings().get(), out);
      return;
    }
    writeNode(drawing, out);
    int n = drawing.isRing() ? drawing.points().size() : 0;
    out.add(n).add(" 0\n");
    for (int v = 0; v < n; v++) {
      out.add(v).add(" ").add(v).add(" ").add(v + 1 == n ? 0 : v + 1).add("\n");
    }
    out.add("0\n"); // holes
  }

  /**
   * The segments of a region, those of rings marked by 1 and the fixed ones by 0, and a point in
   * each hole.
   */
  private static void writePoly(Drawing drawing, Rings rings, TextOut out) throws IOException {
    Points holes = HolePoints.of(rings);
    writeNode(drawing, out);
    out.add(rings.ringVertices() + rings.fixedCount()).add(" 1\n");
    int s = 0;
    for (int r = 0; r < rings.count(); r++) {
      for (int k = 0; k < rings.size(r); k++) {
        int v = rings.vertex(r, k);
        out.add(s++).add(" ").add(v).add(" ").add(rings.after(v)).add(" 1\n");
      }
    }
    for (int j = 0; j < rings.fixedCount(); j++) {
      out.add(s++).add(" ").add(rings.fixedFrom(j)).add(" ").add(rings.fixedTo(j)).add(" 0\n");
    }
    out.add(holes.size()).add("\n");
    for (int h = 0; h < holes.size(); h++) {
      out.add(h).add(" ").add(holes.x(h)).add(" ").add(holes.y(h)).add("\n");
    }
  }

  /**
   * Writes the triangles: {@code .ele}.
   *
   * @throws CannotHold if there are none
   */
  public static void writeEle(Drawing drawing, TextOut out) throws IOException {
    int[] triangles = triangulation(drawing).triangles();
    out.add(triangles.length / 3).add(" 3 0\n");
    for (int t = 0; t < triangles.length; t += 3) {
      out.add(t / 3).add(" ").add(triangles[t]).add(" ").add(triangles[t + 1]);
      out.add(" ").add(triangles[t + 2]).add("\n");
    }
  }

  /**
   * Writes the edges, those of the boundary marked by 1: {@code .edge}.
   *
   * @throws CannotHold if there is no triangulation
   */
  public static void writeEdge(Drawing drawing, TextOut out) throws IOException {
    Triangulation made = triangulation(drawing);
    out.add(made.edgeCount()).add(" 1\n");
    for (int e = 0; e < made.edgeCount(); e++) {
      out.add(e).add(" ").add(made.from(e)).add(" ").add(made.to(e));
      out.add(made.kind(e) == EdgeKind.BOUNDARY ? " 1\n" : " 0\n");
    }
  }

  private static Triangulation triangulation(Drawing drawing) throws CannotHold {
    return drawing.triangulation().orElseThrow(() -> new CannotHold(UNTRIANGULATED));
  }
}
