package dct.io;

import dct.core.degree.DegreeCount;
import dct.core.triangulate.Triangulation;
import java.util.Optional;

/**
 * A triangulation and what is to be told of it.
 *
 * @param input the name of the input as the user gave it
 * @param algorithm the name of the algorithm that made the triangulation
 * @param triangulation the final triangulation
 * @param post what was done after the algorithm, if anything
 * @param merged how many exact duplicates among the sites were merged
 * @param millis how long the steps took
 */
public record Result(
    String input,
    String algorithm,
    Triangulation triangulation,
    Optional<Post> post,
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
    return oddLowerBound(triangulation.boundaryCount());
  }

  /** {@link #oddLowerBound()} for this many vertices on the boundary. */
  public static int oddLowerBound(int boundary) {
    return boundary % 3 == 0 ? 0 : 2;
  }

  /** Whether the result is proven to have the fewest odd vertices that there can be. */
  public boolean isOptimal() {
    return degrees().odd() == oddLowerBound();
  }
}
