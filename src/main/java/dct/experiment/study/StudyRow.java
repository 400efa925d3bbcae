package dct.experiment.study;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * What came out of one trial; immutable.
 *
 * @param trial the trial
 * @param counts the numbers counted, by the names of {@link Study#counts}, in their order; the same
 *     whenever the trial is run
 * @param millis the time of each step, by the names of {@link Study#steps}, in their order; empty
 *     where it was not kept
 */
public record StudyRow(Trial trial, Map<String, Integer> counts, Map<String, Double> millis) {
  /** The name of the number of even vertices of the best triangulation found. */
  static final String BEST = "even_best";

  /** The name of the largest number of even vertices that the bound does not rule out. */
  static final String LIMIT = "even_limit";

  public StudyRow {
    counts = Collections.unmodifiableMap(new LinkedHashMap<>(counts));
    millis = Collections.unmodifiableMap(new LinkedHashMap<>(millis));
  }

  /** The number of this name. */
  public int count(String name) {
    return counts.get(name);
  }

  /** The number of this name as a share of the vertices, in per cent. */
  double percent(String name) {
    return 100.0 * count(name) / trial.n();
  }

  /** The number of this name for each vertex. */
  double perVertex(String name) {
    return (double) count(name) / trial.n();
  }

  /** Whether no triangulation has more even vertices than the best one found. */
  boolean isProven() {
    return count(BEST) == count(LIMIT);
  }

  /** This row without its times. */
  public StudyRow withoutTimes() {
    return new StudyRow(trial, counts, Map.of());
  }
}
