package dct.bench;

import org.poly2tri.Poly2Tri;
import org.poly2tri.geometry.polygon.Polygon;
import org.poly2tri.geometry.polygon.PolygonPoint;
import org.poly2tri.triangulation.delaunay.DelaunayTriangle;

/** Poly2tri, a sweep for constrained Delaunay triangulations. */
final class Poly2TriPeer {
  private Poly2TriPeer() {}

  /** A point that knows its number. */
  private static final class Numbered extends PolygonPoint {
    private static final long serialVersionUID = 1L;
    final int index;

    Numbered(double x, double y, int index) {
      super(x, y);
      this.index = index;
    }
  }

  static int[] polygon(double[] x, double[] y) {
    PolygonPoint[] points = new PolygonPoint[x.length];
    for (int i = 0; i < x.length; i++) {
      points[i] = new Numbered(x[i], y[i], i);
    }
    Polygon polygon = new Polygon(points);
    Poly2Tri.triangulate(polygon);
    TriangleList triangles = new TriangleList(x.length);
    for (DelaunayTriangle t : polygon.getTriangles()) {
      triangles.add(index(t, 0), index(t, 1), index(t, 2));
    }
    return triangles.toArray();
  }

  private static int index(DelaunayTriangle triangle, int corner) {
    return ((Numbered) triangle.points[corner]).index;
  }
}
