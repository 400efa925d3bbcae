package dct.ui.study;

import dct.experiment.study.Study;
import dct.experiment.study.StudyRow;
import java.util.ArrayList;
import java.util.List;
import javax.swing.table.AbstractTableModel;

/** The rows of a study as a table: what was tried, then what was counted. */
final class RowsModel extends AbstractTableModel {
  private static final long serialVersionUID = 1L;
  private static final List<String> TRIAL = List.of("shape", "n", "set", "seed");

  private transient List<StudyRow> rows = List.of();
  private transient List<String> counts = List.of();

  /** Shows these rows of this study in place of those there were. */
  void show(Study study, List<StudyRow> shown) {
    boolean sameColumns = counts.equals(study.counts());
    rows = new ArrayList<>(shown);
    counts = study.counts();
    if (sameColumns) {
      fireTableDataChanged();
    } else {
      fireTableStructureChanged();
    }
  }

  /** Adds rows below. */
  void add(List<StudyRow> more) {
    if (!more.isEmpty()) {
      rows.addAll(more);
      fireTableRowsInserted(rows.size() - more.size(), rows.size() - 1);
    }
  }

  /** The row of this index. */
  StudyRow row(int index) {
    return rows.get(index);
  }

  /** All rows. */
  List<StudyRow> rows() {
    return List.copyOf(rows);
  }

  @Override
  public int getRowCount() {
    return rows.size();
  }

  @Override
  public int getColumnCount() {
    return TRIAL.size() + counts.size();
  }

  @Override
  public String getColumnName(int column) {
    return column < TRIAL.size()
        ? TRIAL.get(column)
        : counts.get(column - TRIAL.size()).replace('_', ' ');
  }

  @Override
  public Class<?> getColumnClass(int column) {
    return switch (column) {
      case 0 -> String.class;
      case 3 -> Long.class;
      default -> Integer.class;
    };
  }

  @Override
  public Object getValueAt(int index, int column) {
    StudyRow row = rows.get(index);
    return switch (column) {
      case 0 -> row.trial().shape();
      case 1 -> row.trial().n();
      case 2 -> row.trial().set();
      case 3 -> row.trial().seed();
      default -> row.count(counts.get(column - TRIAL.size()));
    };
  }
}
