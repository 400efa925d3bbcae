package dct.ui.command;

import java.awt.KeyboardFocusManager;
import java.awt.event.ActionEvent;
import java.util.function.Consumer;
import java.util.function.IntSupplier;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JComponent;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.TransferHandler;

/** The keys of tables are those of other controls: none is a trap. */
public final class TableKeys {
  private static final String NOTHING = "none"; // no action: the key is left to others

  private TableKeys() {}

  /** Lets Tab leave a table; arrows move in it. */
  public static void leaveByTab(JTable table) {
    table.setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
    table.setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
  }

  /** The same, and lets Enter press the default button of the dialog that the table is in. */
  public static void inDialog(JTable table) {
    leaveByTab(table);
    table
        .getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
        .put(KeyStroke.getKeyStroke("ENTER"), NOTHING);
  }

  /** Has Copy tell of the selected rows that it took to the clipboard. */
  public static void tellOfCopies(JTable table, Consumer<String> said) {
    tellOfCopies(table, table::getSelectedRowCount, said);
  }

  /**
   * Has Copy tell of what it took to the clipboard.
   *
   * @param rows how many of them it takes now
   */
  public static void tellOfCopies(JTable table, IntSupplier rows, Consumer<String> said) {
    Action copy = TransferHandler.getCopyAction();
    table
        .getActionMap()
        .put(
            copy.getValue(Action.NAME),
            new AbstractAction() {
              private static final long serialVersionUID = 1L;

              @Override
              public void actionPerformed(ActionEvent e) {
                copy.actionPerformed(e);
                if (rows.getAsInt() > 0) {
                  said.accept(copied(rows.getAsInt()));
                }
              }
            });
  }

  /** Says that so many rows were copied. */
  public static String copied(int rows) {
    return "Copied " + rows + (rows == 1 ? " row" : " rows");
  }
}
