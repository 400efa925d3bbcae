package dct.io.format.json;

import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.io.format.Drawing;
import dct.io.format.TextOut;
import java.io.IOException;
import java.util.Optional;

/**
 * Writes points as a geometry of GeoJSON: a ring as Polygon, with the holes of a region, sites as
 * MultiPoint. Rings go counter-clockwise or clockwise as the vertices do.
 */
public final class GeoJsonWriter {
  private GeoJsonWriter() {}

  /**
   * Writes the points; a triangulation is left out.
   *
   * @throws dct.io.format.CannotHold if there are sites or fixed edges in a region
   */
  public static void write(Drawing drawing, TextOut out) throws IOException {
    drawing.requireRingsAlone();
    Points points = drawing.points();
    Optional<Rings> outline = drawing.outline();
    out.add("{\"type\": \"").add(outline.isPresent() ? "Polygon" : "MultiPoint");
    out.add("\", \"coordinates\": [");
    if (outline.isEmpty()) {
      for (int v = 0; v < points.size(); v++) {
        out.tick(v, points.size());
        point(points, v, out.add(v == 0 ? "\n" : ",\n"));
      }
    } else if (points.size() > 0) {
      rings(outline.get(), out);
    }
    out.add("]}\n");
  }

  private static void rings(Rings rings, TextOut out) throws IOException {
    int written = 0;
    for (int r = 0; r < rings.count(); r++) {
      out.add(r == 0 ? "[" : ",\n[");
      for (int k = 0; k < rings.size(r); k++) {
        out.tick(written++, rings.ringVertices());
        point(rings.points(), rings.vertex(r, k), out.add(k == 0 ? "\n" : ",\n"));
      }
      point(rings.points(), rings.vertex(r, 0), out.add(",\n")); // GeoJSON repeats it
      out.add("]");
    }
  }

  private static void point(Points points, int v, TextOut out) throws IOException {
    out.add("[").add(points.x(v)).add(", ").add(points.y(v)).add("]");
  }
}
