package dct.ui;

import dct.ui.command.Command;
import java.awt.Dimension;
import java.awt.Frame;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JDialog;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.table.DefaultTableModel;

/** Help ▸ Commands and Keys: everything that can be done, and how. */
final class CommandList {
  private static final String[] COLUMNS = {"Command", "Key", "What it does"};
  private static final List<String[]> MOUSE =
      List.of(
          new String[] {"Zoom", "Wheel", "Zooms at the mouse"},
          new String[] {"Pan", "Middle button, Space+drag", "Moves the picture with the mouse"},
          new String[] {
            "Give up", "Escape", "Puts a dragged vertex back, or stops what is going on"
          });

  private CommandList() {}

  /** Shows the list beside the window, which can be used on. */
  static void show(Frame owner, List<Command> commands) {
    List<String[]> rows = new ArrayList<>();
    for (Command command : commands) {
      rows.add(new String[] {command.name(), command.keyText(), command.description()});
    }
    rows.addAll(MOUSE);
    JTable table = new JTable(model(rows));
    table.setName("commands");
    table.getColumnModel().getColumn(0).setPreferredWidth(260);
    table.getColumnModel().getColumn(1).setPreferredWidth(200);
    table.getColumnModel().getColumn(2).setPreferredWidth(500);
    JDialog dialog = new JDialog(owner, "Commands and Keys");
    JScrollPane scroll = new JScrollPane(table);
    scroll.setPreferredSize(new Dimension(980, 620));
    dialog.add(scroll);
    dialog.setDefaultCloseOperation(JDialog.DISPOSE_ON_CLOSE);
    dialog.pack();
    dialog.setLocationRelativeTo(owner);
    dialog.setVisible(true);
  }

  private static DefaultTableModel model(List<String[]> rows) {
    return new DefaultTableModel(rows.toArray(String[][]::new), COLUMNS) {
      private static final long serialVersionUID = 1L;

      @Override
      public boolean isCellEditable(int row, int column) {
        return false;
      }
    };
  }
}
