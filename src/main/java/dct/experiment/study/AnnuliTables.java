package dct.experiment.study;

import dct.render.chart.Chart;
import java.util.ArrayList;
import java.util.List;

/** The tables and charts of the study of annuli. */
final class AnnuliTables {
  static final List<String> CHARTS = List.of("sizes", AnnuliStudy.HOLES);

  private AnnuliTables() {}

  /** The means by shape and size, by the number of holes, and by what the lengths are mod 3. */
  static List<Table> of(List<StudyRow> rows) {
    return List.of(
        bySize(rows),
        by("Holes", AnnuliStudy.HOLES, rows),
        by("Rings whose length 3 does not divide", AnnuliStudy.INDIVISIBLE, rows),
        TimesTable.of(rows));
  }

  private static Table bySize(List<StudyRow> rows) {
    List<List<String>> cells = new ArrayList<>();
    Groups.by(rows, row -> row.trial().shape())
        .forEach(
            (shape, mine) ->
                Groups.by(mine, row -> row.trial().n())
                    .forEach((n, group) -> cells.add(line(group, shape, String.valueOf(n)))));
    return new Table(
        "Share of even vertices of random regions in per cent",
        2,
        PolygonsTables.columns("Shape", "Vertices", "Regions"),
        cells,
        List.of(PolygonsTables.WORDS));
  }

  private static Table by(String what, String count, List<StudyRow> rows) {
    List<List<String>> cells = new ArrayList<>();
    Groups.by(rows, row -> row.count(count))
        .forEach((number, group) -> cells.add(line(group, String.valueOf(number))));
    return new Table(
        what + ", and the share of even vertices in per cent",
        1,
        PolygonsTables.columns(what, "Regions"),
        cells,
        List.of("All shapes and sizes together. " + PolygonsTables.WORDS));
  }

  private static List<String> line(List<StudyRow> group, String... keys) {
    List<String> cells = new ArrayList<>(List.of(keys));
    cells.add(String.valueOf(group.size()));
    PolygonsTables.addMethods(cells, group);
    return cells;
  }

  static List<Chart> charts(List<StudyRow> rows) {
    return List.of(
        PolygonsCharts.lines(
            CHARTS.get(0),
            "Even vertices of random regions",
            "vertices",
            Groups.by(rows, row -> row.trial().n())),
        PolygonsCharts.lines(
            CHARTS.get(1),
            "Even vertices and holes",
            "holes",
            Groups.by(rows, row -> row.count(AnnuliStudy.HOLES))));
  }
}
