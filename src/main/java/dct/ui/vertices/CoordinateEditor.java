package dct.ui.vertices;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.Component;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.DefaultCellEditor;
import javax.swing.JTable;
import javax.swing.JTextField;

/** Takes a coordinate; a text that is none stays in its cell, until it is mended or given up. */
final class CoordinateEditor extends DefaultCellEditor {
  private static final long serialVersionUID = 1L;

  private final JTextField field;
  private final transient VertexRows rows;
  private final transient Consumer<String> complain;
  private int row;
  private int column;

  /** An editor of cells of these rows; says what is wrong with a text. */
  CoordinateEditor(VertexRows rows, Consumer<String> complain) {
    super(new JTextField());
    this.rows = rows;
    this.complain = complain;
    field = (JTextField) getComponent();
    field.setName("coordinate");
    field.setBorder(BorderFactory.createEmptyBorder(0, 2, 0, 2));
    field.setHorizontalAlignment(JTextField.TRAILING);
  }

  @Override
  public Component getTableCellEditorComponent(
      JTable table, Object value, boolean selected, int row, int column) {
    this.row = row;
    this.column = column;
    super.getTableCellEditorComponent(table, value, selected, row, column);
    field.putClientProperty(FlatClientProperties.OUTLINE, null);
    field
        .getAccessibleContext()
        .setAccessibleName((column == VertexRows.X ? "x" : "y") + " of v" + row);
    field.selectAll();
    return field;
  }

  @Override
  public boolean stopCellEditing() {
    Optional<String> fault = rows.fault(field.getText(), row, column);
    if (fault.isEmpty()) {
      return super.stopCellEditing();
    }
    field.putClientProperty(FlatClientProperties.OUTLINE, FlatClientProperties.OUTLINE_ERROR);
    field.selectAll();
    complain.accept(fault.get());
    return false;
  }
}
