package dct.io.format.json;

import dct.core.geometry.Points;
import dct.io.format.Drawing;
import dct.io.format.TextOut;
import java.io.IOException;

/**
 * Writes points as a geometry of GeoJSON: a ring as Polygon, sites as MultiPoint. The ring goes
 * counter-clockwise or clockwise as the vertices do.
 */
public final class GeoJsonWriter {
  private GeoJsonWriter() {}

  /** Writes the points; a triangulation is left out. */
  public static void write(Drawing drawing, TextOut out) throws IOException {
    Points points = drawing.points();
    out.add(drawing.isRing() ? "{\"type\": \"Polygon\", " : "{\"type\": \"MultiPoint\", ");
    out.add("\"coordinates\": [").add(drawing.isRing() && points.size() > 0 ? "[" : "");
    for (int v = 0; v < points.size(); v++) {
      out.tick(v, points.size());
      out.add(v == 0 ? "\n" : ",\n");
      point(points, v, out);
    }
    if (drawing.isRing() && points.size() > 0) {
      out.add(",\n");
      point(points, 0, out); // GeoJSON repeats it
      out.add("]");
    }
    out.add("]}\n");
  }

  private static void point(Points points, int v, TextOut out) throws IOException {
    out.add("[").add(points.x(v)).add(", ").add(points.y(v)).add("]");
  }
}
