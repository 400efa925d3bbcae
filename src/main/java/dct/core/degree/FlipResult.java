package dct.core.degree;

import dct.core.triangulate.Triangulation;
import java.util.List;

/**
 * A triangulation before and after flips.
 *
 * @param before the triangulation that was given
 * @param after the one that came out; the edges that flips made are of kind {@link
 *     dct.core.triangulate.EdgeKind#FLIPPED} and have the numbers of those that they replaced
 * @param edges the numbers of the edges that were flipped, in order
 */
public record FlipResult(Triangulation before, Triangulation after, List<Integer> edges) {

  /** The list is copied. */
  public FlipResult {
    edges = List.copyOf(edges);
  }

  /** The number of flips. */
  public int flips() {
    return edges.size();
  }
}
