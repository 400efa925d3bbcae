package dct.io.format.wkt;

import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.io.format.Drawing;
import dct.io.format.TextOut;
import java.io.IOException;
import java.util.Optional;

/**
 * Writes points as Well-Known Text: a ring as POLYGON, with the holes of a region, sites as
 * MULTIPOINT.
 */
public final class WktWriter {
  private WktWriter() {}

  /**
   * Writes the points; a triangulation is left out.
   *
   * @throws dct.io.format.CannotHold if there are sites or fixed edges in a region
   */
  public static void write(Drawing drawing, TextOut out) throws IOException {
    drawing.requireRingsAlone();
    Points points = drawing.points();
    Optional<Rings> outline = drawing.outline();
    if (points.size() == 0) {
      out.add(outline.isPresent() ? "POLYGON EMPTY\n" : "MULTIPOINT EMPTY\n");
    } else if (outline.isPresent()) {
      rings(outline.get(), out);
    } else {
      sites(points, out);
    }
  }

  private static void rings(Rings rings, TextOut out) throws IOException {
    out.add("POLYGON (");
    int written = 0;
    for (int r = 0; r < rings.count(); r++) {
      out.add(r == 0 ? "(" : ", (");
      for (int k = 0; k < rings.size(r); k++) {
        out.tick(written++, rings.ringVertices());
        point(rings.points(), rings.vertex(r, k), out.add(k == 0 ? "" : ", "));
      }
      point(rings.points(), rings.vertex(r, 0), out.add(", ")); // WKT repeats it
      out.add(")");
    }
    out.add(")\n");
  }

  private static void sites(Points points, TextOut out) throws IOException {
    out.add("MULTIPOINT (");
    for (int v = 0; v < points.size(); v++) {
      out.tick(v, points.size());
      point(points, v, out.add(v == 0 ? "(" : ", ("));
      out.add(")");
    }
    out.add(")\n");
  }

  private static void point(Points points, int v, TextOut out) throws IOException {
    out.add(points.x(v)).add(" ").add(points.y(v));
  }
}
