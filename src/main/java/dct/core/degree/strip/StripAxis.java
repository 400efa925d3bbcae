package dct.core.degree.strip;

import dct.core.SeededRandom;
import dct.core.degree.region.SearchMesh;
import dct.core.degree.region.VertexList;

/**
 * Lays a path along edges of a {@link SearchMesh} from a vertex to both sides, each vertex coming
 * after the one before it in an order, at about the height of the first. O(1) time an edge where
 * degrees are small.
 */
final class StripAxis {
  private static final double STRAY = 0.2; // of the length of an edge, at random

  private final SearchMesh mesh;
  private final SeededRandom random;
  private final StripOrder order;
  private final double height;
  private final VertexList spokes = new VertexList(); // half-edges, one for each edge at a vertex
  private final VertexList trail = new VertexList(); // half-edges, one for each edge to the left

  StripAxis(SearchMesh mesh, SeededRandom random, StripOrder order, int v) {
    this.mesh = mesh;
    this.random = random;
    this.order = order;
    height = order.height(v);
  }

  /** Lays two paths, one on the other, from v at most so many edges to the left and right. */
  void lay(int v, int left, int right, StripPath lower, StripPath upper) {
    int first = goLeft(v, left);
    lower.begin(first);
    upper.begin(first);
    int u = first;
    for (int i = trail.size() - 1; i >= 0; i--) {
      u = follow(u, trail.get(i), lower, upper);
    }
    int e = edgeFrom(u, true);
    for (int i = 0; i < right && e != SearchMesh.NONE; i++) {
      u = follow(u, e, lower, upper);
      e = edgeFrom(u, true);
    }
  }

  private int goLeft(int v, int left) {
    int u = v;
    int e = edgeFrom(u, false);
    while (trail.size() < left && e != SearchMesh.NONE) {
      trail.add(e);
      u = otherEnd(u, e);
      e = edgeFrom(u, false);
    }
    return u;
  }

  private int follow(int u, int e, StripPath lower, StripPath upper) {
    int v = otherEnd(u, e);
    boolean isForward = mesh.corner[e] == u;
    lower.add(isForward ? mesh.twin[e] : e, v);
    upper.add(isForward ? e : mesh.twin[e], v);
    return v;
  }

  private int otherEnd(int u, int e) {
    return mesh.corner[e] == u ? mesh.corner[SearchMesh.next(e)] : mesh.corner[e];
  }

  /** A half-edge of the edge at v that leads on and best keeps the height, or NONE. */
  private int edgeFrom(int v, boolean rightwards) {
    mesh.collectEdges(v, spokes);
    int best = SearchMesh.NONE;
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < spokes.size(); i++) {
      int w = otherEnd(v, spokes.get(i));
      if (order.isBefore(v, w) == rightwards) {
        double stray = STRAY * random.nextDouble() * Math.sqrt(mesh.squaredDistance(v, w));
        double price = Math.abs(order.height(w) - height) + stray;
        best = price < least ? spokes.get(i) : best;
        least = Math.min(least, price);
      }
    }
    return best;
  }
}
