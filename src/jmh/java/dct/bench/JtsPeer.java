package dct.bench;

import java.util.ArrayList;
import java.util.List;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.triangulate.DelaunayTriangulationBuilder;
import org.locationtech.jts.triangulate.polygon.PolygonTriangulator;
import org.locationtech.jts.triangulate.quadedge.Vertex;

/** JTS: its incremental Delaunay triangulation and its ear clipping. */
final class JtsPeer {
  private JtsPeer() {}

  static int[] sites(double[] x, double[] y) {
    List<Coordinate> coordinates = new ArrayList<>(x.length);
    for (int i = 0; i < x.length; i++) {
      coordinates.add(new Coordinate(x[i], y[i], i)); // the number travels as z
    }
    DelaunayTriangulationBuilder builder = new DelaunayTriangulationBuilder();
    builder.setSites(coordinates);
    TriangleList triangles = new TriangleList(2 * x.length);
    for (Object triangle : builder.getSubdivision().getTriangleVertices(false)) {
      Vertex[] corner = (Vertex[]) triangle;
      triangles.add(index(corner[0]), index(corner[1]), index(corner[2]));
    }
    return triangles.toArray();
  }

  private static int index(Vertex vertex) {
    return (int) vertex.getZ();
  }

  static int[] polygon(double[] x, double[] y) {
    Coordinate[] ring = new Coordinate[x.length + 1];
    for (int i = 0; i <= x.length; i++) {
      ring[i] = new Coordinate(x[i % x.length], y[i % x.length], i % x.length);
    }
    Geometry parts = PolygonTriangulator.triangulate(new GeometryFactory().createPolygon(ring));
    TriangleList triangles = new TriangleList(x.length);
    for (int i = 0; i < parts.getNumGeometries(); i++) {
      Coordinate[] corner = parts.getGeometryN(i).getCoordinates();
      triangles.add((int) corner[0].getZ(), (int) corner[1].getZ(), (int) corner[2].getZ());
    }
    return triangles.toArray();
  }
}
