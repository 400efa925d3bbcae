package dct.core.degree;

import dct.core.Progress;
import dct.core.triangulate.Triangulation;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Flips in order, each named by its corners; immutable. It can be carried out in every
 * triangulation of the same points, as far as that has the edges.
 *
 * @param flips the flips
 */
public record FlipList(List<Flip> flips) {

  /** The list is copied. */
  public FlipList {
    flips = List.copyOf(flips);
  }

  /**
   * What came of carrying a list out.
   *
   * @param result the triangulation before, and after all flips up to the first impossible one
   * @param cause why the next flip, number {@code result.flips()} from 0 on, is impossible, as a
   *     clause for a person; empty if all were carried out
   */
  public record Applied(FlipResult result, Optional<String> cause) {}

  /** The flips between two triangulations, in linear time. */
  public static FlipList of(FlipResult result) {
    FlipWalk walk = new FlipWalk(result.before());
    List<Flip> flips = new ArrayList<>(result.flips());
    for (int edge : result.edges()) {
      flips.add(walk.flip(edge));
    }
    return new FlipList(flips);
  }

  /** The number of flips. */
  public int size() {
    return flips.size();
  }

  /**
   * Carries the flips out in order, up to the first that is impossible.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public Applied applyTo(Triangulation triangulation, Progress progress) {
    FlipWalk walk = new FlipWalk(triangulation);
    Optional<String> cause = Optional.empty();
    for (int i = 0; i < flips.size() && cause.isEmpty(); i++) {
      Progress.tick(progress, i, flips.size(), "Flipping");
      cause = walk.flip(flips.get(i));
    }
    return new Applied(FlipResult.of(walk), cause);
  }
}
