package dct.io;

import dct.core.degree.DegreeCount;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.triangulate.Triangulation;
import java.util.Optional;

/**
 * A triangulation and what is to be told of it.
 *
 * @param input the name of the input as the user gave it
 * @param algorithm the name of the algorithm that made the triangulation
 * @param triangulation the final triangulation
 * @param post the flips that were made after the algorithm, if any were asked for
 * @param optimum what the optimizer found, if it was asked for; its triangulation is the final one
 * @param merged how many exact duplicates among the sites were merged
 * @param millis how long the steps took
 */
public record Result(
    String input,
    String algorithm,
    Triangulation triangulation,
    Optional<Post> post,
    Optional<Optimum> optimum,
    int merged,
    Millis millis) {

  /**
   * What was done after the algorithm.
   *
   * @param name what it is called in files
   * @param before the counts before
   * @param flips the number of flips
   */
  public record Post(String name, DegreeCount before, int flips) {}

  /** Milliseconds for reading, for the algorithm and for what came after it. */
  public record Millis(double read, double triangulate, double post) {}

  /** The even and the odd vertices. */
  public DegreeCount degrees() {
    return DegreeCount.of(triangulation);
  }

  /**
   * A number of odd vertices that no triangulation of this input goes below.
   *
   * <p>If all vertices are even, the triangles can be coloured black and white so that neighbours
   * differ; every boundary edge then borders the same colour, and counting edges shows that their
   * number is divisible by three. The number of odd vertices is always even.
   */
  public int oddLowerBound() {
    return evenOptimum()
        .map(best -> best.bound().value())
        .orElseGet(() -> oddLowerBound(triangulation.boundaryCount()));
  }

  /** Why {@link #oddLowerBound()} holds, where it may rest on more than the boundary count. */
  public Optional<String> boundReason() {
    return evenOptimum().map(best -> best.bound().reason());
  }

  private Optional<Optimum> evenOptimum() {
    return optimum.filter(best -> best.goal().isAll(ParityGoal.Wish.EVEN));
  }

  /** What the optimizer found for wishes other than all even. */
  public Optional<Optimum> wished() {
    return optimum.filter(best -> !best.goal().isAll(ParityGoal.Wish.EVEN));
  }

  /** {@link #oddLowerBound()} for this many vertices on the boundary. */
  public static int oddLowerBound(int boundary) {
    return boundary % 3 == 0 ? 0 : 2;
  }

  /**
   * Whether the result is proven to be the best: to have the fewest odd vertices that there can be,
   * or, where the optimizer was asked for other parities, to leave the fewest wishes open.
   */
  public boolean isOptimal() {
    return wished().map(Optimum::isProven).orElseGet(() -> degrees().odd() == oddLowerBound());
  }
}
