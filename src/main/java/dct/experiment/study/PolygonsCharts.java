package dct.experiment.study;

import dct.problem.Method;
import dct.render.chart.Chart;
import dct.render.chart.Chart.Look;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;

/** The charts of the study of polygons; given polygons are not in them. */
final class PolygonsCharts {
  static final List<String> WORDS = List.of("shapes", "sizes", "pieces", "reflex");

  private static final Map<Method, Look> PALE =
      Map.of(
          Method.EAR_CLIPPING, Look.PALE_BLUE,
          Method.MONOTONE, Look.PALE_ORANGE,
          Method.CONVEX_EVEN, Look.PALE_GREEN);
  private static final Map<Method, Look> STRONG =
      Map.of(
          Method.EAR_CLIPPING, Look.BLUE,
          Method.MONOTONE, Look.ORANGE,
          Method.CONVEX_EVEN, Look.GREEN);

  private static final String SHARE = "even vertices, %";
  private static final String ERRORS = "; bars: 95 % interval of the mean";

  private final List<StudyRow> rows;

  private PolygonsCharts(List<StudyRow> rows) {
    this.rows = rows;
  }

  static List<Chart> of(List<StudyRow> rows) {
    PolygonsCharts charts =
        new PolygonsCharts(rows.stream().filter(row -> !PolygonsColumns.isFile(row)).toList());
    return List.of(charts.shapes(), charts.sizes(), charts.pieces(), charts.reflex());
  }

  /** Only the largest size: smaller ones are another chart's. */
  private Chart shapes() {
    int n = rows.stream().mapToInt(row -> row.trial().n()).max().orElse(0);
    List<StudyRow> largest = rows.stream().filter(row -> row.trial().n() == n).toList();
    Map<String, List<StudyRow>> groups = Groups.by(largest, row -> row.trial().shape());
    return new Chart(
        WORDS.get(0),
        "Even vertices of random polygons with " + n + " vertices",
        "shape" + ERRORS,
        SHARE,
        true,
        List.copyOf(groups.keySet()),
        series((name, look, value) -> Groups.bars(name, look, groups.values(), value)));
  }

  private Chart sizes() {
    return lines(
        WORDS.get(1),
        "Even vertices of random polygons",
        "vertices",
        Groups.by(rows, r -> r.trial().n()));
  }

  private Chart pieces() {
    return lines(
        WORDS.get(2),
        "Even vertices and convex pieces",
        "convex pieces for each vertex",
        bins(PolygonsColumns::pieces));
  }

  private Chart reflex() {
    return lines(
        WORDS.get(3),
        "Even vertices and reflex vertices",
        "share of reflex vertices",
        bins(PolygonsColumns::reflex));
  }

  private Map<Double, List<StudyRow>> bins(ToDoubleFunction<StudyRow> value) {
    Map<Double, List<StudyRow>> bins = new TreeMap<>();
    Bin.sort(rows, value).forEach((key, group) -> bins.put(key.middle(), group));
    return bins;
  }

  /** The means of all methods over the keys of these groups. */
  static Chart lines(
      String word, String title, String x, Map<? extends Number, List<StudyRow>> groups) {
    return new Chart(
        word,
        title,
        x + ERRORS,
        SHARE,
        true,
        List.of(),
        series((name, look, value) -> Groups.overKeys(name, look, groups, value)));
  }

  /** Makes a series of the values of each row. */
  @FunctionalInterface
  private interface Maker {
    Chart.Series make(String name, Look look, ToDoubleFunction<StudyRow> value);
  }

  private static List<Chart.Series> series(Maker maker) {
    List<Chart.Series> series = new ArrayList<>();
    for (Method method : PolygonsColumns.METHODS) {
      series.add(
          maker.make(
              method.algorithm(),
              PALE.get(method),
              r -> r.percent(PolygonsColumns.before(method))));
      series.add(
          maker.make(
              method.algorithm() + ", Scan-Flip",
              STRONG.get(method),
              r -> r.percent(PolygonsColumns.after(method))));
    }
    series.add(maker.make("Best", Look.VIOLET, row -> row.percent(StudyRow.BEST)));
    return series;
  }
}
