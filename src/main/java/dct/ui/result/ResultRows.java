package dct.ui.result;

import dct.ui.document.Result;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import javax.swing.table.AbstractTableModel;

/** The results of an instance as a table. */
final class ResultRows extends AbstractTableModel {
  private static final long serialVersionUID = 1L;
  private static final List<String> COLUMNS =
      List.of("Method", "Even", "Odd", "Bound", "Flips", "Time (s)", "Verdict");
  private static final int TIME = 5;
  static final int VERDICT = 6;

  private transient List<ResultRow> rows = List.of();
  private transient IdentityHashMap<Result, ResultRow> known =
      new IdentityHashMap<>(); // counting takes time

  /**
   * Shows these results in place of those there were.
   *
   * @return whether anything has changed
   */
  boolean show(List<Result> results) {
    IdentityHashMap<Result, ResultRow> next = new IdentityHashMap<>();
    results.forEach(
        result ->
            next.put(result, known.containsKey(result) ? known.get(result) : ResultRow.of(result)));
    known = next;
    List<ResultRow> shown = results.stream().map(next::get).toList();
    boolean changed = !shown.equals(rows);
    if (changed) {
      rows = shown;
      fireTableDataChanged();
    }
    return changed;
  }

  ResultRow row(int index) {
    return rows.get(index);
  }

  @Override
  public int getRowCount() {
    return rows.size();
  }

  @Override
  public int getColumnCount() {
    return COLUMNS.size();
  }

  @Override
  public String getColumnName(int column) {
    return COLUMNS.get(column);
  }

  @Override
  public Class<?> getColumnClass(int column) {
    return switch (column) {
      case 1, 2, 3, 4 -> Integer.class;
      case TIME -> Double.class;
      default -> String.class;
    };
  }

  /** The value in a cell; null where nothing is known. */
  @Override
  public Object getValueAt(int index, int column) {
    ResultRow row = rows.get(index);
    return switch (column) {
      case 0 -> row.title();
      case 1 -> row.even();
      case 2 -> row.odd();
      case 3 -> row.bound();
      case 4 -> row.flips().orElse(null);
      case TIME -> row.seconds().orElse(null);
      default -> row.verdict();
    };
  }

  /** A value as text: the same in every country, so that spreadsheets and scripts read it. */
  static String text(Object value) {
    if (value == null) {
      return "";
    }
    return value instanceof Double seconds
        ? String.format(Locale.ROOT, "%.4f", seconds)
        : value.toString();
  }

  /** Rows as text with their heads, a line each, the cells apart by tabs. */
  String lines(int... indices) {
    StringBuilder text = new StringBuilder(String.join("\t", COLUMNS)).append('\n');
    for (int index : indices) {
      for (int column = 0; column < COLUMNS.size(); column++) {
        text.append(column == 0 ? "" : "\t").append(text(getValueAt(index, column)));
      }
      text.append('\n');
    }
    return text.toString();
  }
}
