package dct.core.triangulate;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.dcel.HalfEdges;
import dct.core.geometry.Region;

/**
 * Ties the holes, sites and fixed edges of a region to its outer ring by diagonals, so that each
 * face is bounded by one closed walk.
 *
 * <p>The diagonals of the monotone partition connect all; of these, in their order, each is kept
 * that ties two parts which were not tied before. So there are as few as can be. O(n log n).
 */
final class RegionTies {
  private final int[] part; // by vertex: one of the same part, itself if that stands for the part

  private RegionTies(int vertices) {
    part = new int[vertices];
    for (int v = 0; v < vertices; v++) {
      part[v] = v;
    }
  }

  /**
   * The rings, the fixed edges and the ties.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  static Dcel tied(Region region, Progress progress) {
    Dcel all = MonotonePartition.partition(region, progress).dcel();
    int given = region.positions() + region.rings().fixedCount(); // come first
    HalfEdges links = all.links();
    RegionTies ties = new RegionTies(region.size());
    for (int edge = 0; edge < all.edgeCount(); edge++) {
      Progress.check(progress, edge);
      boolean isTie = ties.join(all.origin(2 * edge), all.target(2 * edge));
      if (!isTie && edge >= given) {
        links.remove(2 * edge);
      }
    }
    return Dcel.of(region.size(), links, all.outerCycles(), progress);
  }

  /** Whether two vertices were in different parts, which are one now. */
  private boolean join(int u, int v) {
    int a = find(u);
    int b = find(v);
    part[a] = b;
    return a != b;
  }

  private int find(int v) {
    int u = v;
    while (part[u] != u) {
      part[u] = part[part[u]]; // halves the way
      u = part[u];
    }
    return u;
  }
}
