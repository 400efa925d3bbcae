package dct.core.degree;

import dct.core.triangulate.Triangulation;
import java.util.ArrayList;
import java.util.List;

/**
 * A triangulation before and after flips: those of Scan-Flip, some made by hand, or one after the
 * other.
 *
 * @param before the triangulation that was given
 * @param after the one that came out; edges keep their numbers, and one that does not join the
 *     vertices that it joined before is of kind {@link dct.core.triangulate.EdgeKind#FLIPPED}
 * @param edges the numbers of the edges that were flipped, in order; Scan-Flip flips an edge once,
 *     by hand it may be flipped again
 */
public record FlipResult(Triangulation before, Triangulation after, List<Integer> edges) {

  /** The list is copied. */
  public FlipResult {
    edges = List.copyOf(edges);
  }

  /** The flips of a walk, in linear time. */
  public static FlipResult of(FlipWalk walk) {
    return new FlipResult(walk.start(), walk.triangulation(), walk.edges());
  }

  /**
   * One flip, in linear time.
   *
   * @throws IllegalArgumentException if the edge cannot be flipped
   */
  public static FlipResult of(Triangulation before, int edge) {
    return new FlipResult(before, FlipWalk.flipped(before, edge), List.of(edge));
  }

  /** The number of flips. */
  public int flips() {
    return edges.size();
  }

  /**
   * These flips and then one of this edge, in linear time.
   *
   * @throws IllegalArgumentException if the edge cannot be flipped
   */
  public FlipResult then(int edge) {
    return then(of(after, edge));
  }

  /**
   * These flips and then those, in linear time.
   *
   * @param next flips that begin at the triangulation after these
   * @throws IllegalArgumentException if they begin at another one
   */
  public FlipResult then(FlipResult next) {
    if (next.before != after) {
      throw new IllegalArgumentException("the flips begin at another triangulation");
    }
    List<Integer> all = new ArrayList<>(edges);
    all.addAll(next.edges);
    boolean isFirst = before == after;
    Triangulation made = isFirst ? next.after : FlipWalk.after(before, next.after.dcel());
    return new FlipResult(before, made, all);
  }
}
