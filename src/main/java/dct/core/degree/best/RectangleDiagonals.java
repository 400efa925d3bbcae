package dct.core.degree.best;

import dct.core.Progress;
import dct.core.degree.region.SearchMesh;

/**
 * Turns the diagonals of all rectangles of two triangles the same way: up to the right, or flat.
 *
 * <p>The corners of a rectangle lie on one circle, so that a Delaunay triangulation may take either
 * diagonal, and in a lattice takes them as they come. Turned the same way they give every vertex
 * inside a full lattice degree 6 and every one inside its sides degree 4: all but two are even.
 * Linear time.
 */
final class RectangleDiagonals {
  private final SearchMesh mesh;

  private RectangleDiagonals(SearchMesh mesh) {
    this.mesh = mesh;
  }

  /**
   * Aligns them.
   *
   * @throws java.util.concurrent.CancellationException if cancelled; some are aligned then
   */
  static void align(SearchMesh mesh, Progress progress) {
    RectangleDiagonals diagonals = new RectangleDiagonals(mesh);
    for (int e = 0; e < mesh.corner.length; e++) {
      Progress.check(progress, e);
      if ((e & 3) != 3 && mesh.twin[e] > e) {
        diagonals.consider(e);
      }
    }
  }

  private void consider(int e) {
    int a = mesh.corner[e];
    int b = mesh.corner[SearchMesh.next(e)];
    int c = mesh.corner[SearchMesh.prev(e)];
    int d = mesh.corner[SearchMesh.prev(mesh.twin[e])];
    if (isRectangle(a, b, c, d) && isBetter(c, d, a, b)) {
      mesh.flip(e);
    }
  }

  /** Whether the diagonals ab and cd are of one length and halve each other. */
  private boolean isRectangle(int a, int b, int c, int d) {
    return mesh.x[a] - mesh.x[c] == mesh.x[d] - mesh.x[b]
        && mesh.y[a] - mesh.y[c] == mesh.y[d] - mesh.y[b]
        && mesh.squaredDistance(a, b) == mesh.squaredDistance(c, d)
        && mesh.isLeftTurn(mesh.x[d], mesh.y[d], mesh.x[b], mesh.y[b], mesh.x[c], mesh.y[c])
        && mesh.isLeftTurn(mesh.x[c], mesh.y[c], mesh.x[a], mesh.y[a], mesh.x[d], mesh.y[d]);
  }

  private boolean isBetter(int c, int d, int a, int b) {
    double rise = slope(c, d);
    double other = slope(a, b);
    return rise > other
        || (rise == other && Math.abs(mesh.x[c] - mesh.x[d]) > Math.abs(mesh.x[a] - mesh.x[b]));
  }

  /** Positive where the edge goes up to the right. */
  private double slope(int u, int v) {
    return (mesh.x[u] - mesh.x[v]) * (mesh.y[u] - mesh.y[v]);
  }
}
