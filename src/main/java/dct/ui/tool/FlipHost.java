package dct.ui.tool;

import dct.problem.Solution;
import dct.render.Scene;
import java.util.Optional;

/** The view of a triangulation whose edges can be flipped by hand. */
public interface FlipHost {

  /** The solution that the view shows, if its edges can be flipped. */
  Optional<Solution> solution();

  /** The picture of that solution. */
  Scene scene();

  /** Why nothing can be flipped, and what to do, where there is no {@link #solution}. */
  String refusal();

  /** What is known of how good the solution is, in a clause for a person; empty if nothing is. */
  String verdict();

  /**
   * Flips an edge of the solution, as a step of the history; large ones in the background.
   *
   * @param edge one that can be flipped
   */
  void flip(int edge);
}
