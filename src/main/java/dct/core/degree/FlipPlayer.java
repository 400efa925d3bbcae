package dct.core.degree;

import java.util.List;
import java.util.Objects;

/**
 * Plays the flips between two triangulations forwards and backwards: a place in the list, and the
 * triangulation there.
 *
 * <p>Going to a place costs as many steps as flips lie between; only {@link #result}, which copies
 * the triangulation, takes linear time. Not for use by several threads at once.
 */
public final class FlipPlayer {
  private final List<Integer> edges;
  private final FlipWalk walk;

  /** Begins before the first flip. */
  public FlipPlayer(FlipResult flips) {
    edges = flips.edges();
    walk = new FlipWalk(flips.before());
  }

  /** The number of flips in the list. */
  public int size() {
    return edges.size();
  }

  /** How many of the flips are carried out, from 0 on. */
  public int index() {
    return walk.flips();
  }

  /**
   * Goes to the place after the first {@code index} flips.
   *
   * @throws IndexOutOfBoundsException if there are not so many
   */
  public void goTo(int index) {
    Objects.checkIndex(index, size() + 1);
    while (walk.flips() > index) {
      walk.undo();
    }
    while (walk.flips() < index) {
      walk.flip(edges.get(walk.flips()));
    }
  }

  /** The even and the odd vertices at this place. */
  public DegreeCount counts() {
    return walk.counts();
  }

  /** The flips up to this place and the triangulation there. */
  public FlipResult result() {
    return FlipResult.of(walk);
  }
}
