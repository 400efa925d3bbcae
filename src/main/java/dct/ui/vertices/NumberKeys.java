package dct.ui.vertices;

import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import javax.swing.JTable;
import javax.swing.JTextField;

/** Begins another coordinate with the digit, sign or point that is typed over one. */
final class NumberKeys extends KeyAdapter {
  private final JTable table;

  NumberKeys(JTable table) {
    this.table = table;
  }

  private int row() {
    return table.getSelectionModel().getLeadSelectionIndex();
  }

  private int column() {
    return table.getColumnModel().getSelectionModel().getLeadSelectionIndex();
  }

  private boolean begins(KeyEvent e) {
    boolean plain = !e.isControlDown() && !e.isAltDown() && !e.isMetaDown();
    return plain
        && !table.isEditing()
        && "0123456789+-.".indexOf(e.getKeyChar()) >= 0
        && VertexRows.isCoordinate(column())
        && row() >= 0;
  }

  /** Keeps the key from the commands of the window. */
  @Override
  public void keyPressed(KeyEvent e) {
    if (begins(e)) {
      e.consume();
    }
  }

  @Override
  public void keyTyped(KeyEvent e) {
    if (begins(e) && table.editCellAt(row(), column())) {
      e.consume();
      JTextField field = (JTextField) table.getEditorComponent();
      field.setText(String.valueOf(e.getKeyChar()));
      field.requestFocusInWindow();
    }
  }
}
