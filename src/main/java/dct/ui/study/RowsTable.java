package dct.ui.study;

import dct.experiment.study.StudyRow;
import dct.ui.command.TableKeys;
import java.awt.FontMetrics;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Collections;
import java.util.Map;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.SwingConstants;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableColumn;

/** The table of rows: a click on a head sorts, a double-click or Enter opens a row. */
final class RowsTable extends JTable {
  private static final long serialVersionUID = 1L;
  private static final String OPEN = "open";
  private static final int MARGIN = 28; // of a cell, with room for the arrow of the sorting
  private static final Map<String, String> WIDEST =
      Map.of("shape", "space-partitioning", "seed", "2147483647000", "n", "100000");

  private final transient Consumer<StudyRow> open;
  private final RowsModel model;

  /**
   * A table of these rows.
   *
   * @param open shows the pictures of a row
   * @param said is told what was copied
   */
  RowsTable(RowsModel model, Consumer<StudyRow> open, Consumer<String> said) {
    super(model);
    this.model = model;
    this.open = open;
    setName("rows");
    getAccessibleContext().setAccessibleName("Rows of the study");
    setAutoCreateRowSorter(true);
    setAutoResizeMode(AUTO_RESIZE_OFF);
    setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    DefaultTableCellRenderer plain = new DefaultTableCellRenderer(); // the same in every locale
    plain.setHorizontalAlignment(SwingConstants.TRAILING);
    setDefaultRenderer(Number.class, plain);
    setToolTipText("A double-click opens the pictures of a row");
    fitColumns();
    TableKeys.tellOfCopies(this, said);
    listen();
  }

  /** Makes each column as wide as its head and its widest usual cell. */
  @Override
  public void createDefaultColumnsFromModel() {
    super.createDefaultColumnsFromModel();
    if (getFont() != null) { // else the table is still being made
      fitColumns();
    }
  }

  private void fitColumns() {
    FontMetrics letters = getFontMetrics(getFont());
    for (TableColumn column : Collections.list(getColumnModel().getColumns())) {
      String head = String.valueOf(column.getHeaderValue());
      String widest = WIDEST.getOrDefault(head, head);
      column.setPreferredWidth(MARGIN + letters.stringWidth(widest));
    }
  }

  private void listen() {
    addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent e) {
            if (e.getClickCount() == 2) {
              openAt(rowAtPoint(e.getPoint()));
            }
          }
        });
    TableKeys.leaveByTab(this);
    getInputMap(WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
        .put(KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0), OPEN);
    getActionMap()
        .put(
            OPEN,
            new AbstractAction() {
              private static final long serialVersionUID = 1L;

              @Override
              public void actionPerformed(ActionEvent e) {
                openAt(getSelectedRow());
              }
            });
  }

  private void openAt(int viewRow) {
    if (viewRow >= 0) {
      open.accept(model.row(convertRowIndexToModel(viewRow)));
    }
  }
}
