package dct.ui.result;

import java.awt.Component;
import java.awt.Dimension;
import javax.swing.BorderFactory;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.table.TableCellRenderer;

/** Cells with sentences that wrap in the width of their column. */
final class SentenceCells extends JTextArea implements TableCellRenderer {
  private static final long serialVersionUID = 1L;
  private static final int MARGIN = 8;
  private static final int AMPLE = 10_000; // a height; lines are broken only where there is any

  SentenceCells() {
    setLineWrap(true);
    setWrapStyleWord(true);
  }

  @Override
  public Component getTableCellRendererComponent(
      JTable table, Object value, boolean selected, boolean focused, int row, int column) {
    String text = ResultRows.text(value);
    setText(text);
    setToolTipText(text);
    setFont(table.getFont());
    setForeground(selected ? table.getSelectionForeground() : table.getForeground());
    setBackground(selected ? table.getSelectionBackground() : table.getBackground());
    setBorder(BorderFactory.createEmptyBorder(3, MARGIN, 3, MARGIN));
    return this;
  }

  /** Makes each row of a table as high as its sentence in this column needs. */
  static void fitRows(JTable table, int column) {
    for (int row = 0; row < table.getRowCount(); row++) {
      Component cell = table.prepareRenderer(table.getCellRenderer(row, column), row, column);
      cell.setSize(new Dimension(table.getColumnModel().getColumn(column).getWidth(), AMPLE));
      table.setRowHeight(row, Math.max(table.getRowHeight(), cell.getPreferredSize().height));
    }
  }
}
