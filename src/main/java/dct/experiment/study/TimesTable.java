package dct.experiment.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** How long the steps of a study took. */
final class TimesTable {

  private TimesTable() {}

  /** The median times for each shape and size; no rows if the times were not kept. */
  static Table of(List<StudyRow> rows) {
    List<StudyRow> timed = rows.stream().filter(row -> !row.millis().isEmpty()).toList();
    List<String> columns = new ArrayList<>(List.of("Shape", "Vertices", "Sets"));
    List<List<String>> cells = new ArrayList<>();
    if (!timed.isEmpty()) {
      List<String> steps = List.copyOf(timed.get(0).millis().keySet());
      steps.forEach(step -> columns.add(step.replace('_', ' ')));
      groups(timed).values().forEach(group -> cells.add(cells(group, steps)));
    }
    return new Table(
        "Time of each step in milliseconds, the median",
        3,
        columns,
        cells,
        List.of("Trials ran on several threads at once, which slows each of them."));
  }

  private static Map<String, List<StudyRow>> groups(List<StudyRow> rows) {
    return rows.stream()
        .collect(
            Collectors.groupingBy(
                row -> row.trial().shape() + " " + row.trial().n(),
                LinkedHashMap::new,
                Collectors.toList()));
  }

  private static List<String> cells(List<StudyRow> group, List<String> steps) {
    Trial trial = group.get(0).trial();
    List<String> cells = new ArrayList<>();
    cells.add(trial.shape());
    cells.add(String.valueOf(trial.n()));
    cells.add(String.valueOf(group.size()));
    for (String step : steps) {
      double[] millis =
          group.stream().mapToDouble(row -> row.millis().get(step)).sorted().toArray();
      cells.add(String.format(Locale.ROOT, "%.3f", millis[millis.length / 2]));
    }
    return cells;
  }
}
