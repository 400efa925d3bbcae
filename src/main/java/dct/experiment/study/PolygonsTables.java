package dct.experiment.study;

import dct.problem.Method;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/** The tables of the study of polygons. */
final class PolygonsTables {
  static final String WORDS = "Numbers are means ± half the 95 % interval (standard deviation).";

  private PolygonsTables() {}

  /** The means by shape and size, pieces and reflex vertices; the files; the times. */
  static List<Table> of(List<StudyRow> rows) {
    List<StudyRow> random = rows.stream().filter(row -> !PolygonsColumns.isFile(row)).toList();
    return List.of(
        bySize(random),
        byShare("Convex pieces for each vertex", random, PolygonsColumns::pieces),
        byShare("Reflex vertices for each vertex", random, PolygonsColumns::reflex),
        files(rows.stream().filter(PolygonsColumns::isFile).toList()),
        TimesTable.of(rows));
  }

  private static Table bySize(List<StudyRow> rows) {
    List<List<String>> cells = new ArrayList<>();
    Groups.by(rows, row -> row.trial().shape())
        .forEach(
            (shape, mine) ->
                Groups.by(mine, row -> row.trial().n())
                    .forEach((n, group) -> cells.add(sizeCells(shape, n, group))));
    return new Table(
        "Share of even vertices of random polygons in per cent",
        2,
        columns("Shape", "Vertices", "Polygons", "Reflex vertices", "Convex pieces"),
        cells,
        List.of(WORDS));
  }

  private static List<String> sizeCells(String shape, int n, List<StudyRow> group) {
    List<String> cells =
        new ArrayList<>(List.of(shape, String.valueOf(n), String.valueOf(group.size())));
    cells.add(mean(group, row -> row.count(PolygonsColumns.REFLEX)));
    cells.add(mean(group, row -> row.count(PolygonsColumns.PIECES)));
    addMethods(cells, group);
    return cells;
  }

  static String mean(List<StudyRow> group, ToDoubleFunction<StudyRow> value) {
    return String.format(Locale.ROOT, "%.1f", Groups.sample(group, value).mean());
  }

  /** The heads of a table: these, then those of the methods. */
  static List<String> columns(String... first) {
    List<String> columns = new ArrayList<>(List.of(first));
    for (Method method : PolygonsColumns.METHODS) {
      columns.addAll(List.of(method.algorithm(), method.algorithm() + ", Scan-Flip"));
    }
    columns.addAll(List.of("Best", "Proven best"));
    return columns;
  }

  /** Adds the cells of the methods. */
  static void addMethods(List<String> cells, List<StudyRow> group) {
    for (Method method : PolygonsColumns.METHODS) {
      cells.add(share(group, PolygonsColumns.before(method)));
      cells.add(share(group, PolygonsColumns.after(method)));
    }
    cells.add(share(group, StudyRow.BEST));
    long proven = group.stream().filter(StudyRow::isProven).count();
    cells.add(proven + " of " + group.size());
  }

  private static String share(List<StudyRow> group, String count) {
    return Groups.sample(group, row -> row.percent(count)).words();
  }

  private static Table byShare(String what, List<StudyRow> rows, ToDoubleFunction<StudyRow> value) {
    List<List<String>> cells = new ArrayList<>();
    for (Map.Entry<Bin, List<StudyRow>> entry : Bin.sort(rows, value).entrySet()) {
      List<String> line = new ArrayList<>();
      line.add(entry.getKey().words());
      line.add(String.valueOf(entry.getValue().size()));
      addMethods(line, entry.getValue());
      cells.add(line);
    }
    return new Table(
        what + ", and the share of even vertices in per cent",
        1,
        columns(what, "Polygons"),
        cells,
        List.of("All shapes together, " + Bin.FEWEST_VERTICES + " vertices or more. " + WORDS));
  }

  private static Table files(List<StudyRow> rows) {
    List<List<String>> cells = new ArrayList<>();
    for (StudyRow row : rows) {
      List<String> line = new ArrayList<>();
      line.add(row.trial().shape());
      line.add(String.valueOf(row.trial().n()));
      line.add(String.valueOf(row.count(PolygonsColumns.REFLEX)));
      line.add(String.valueOf(row.count(PolygonsColumns.PIECES)));
      addMethods(line, List.of(row));
      cells.add(line);
    }
    return new Table(
        "Share of even vertices of the given polygons in per cent",
        1,
        columns("File", "Vertices", "Reflex vertices", "Convex pieces"),
        cells,
        List.of());
  }
}
