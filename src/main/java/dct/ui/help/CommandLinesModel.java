package dct.ui.help;

import java.util.List;
import javax.swing.table.AbstractTableModel;

/** The lines of what can be done that hold the words typed. */
public final class CommandLinesModel extends AbstractTableModel {
  private static final long serialVersionUID = 1L;
  private static final String[] COLUMNS = {"Menu", "Command", "Keys", "What it does"};

  private final transient List<CommandLines> all;
  private transient List<CommandLines> shown;

  CommandLinesModel(List<CommandLines> all) {
    this.all = all;
    shown = all;
  }

  /** Shows the lines that hold each of these words. */
  void search(String typed) {
    shown = all.stream().filter(line -> line.holds(typed)).toList();
    fireTableDataChanged();
  }

  /** Whether the line above is of another group. */
  boolean beginsGroup(int row) {
    return row == 0 || !shown.get(row - 1).group().equals(shown.get(row).group());
  }

  @Override
  public int getRowCount() {
    return shown.size();
  }

  @Override
  public int getColumnCount() {
    return COLUMNS.length;
  }

  @Override
  public String getColumnName(int column) {
    return COLUMNS[column];
  }

  @Override
  public Object getValueAt(int row, int column) {
    CommandLines line = shown.get(row);
    return switch (column) {
      case 0 -> line.group();
      case 1 -> line.name();
      case 2 -> line.keys();
      default -> line.description();
    };
  }
}
