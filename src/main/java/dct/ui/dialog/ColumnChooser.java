package dct.ui.dialog;

import dct.core.Decimals;
import dct.io.format.Choice;
import dct.io.format.Columns;
import dct.io.format.UnclearColumns;
import dct.ui.command.TableKeys;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSpinner;
import javax.swing.JTable;
import javax.swing.SpinnerNumberModel;
import javax.swing.table.AbstractTableModel;

/** Asks which columns of a text are x and y, beside its first rows. */
final class ColumnChooser {
  private static final int GAP = 8;
  private static final int MOST_SKIPPED = 1_000_000;

  private final UnclearColumns unclear;
  private final JComboBox<Integer> x;
  private final JComboBox<Integer> y;
  private final JSpinner skipped;

  private ColumnChooser(UnclearColumns unclear) {
    this.unclear = unclear;
    int width = unclear.rows().get(0).length;
    Integer[] numbers = IntStream.rangeClosed(1, width).boxed().toArray(Integer[]::new);
    Columns.Pair likely = unclear.likely().xy().orElse(new Columns.Pair(1, 2));
    x = new JComboBox<>(numbers);
    y = new JComboBox<>(numbers);
    x.setSelectedItem(likely.x());
    y.setSelectedItem(likely.y());
    int least = unclear.likely().skipped(); // read with fewer, it would be as unclear again
    skipped = new JSpinner(new SpinnerNumberModel(least, least, MOST_SKIPPED, 1));
  }

  /**
   * Asks; returns how to read the text again, or nothing if it shall not be read.
   *
   * @param before how it has been read
   */
  static Optional<Choice> ask(
      Component parent, String title, UnclearColumns unclear, Choice before) {
    return new ColumnChooser(unclear).ask(parent, title, before);
  }

  private Optional<Choice> ask(Component parent, String title, Choice before) {
    return Ask.fill(parent, title, panel(), x::requestFocusInWindow)
        ? Optional.of(before.with(chosen()))
        : Optional.empty();
  }

  private Columns chosen() {
    Columns.Pair pair =
        new Columns.Pair((Integer) x.getSelectedItem(), (Integer) y.getSelectedItem());
    return new Columns(Optional.of(pair), (Integer) skipped.getValue());
  }

  private JComponent panel() {
    JPanel panel = new JPanel(new BorderLayout(0, GAP));
    String place = unclear.line() > 0 ? "Line " + unclear.line() + ": " : "";
    String fault = unclear.fault().replaceFirst("; .*", "");
    panel.add(new JLabel(place + fault + "."), BorderLayout.NORTH);
    JScrollPane rows = new JScrollPane(table());
    panel.add(rows, BorderLayout.CENTER);
    Fields fields = new Fields();
    fields.ask("Column of x:", 'x', "xColumn", x, "Its number, from 1 on");
    fields.ask("Column of y:", 'y', "yColumn", y, "Its number, from 1 on");
    fields.ask("Lines to skip:", 'l', "skipped", skipped, "Lines at the front without vertices");
    panel.add(fields, BorderLayout.SOUTH);
    return panel;
  }

  private JTable table() {
    JTable table = new JTable(new Rows());
    TableKeys.inDialog(table);
    table.setName("rows");
    table.getAccessibleContext().setAccessibleName("The first rows");
    table.setFocusable(false);
    table.setRowSelectionAllowed(false);
    table.setPreferredScrollableViewportSize(
        new Dimension(440, table.getRowHeight() * UnclearColumns.ROWS));
    return table;
  }

  /** The first rows; the columns are called by their numbers. */
  private final class Rows extends AbstractTableModel {
    private static final long serialVersionUID = 1L;

    @Override
    public int getRowCount() {
      return unclear.rows().size();
    }

    @Override
    public int getColumnCount() {
      return unclear.rows().get(0).length;
    }

    @Override
    public String getColumnName(int column) {
      return Integer.toString(column + 1);
    }

    @Override
    public Object getValueAt(int row, int column) {
      return Decimals.format(unclear.rows().get(row)[column]);
    }
  }
}
