package dct.core.triangulate;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.dcel.HalfEdges;
import dct.core.geometry.Sites;

/**
 * The Delaunay triangulation of point sites (thesis, Section 2.2.6): no site lies strictly inside
 * the circle through the corners of any triangle. Exactly so, for every input.
 *
 * <p>Divide and conquer of Guibas and Stolfi (1985) with cuts alternating between the axes (Dwyer
 * 1987), along the cells of a grid as far as these go: O(n log n) time, O(n) space. Large parts are
 * computed in parallel; each part numbers its edges within a range of its own, so that the result
 * does not depend on the number of threads. Among cocircular sites the edge kept is the one that
 * the merge meets first, from the lower common tangent upwards.
 *
 * <p>Edges are numbered part by part, which is an order from place to neighbouring place; {@link
 * dct.core.degree.ScanFlip} visits them in it.
 */
public final class Delaunay {

  private Delaunay() {}

  /**
   * The Delaunay triangulation; of sites that all lie on one line, the path along it.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Triangulation triangulate(Sites sites, Progress progress) {
    return new Triangulation(
        Domain.SITES, sites.points(), topology(sites, progress), edge -> EdgeKind.DIAGONAL);
  }

  private static Dcel topology(Sites sites, Progress progress) {
    int n = sites.size();
    if (n < 2) {
      return Dcel.of(n, new HalfEdges(0, 0), Dcel.NONE, progress);
    }
    DelaunayMerge merge = new DelaunayMerge(sites.points(), progress);
    int outer = merge.run();
    progress.report(0.9, "Linking the edges");
    return Dcel.of(n, merge.links(), outer, progress);
  }
}
