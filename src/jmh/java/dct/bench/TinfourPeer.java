package dct.bench;

import java.util.ArrayList;
import java.util.List;
import org.tinfour.common.IConstraint;
import org.tinfour.common.PolygonConstraint;
import org.tinfour.common.Vertex;
import org.tinfour.standard.IncrementalTin;
import org.tinfour.utils.HilbertSort;
import org.tinfour.utils.TriangleCollector;

/**
 * Tinfour's incremental Delaunay triangulation, sorted along a Hilbert curve beforehand and with a
 * spacing small enough that it drops no site.
 */
final class TinfourPeer {
  private static final double SAFE = 1e-3; // of the mean spacing

  private TinfourPeer() {}

  static int[] sites(double[] x, double[] y) {
    List<Vertex> vertices = vertices(x, y);
    new HilbertSort().sort(vertices);
    IncrementalTin tin = new IncrementalTin(spacing(x, y));
    tin.add(vertices, null);
    TriangleList triangles = new TriangleList(2 * x.length);
    TriangleCollector.visitTriangles(
        tin, t -> triangles.add(index(t[0]), index(t[1]), index(t[2])));
    tin.dispose();
    return triangles.toArray();
  }

  static int[] polygon(double[] x, double[] y) {
    List<Vertex> ring = vertices(x, y);
    List<Vertex> vertices = new ArrayList<>(ring);
    new HilbertSort().sort(vertices);
    IncrementalTin tin = new IncrementalTin(spacing(x, y));
    tin.add(vertices, null);
    PolygonConstraint outline = new PolygonConstraint(ring);
    tin.addConstraints(List.<IConstraint>of(outline), false);
    TriangleList triangles = new TriangleList(x.length);
    TriangleCollector.visitTrianglesForConstrainedRegion(
        tin.getConstraints().get(0), t -> triangles.add(index(t[0]), index(t[1]), index(t[2])));
    tin.dispose();
    return triangles.toArray();
  }

  private static List<Vertex> vertices(double[] x, double[] y) {
    List<Vertex> vertices = new ArrayList<>(x.length);
    for (int i = 0; i < x.length; i++) {
      vertices.add(new Vertex(x[i], y[i], 0, i));
    }
    return vertices;
  }

  private static int index(Vertex vertex) {
    return vertex.getIndex();
  }

  private static double spacing(double[] x, double[] y) {
    return SAFE * Math.sqrt(extent(x) * extent(y) / x.length);
  }

  private static double extent(double[] values) {
    double low = Double.POSITIVE_INFINITY;
    double high = Double.NEGATIVE_INFINITY;
    for (double value : values) {
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    return high - low;
  }
}
