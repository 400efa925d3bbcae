package dct.experiment.study;

import java.util.List;

/**
 * A table for people; immutable.
 *
 * @param title what it shows
 * @param keys how many columns, the first ones, name the rows
 * @param columns the heads of the columns; one in small letters goes on from that before it
 * @param rows the cells, as many in each row as there are columns
 * @param notes what has to be known to read it, a sentence each
 */
public record Table(
    String title, int keys, List<String> columns, List<List<String>> rows, List<String> notes) {

  /** Checks that the rows are whole. */
  public Table {
    columns = List.copyOf(columns);
    rows = rows.stream().map(List::copyOf).toList();
    notes = List.copyOf(notes);
    for (List<String> row : rows) {
      if (row.size() != columns.size()) {
        throw new IllegalArgumentException(row + " has not " + columns.size() + " cells");
      }
    }
  }

  /** Whether a column is set flush right: most of its cells begin with a digit. */
  boolean isNumeric(int column) {
    long numbers =
        rows.stream()
            .map(row -> row.get(column).replace("−", ""))
            .filter(cell -> !cell.isEmpty() && Character.isDigit(cell.charAt(0)))
            .count();
    return 2 * numbers > rows.size();
  }
}
