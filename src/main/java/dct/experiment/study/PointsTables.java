package dct.experiment.study;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;

/** The tables of the study of sites. */
final class PointsTables {
  private static final String NONE = "–";

  private final ThesisTable thesis = ThesisTable.read();
  private final List<StudyRow> rows;

  private PointsTables(List<StudyRow> rows) {
    this.rows = rows;
  }

  /** Table 4.4 again, the means for each size, and the times where they were kept. */
  static List<Table> of(List<StudyRow> rows) {
    PointsTables tables = new PointsTables(rows);
    return List.of(tables.table44(), tables.means(), TimesTable.of(rows));
  }

  private Table table44() {
    List<List<String>> cells =
        rows.stream()
            .filter(row -> row.trial().set() <= ThesisTable.SETS)
            .map(this::cells)
            .toList();
    return new Table(
        "Table 4.4 again: odd and even vertices of random sites",
        3,
        List.of(
            "Shape",
            "Set",
            "Points",
            "Odd before",
            "Odd after",
            "Even before",
            "Even after",
            "Increase %",
            "Thesis: odd before",
            "odd after",
            "even before",
            "even after",
            "increase %",
            "Flips",
            "Even, repeated",
            "Scans",
            "Even, best",
            "Proven"),
        cells,
        List.of(
            "Before: Delaunay. After: Scan-Flip. Repeated: Scan-Flip until it flips nothing more."
                + " Best: the best triangulation found; proven where no triangulation has more."
                + " The thesis's sets are others of the same sizes; its figures are as printed.",
            "Sets after the fifth are counted in the means and listed in the CSV file only."));
  }

  private List<String> cells(StudyRow row) {
    Trial trial = row.trial();
    List<String> cells = new ArrayList<>();
    cells.add(trial.shape());
    cells.add(String.valueOf(trial.set()));
    cells.add(String.valueOf(trial.n()));
    addCounts(cells, trial.n(), row.count(PointsColumns.BEFORE), row.count(PointsColumns.AFTER));
    Optional<ThesisTable.Row> printed =
        isThesisShape(trial) ? thesis.row(trial.set(), trial.n()) : Optional.empty();
    printed.ifPresentOrElse(
        p -> addCounts(cells, trial.n(), p.evenBefore(), p.evenAfter()),
        () -> cells.addAll(List.of(NONE, NONE, NONE, NONE, NONE)));
    cells.add(String.valueOf(row.count(PointsColumns.FLIPS)));
    cells.add(String.valueOf(row.count(PointsColumns.REPEATED)));
    cells.add(String.valueOf(row.count(PointsColumns.SCANS)));
    cells.add(String.valueOf(row.count(StudyRow.BEST)));
    cells.add(row.isProven() ? "yes" : "no");
    return cells;
  }

  private static void addCounts(List<String> cells, int n, int before, int after) {
    cells.add(String.valueOf(n - before));
    cells.add(String.valueOf(n - after));
    cells.add(String.valueOf(before));
    cells.add(String.valueOf(after));
    cells.add(percent(100.0 * (after - before) / before));
  }

  private static String percent(double value) {
    return Double.isFinite(value) ? String.format(Locale.ROOT, "%.2f", value) : NONE;
  }

  private static boolean isThesisShape(Trial trial) {
    return trial.shape().equals(ThesisTable.SHAPE);
  }

  private Table means() {
    List<List<String>> cells = new ArrayList<>();
    for (String shape : shapes()) {
      List<StudyRow> mine = rows.stream().filter(r -> r.trial().shape().equals(shape)).toList();
      Set<Integer> sizes = new LinkedHashSet<>(mine.stream().map(r -> r.trial().n()).toList());
      for (int n : sizes) {
        cells.add(
            mean(
                shape,
                n + "",
                mine.stream().filter(r -> r.trial().n() == n).toList(),
                thesis.rows(n)));
      }
      if (sizes.size() > 1) {
        cells.add(mean(shape, "all", mine, thesis.rows()));
      }
    }
    return new Table(
        "Share of even vertices in per cent: mean ± half the 95 % interval (standard deviation)",
        3,
        List.of(
            "Shape",
            "Points",
            "Sets",
            "Delaunay",
            "Scan-Flip",
            "Increase",
            "Thesis: Delaunay",
            "thesis: Scan-Flip",
            "thesis: increase",
            "Scan-Flip repeated",
            "Best",
            "Proven best"),
        cells,
        List.of());
  }

  private Set<String> shapes() {
    return new LinkedHashSet<>(rows.stream().map(row -> row.trial().shape()).toList());
  }

  private List<String> mean(
      String shape, String n, List<StudyRow> mine, List<ThesisTable.Row> theirs) {
    boolean comparable = shape.equals(ThesisTable.SHAPE);
    List<ThesisTable.Row> printed = comparable ? theirs : List.of();
    long proven = mine.stream().filter(StudyRow::isProven).count();
    return Stream.of(
            shape,
            n,
            String.valueOf(mine.size()),
            words(mine, row -> row.percent(PointsColumns.BEFORE)),
            words(mine, row -> row.percent(PointsColumns.AFTER)),
            words(mine, PointsColumns::increase),
            words(printed, row -> 100.0 * row.evenBefore() / row.n()),
            words(printed, row -> 100.0 * row.evenAfter() / row.n()),
            words(printed, ThesisTable.Row::increase),
            words(mine, row -> row.percent(PointsColumns.REPEATED)),
            words(mine, row -> row.percent(StudyRow.BEST)),
            proven + " of " + mine.size())
        .toList();
  }

  private static <T> String words(List<T> rows, ToDoubleFunction<T> value) {
    return Sample.of(rows.stream().mapToDouble(value).filter(Double::isFinite).toArray()).words();
  }
}
