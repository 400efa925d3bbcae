package dct.experiment.study;

import dct.render.chart.Chart;
import dct.render.chart.Chart.Look;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/** The charts of the study of sites. */
final class PointsCharts {
  static final List<String> WORDS = List.of("sizes", "increase", "shapes");

  private static final String ERRORS = "; bars: 95 % interval of the mean";

  private final Map<Integer, List<StudyRow>> bySize;
  private final Map<String, List<StudyRow>> byShape;
  private final Map<Integer, List<ThesisTable.Row>> thesis;

  private PointsCharts(List<StudyRow> rows) {
    bySize = Groups.by(rows, row -> row.trial().n());
    byShape = Groups.by(rows, row -> row.trial().shape());
    thesis =
        ThesisTable.read().rows().stream()
            .collect(Collectors.groupingBy(ThesisTable.Row::n, TreeMap::new, Collectors.toList()));
  }

  static List<Chart> of(List<StudyRow> rows) {
    PointsCharts charts = new PointsCharts(rows);
    return List.of(charts.sizes(), charts.increase(), charts.shapes());
  }

  private Chart sizes() {
    return new Chart(
        WORDS.get(0),
        "Even vertices of sites",
        "sites" + ERRORS,
        "even vertices, %",
        true,
        List.of(),
        List.of(
            shares("Best", Look.VIOLET, StudyRow.BEST),
            shares("Scan-Flip repeated", Look.GREEN, PointsColumns.REPEATED),
            shares("Scan-Flip", Look.BLUE, PointsColumns.AFTER),
            Groups.overKeys(
                "thesis: Scan-Flip",
                Look.ORANGE,
                thesis,
                (ThesisTable.Row row) -> 100.0 * row.evenAfter() / row.n()),
            shares("Delaunay", Look.PALE_BLUE, PointsColumns.BEFORE),
            Groups.overKeys(
                "thesis: Delaunay",
                Look.PALE_ORANGE,
                thesis,
                (ThesisTable.Row row) -> 100.0 * row.evenBefore() / row.n())));
  }

  private Chart.Series shares(String name, Look look, String count) {
    return Groups.overKeys(name, look, bySize, (StudyRow row) -> row.percent(count));
  }

  private Chart increase() {
    return new Chart(
        WORDS.get(1),
        "By how much Scan-Flip increases the even vertices",
        "sites" + ERRORS,
        "increase, %",
        false,
        List.of(),
        List.of(
            Groups.overKeys("Scan-Flip", Look.BLUE, bySize, PointsColumns::increase),
            Groups.overKeys("thesis: Scan-Flip", Look.ORANGE, thesis, ThesisTable.Row::increase)));
  }

  private Chart shapes() {
    return new Chart(
        WORDS.get(2),
        "Even vertices by the shape of the sets",
        "shape" + ERRORS,
        "even vertices, %",
        true,
        List.copyOf(byShape.keySet()),
        List.of(
            bars("Delaunay", Look.PALE_BLUE, PointsColumns.BEFORE),
            bars("Scan-Flip", Look.BLUE, PointsColumns.AFTER),
            bars("Scan-Flip repeated", Look.GREEN, PointsColumns.REPEATED),
            bars("Best", Look.VIOLET, StudyRow.BEST)));
  }

  private Chart.Series bars(String name, Look look, String count) {
    return Groups.bars(name, look, byShape.values(), (StudyRow row) -> row.percent(count));
  }
}
