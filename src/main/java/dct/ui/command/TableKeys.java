package dct.ui.command;

import java.awt.KeyboardFocusManager;
import javax.swing.JComponent;
import javax.swing.JTable;
import javax.swing.KeyStroke;

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
}
