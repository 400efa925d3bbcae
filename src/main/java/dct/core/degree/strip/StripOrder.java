package dct.core.degree.strip;

import dct.core.degree.region.SearchMesh;

/**
 * One of four orders of the vertices of a mesh: that by x, then y, and the same with the plane
 * turned by one to three right angles. Each is that of a sweep line turned by an infinitesimal
 * angle more, so that equal coordinates need no special case.
 */
final class StripOrder {
  /** The number of orders. */
  static final int TURNS = 4;

  private final SearchMesh mesh;
  private final int turn;

  /** The order with the plane turned by this many right angles. */
  StripOrder(SearchMesh mesh, int turn) {
    this.mesh = mesh;
    this.turn = turn;
  }

  /** How far along the sweep v lies. */
  double along(int v) {
    return switch (turn) {
      case 0 -> mesh.x[v];
      case 1 -> -mesh.y[v];
      case 2 -> -mesh.x[v];
      default -> mesh.y[v];
    };
  }

  /** How far up v lies, where the sweep goes to the right. */
  double height(int v) {
    return switch (turn) {
      case 0 -> mesh.y[v];
      case 1 -> mesh.x[v];
      case 2 -> -mesh.y[v];
      default -> -mesh.x[v];
    };
  }

  /** Whether u comes before v. */
  boolean isBefore(int u, int v) {
    double a = along(u);
    double b = along(v);
    return a < b || (a == b && height(u) < height(v));
  }

  /** Negative if u comes before v, zero if they are the same, positive otherwise. */
  int compare(int u, int v) {
    if (u == v) {
      return 0;
    }
    return isBefore(u, v) ? -1 : 1;
  }
}
