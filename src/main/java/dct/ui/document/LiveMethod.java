package dct.ui.document;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.triangulate.Domain;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * By what a polygon is triangulated whenever it changes.
 *
 * @param title for a person to read
 * @param method the method, or nothing for the optimum of even vertices
 */
public record LiveMethod(String title, Optional<Method> method) {
  /** The triangulation in which the most vertices are even. */
  public static final LiveMethod MOST_EVEN =
      new LiveMethod(MostVertices.EVEN.title(), Optional.empty());

  /** While the mouse drags, what is not solved by then is the best found. */
  private static final SearchLimits HURRIED = new SearchLimits(1, 0.1, 0.25);

  /** What stays is the same on every machine. */
  private static final SearchLimits CALM = new SearchLimits(1, 0.1, Double.POSITIVE_INFINITY);

  /** All that there are, as menus list them. */
  public static List<LiveMethod> all() {
    return Stream.concat(
            Method.of(Domain.POLYGON).stream()
                .map(method -> new LiveMethod(method.title(), Optional.of(method))),
            Stream.of(MOST_EVEN))
        .toList();
  }

  /**
   * Triangulates a polygon.
   *
   * @param hurried whether the next state follows at once: then a search ends early, and its result
   *     depends on the machine
   * @throws java.util.concurrent.CancellationException if cancelled before there is a triangulation
   */
  Solution solve(Instance polygon, boolean hurried, Progress progress) {
    if (method.isPresent()) {
      return Solution.of(polygon, method.get(), progress);
    }
    Instance even = polygon.with(ParityGoal.allEven(polygon.size()));
    return Solution.of(even, Method.byDefault(Domain.POLYGON), progress)
        .optimized(hurried ? HURRIED : CALM, progress);
  }
}
