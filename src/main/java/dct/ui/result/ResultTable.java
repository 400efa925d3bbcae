package dct.ui.result;

import dct.ui.command.CloseKeys;
import dct.ui.command.TableKeys;
import dct.ui.document.Result;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.FontMetrics;
import java.awt.datatransfer.StringSelection;
import java.awt.event.ActionEvent;
import java.util.Arrays;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.SwingConstants;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableColumn;

/**
 * The table of the results of the present points: a click on a head sorts, choosing a row brings
 * its view to the front, two rows can be compared, and rows are copied as text.
 */
public final class ResultTable extends JDialog {
  private static final long serialVersionUID = 1L;
  private static final int MARGIN = 10;
  private static final Dimension SIZE = new Dimension(1100, 240);
  private static final int LEAST = 180; // of the verdict, which wraps
  private static final int ROOM = 24; // in a cell, for the arrow of the sorting

  private final ResultRows rows = new ResultRows();
  private final JTable table = new JTable(rows);
  private final JButton compare =
      button("Compare", "Shows in which edges the two chosen results differ");
  private final JButton copy =
      button("Copy", "Copies the chosen rows, or all, as text with tabs for a spreadsheet");
  private final transient Consumer<Result> bringForward;
  private final transient BiConsumer<Result, Result> comparer;
  private final transient Consumer<String> said;
  private boolean showing; // rows are being replaced: nobody has chosen anything

  /**
   * A table that is not visible yet.
   *
   * @param bringForward shows the view of a result
   * @param comparer compares two results
   * @param said is told what was copied
   */
  public ResultTable(
      JFrame owner,
      Consumer<Result> bringForward,
      BiConsumer<Result, Result> comparer,
      Consumer<String> said) {
    super(owner, "Table of Results", false);
    this.bringForward = bringForward;
    this.comparer = comparer;
    this.said = said;
    setName("resultTable");
    prepareTable();
    listen();
    layOut();
    chosen();
  }

  private static JButton button(String name, String description) {
    JButton button = new JButton(name);
    button.setName(name);
    button.setMnemonic(name.charAt(1));
    button.setToolTipText(description);
    return button;
  }

  private void prepareTable() {
    table.setName("results");
    table.getAccessibleContext().setAccessibleName("Results of these points");
    table.setAutoCreateRowSorter(true);
    TableKeys.inDialog(table);
    table.getTableHeader().setReorderingAllowed(false);
    table.setAutoResizeMode(JTable.AUTO_RESIZE_LAST_COLUMN);
    table.setDefaultRenderer(Object.class, new Cells(SwingConstants.LEADING));
    table.setDefaultRenderer(Number.class, new Cells(SwingConstants.TRAILING));
    table.setDefaultRenderer(Double.class, new Cells(SwingConstants.TRAILING));
    table.setFillsViewportHeight(true);
    TableColumn verdict = table.getColumnModel().getColumn(ResultRows.VERDICT);
    verdict.setCellRenderer(new SentenceCells());
    verdict.addPropertyChangeListener(e -> fitRows(e.getPropertyName()));
  }

  /** Makes each column as wide as what is in it; the last one takes what is left and wraps. */
  private void fitColumns() {
    FontMetrics letters = table.getFontMetrics(table.getFont());
    for (int column = 0; column < table.getColumnCount(); column++) {
      int widest = letters.stringWidth(table.getColumnName(column));
      for (int row = 0; row < table.getRowCount(); row++) {
        String text = ResultRows.text(table.getValueAt(row, column));
        widest = Math.max(widest, letters.stringWidth(text));
      }
      TableColumn model = table.getColumnModel().getColumn(column);
      boolean wraps = column == ResultRows.VERDICT;
      model.setMinWidth(wraps ? Math.min(LEAST, widest + ROOM) : widest + ROOM);
      model.setPreferredWidth(widest + ROOM);
    }
  }

  private void fitRows(String changed) {
    if ("width".equals(changed)) {
      SentenceCells.fitRows(table, ResultRows.VERDICT);
    }
  }

  private void listen() {
    table
        .getSelectionModel()
        .addListSelectionListener(
            e -> {
              if (!e.getValueIsAdjusting() && !showing) {
                chosen();
                bringChosenForward();
              }
            });
    table
        .getActionMap()
        .put(
            "copy",
            new AbstractAction() {
              private static final long serialVersionUID = 1L;

              @Override
              public void actionPerformed(ActionEvent e) {
                copy();
              }
            });
    copy.addActionListener(e -> copy());
    compare.addActionListener(e -> compare());
    getRootPane().setDefaultButton(compare);
    CloseKeys.close(this);
  }

  private void layOut() {
    JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING, MARGIN, 0));
    buttons.add(compare);
    buttons.add(copy);
    JPanel content = new JPanel(new BorderLayout(MARGIN, MARGIN));
    content.setBorder(BorderFactory.createEmptyBorder(MARGIN, MARGIN, MARGIN, MARGIN));
    JScrollPane scroll = new JScrollPane(table);
    scroll.setPreferredSize(SIZE);
    content.add(scroll, BorderLayout.CENTER);
    content.add(buttons, BorderLayout.SOUTH);
    setContentPane(content);
  }

  /** Shows these results in place of those there were; rows stay chosen if they are there still. */
  public void show(List<Result> results) {
    List<Result> before = Arrays.stream(chosenRows()).mapToObj(this::result).toList();
    showing = true;
    if (rows.show(results)) {
      fitColumns();
      SentenceCells.fitRows(table, ResultRows.VERDICT);
      for (int index = 0; index < results.size(); index++) {
        if (before.contains(results.get(index))) {
          int view = table.convertRowIndexToView(index);
          table.addRowSelectionInterval(view, view);
        }
      }
    }
    showing = false;
    chosen();
  }

  private Result result(int index) {
    return rows.row(index).result();
  }

  /** The numbers of the chosen rows, as they are seen from top to bottom. */
  private int[] chosenRows() {
    return Arrays.stream(table.getSelectedRows()).map(table::convertRowIndexToModel).toArray();
  }

  private void chosen() {
    compare.setEnabled(table.getSelectedRowCount() == 2);
    copy.setEnabled(rows.getRowCount() > 0);
  }

  private void bringChosenForward() {
    int[] chosen = chosenRows();
    if (chosen.length == 1) {
      bringForward.accept(result(chosen[0]));
    }
  }

  private void compare() {
    int[] chosen = chosenRows();
    comparer.accept(result(chosen[0]), result(chosen[1]));
  }

  private void copy() {
    int[] chosen = chosenRows();
    int[] copied =
        chosen.length > 0
            ? chosen
            : IntStream.range(0, table.getRowCount()).map(table::convertRowIndexToModel).toArray();
    getToolkit().getSystemClipboard().setContents(new StringSelection(rows.lines(copied)), null);
    said.accept(TableKeys.copied(copied.length));
  }

  /** Cells that say in full what does not fit. */
  private static final class Cells extends DefaultTableCellRenderer {
    private static final long serialVersionUID = 1L;

    Cells(int alignment) {
      setHorizontalAlignment(alignment);
    }

    @Override
    protected void setValue(Object value) {
      String text = ResultRows.text(value);
      setText(text);
      setToolTipText(text);
    }
  }
}
