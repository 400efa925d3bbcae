package dct.experiment.study;

import dct.render.chart.Chart;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;

/** Rows in groups, and what is the mean of each. */
final class Groups {

  private Groups() {}

  /** The rows by a key, in its order. */
  static <K extends Comparable<K>> Map<K, List<StudyRow>> by(
      List<StudyRow> rows, Function<StudyRow, K> key) {
    return rows.stream().collect(Collectors.groupingBy(key, TreeMap::new, Collectors.toList()));
  }

  /** The values of these rows, those that are no number left out. */
  static <R> Sample sample(List<R> rows, ToDoubleFunction<R> value) {
    return Sample.of(rows.stream().mapToDouble(value).filter(Double::isFinite).toArray());
  }

  /** A series that has the mean of each group, with its 95 % interval, over the group's key. */
  static <R> Chart.Series overKeys(
      String name,
      Chart.Look look,
      Map<? extends Number, List<R>> groups,
      ToDoubleFunction<R> value) {
    List<Double> x = groups.keySet().stream().map(Number::doubleValue).toList();
    return series(name, look, x, groups.values(), value);
  }

  /** A series that has the mean of each group, for a chart of bars. */
  static <R> Chart.Series bars(
      String name, Chart.Look look, Collection<List<R>> groups, ToDoubleFunction<R> value) {
    return series(name, look, List.of(), groups, value);
  }

  private static <R> Chart.Series series(
      String name,
      Chart.Look look,
      List<Double> x,
      Collection<List<R>> groups,
      ToDoubleFunction<R> value) {
    List<Double> means = new ArrayList<>();
    List<Double> errors = new ArrayList<>();
    for (List<R> group : groups) {
      Sample sample = sample(group, value);
      means.add(sample.mean());
      errors.add(sample.size() < 2 ? 0 : sample.halfWidth());
    }
    return new Chart.Series(name, look, x, means, errors);
  }
}
