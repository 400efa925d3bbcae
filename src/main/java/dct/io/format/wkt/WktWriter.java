package dct.io.format.wkt;

import dct.core.geometry.Points;
import dct.io.format.Drawing;
import dct.io.format.TextOut;
import java.io.IOException;

/** Writes points as Well-Known Text: a ring as POLYGON, sites as MULTIPOINT. */
public final class WktWriter {
  private WktWriter() {}

  /** Writes the points; a triangulation is left out. */
  public static void write(Drawing drawing, TextOut out) throws IOException {
    Points points = drawing.points();
    if (points.size() == 0) {
      out.add(drawing.isRing() ? "POLYGON EMPTY\n" : "MULTIPOINT EMPTY\n");
      return;
    }
    out.add(drawing.isRing() ? "POLYGON ((" : "MULTIPOINT (");
    for (int v = 0; v < points.size(); v++) {
      out.tick(v, points.size());
      out.add(v == 0 ? "" : ", ").add(drawing.isRing() ? "" : "(");
      point(points, v, out);
      out.add(drawing.isRing() ? "" : ")");
    }
    if (drawing.isRing()) {
      out.add(", ");
      point(points, 0, out); // WKT repeats it
    }
    out.add(drawing.isRing() ? "))\n" : ")\n");
  }

  private static void point(Points points, int v, TextOut out) throws IOException {
    out.add(points.x(v)).add(" ").add(points.y(v));
  }
}
