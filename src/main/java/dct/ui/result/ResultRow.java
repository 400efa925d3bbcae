package dct.ui.result;

import dct.core.degree.DegreeCount;
import dct.core.degree.FlipResult;
import dct.problem.Solution;
import dct.ui.document.Result;
import java.time.Duration;
import java.util.Optional;

/**
 * What a table of results says of one of them.
 *
 * @param result the result
 * @param even the number of even vertices
 * @param odd the number of odd vertices
 * @param bound what no triangulation goes below: odd vertices, or unmet wishes where those were
 *     asked for
 * @param flips the number of flips, if there were any asked for
 * @param verdict what is known of how good it is
 */
public record ResultRow(
    Result result, int even, int odd, int bound, Optional<Integer> flips, String verdict) {

  /** The row of a result, in linear time. */
  public static ResultRow of(Result result) {
    Solution solution = result.solution();
    DegreeCount counts = solution.counts();
    return new ResultRow(
        result,
        counts.even(),
        counts.odd(),
        solution.bound().value(),
        solution.flips().map(FlipResult::flips),
        solution.verdict());
  }

  /** What was done, for a person to read. */
  public String title() {
    return result.title();
  }

  /** Seconds that it took, if that was measured. */
  public Optional<Double> seconds() {
    return result.time().map(ResultRow::seconds);
  }

  private static double seconds(Duration time) {
    return time.toNanos() / 1e9;
  }
}
