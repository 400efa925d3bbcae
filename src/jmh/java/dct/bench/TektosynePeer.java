package dct.bench;

import org.kynosarges.tektosyne.geometry.PointD;
import org.kynosarges.tektosyne.geometry.PointI;
import org.kynosarges.tektosyne.geometry.Voronoi;

/** Tektosyne's sweep of Fortune, which gives the edges only; triangles are read off them. */
final class TektosynePeer {
  private TektosynePeer() {}

  static int[] sites(double[] x, double[] y) {
    PointD[] points = new PointD[x.length];
    for (int i = 0; i < x.length; i++) {
      points[i] = new PointD(x[i], y[i]);
    }
    PointI[] edges = Voronoi.findDelaunay(points);
    int[] ends = new int[2 * edges.length];
    for (int k = 0; k < edges.length; k++) {
      ends[2 * k] = edges[k].x;
      ends[2 * k + 1] = edges[k].y;
    }
    return ends;
  }
}
