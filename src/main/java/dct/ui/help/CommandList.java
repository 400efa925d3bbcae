package dct.ui.help;

import dct.ui.command.CloseKeys;
import dct.ui.command.TableKeys;
import dct.ui.dialog.Placement;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Frame;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.ListSelectionModel;
import javax.swing.table.DefaultTableCellRenderer;

/**
 * Help ▸ Commands and Keys: everything that can be done, and how, by menu. A field above narrows it
 * to the lines that hold some words. The window beside it can be used on.
 */
public final class CommandList extends JDialog {
  private static final long serialVersionUID = 1L;
  private static final int[] WIDTHS = {98, 256, 158, 508};
  private static final int ROW = 24;

  private final JTextField field = new JTextField(24);
  private final CommandLinesModel model;

  private CommandList(Frame owner, List<CommandLines> lines, Consumer<String> said) {
    super(owner, "Commands and Keys");
    setName("commandList");
    model = new CommandLinesModel(lines);
    JPanel content = new JPanel(new BorderLayout(0, 8));
    content.setBorder(BorderFactory.createEmptyBorder(10, 10, 10, 10));
    content.add(search(), BorderLayout.NORTH);
    JScrollPane scroll = new JScrollPane(table(said));
    scroll.setPreferredSize(new Dimension(1020, 620));
    content.add(scroll, BorderLayout.CENTER);
    setContentPane(content);
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
    CloseKeys.close(this);
    Placement.over(this, owner);
  }

  /**
   * Shows the list beside the window.
   *
   * @param said is told what was copied
   */
  static void show(Frame owner, List<CommandLines> lines, Consumer<String> said) {
    new CommandList(owner, lines, said).setVisible(true);
  }

  private JComponent search() {
    JLabel label = new JLabel("Search:");
    label.setDisplayedMnemonic('s');
    label.setLabelFor(field);
    field.setName("searchCommands");
    field.setToolTipText("Shows the lines that hold all these words");
    field.getDocument().addDocumentListener(new Typing(() -> model.search(field.getText())));
    JPanel line = new JPanel(new BorderLayout(8, 0));
    line.add(label, BorderLayout.WEST);
    line.add(field, BorderLayout.CENTER);
    return line;
  }

  private JTable table(Consumer<String> said) {
    JTable table = new JTable(model);
    table.setName("commands");
    table.getAccessibleContext().setAccessibleName("Commands and keys");
    table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    table.setRowHeight(ROW);
    TableKeys.inDialog(table);
    TableKeys.tellOfCopies(table, said);
    table.setDefaultRenderer(Object.class, new Cells());
    for (int column = 0; column < WIDTHS.length; column++) {
      table.getColumnModel().getColumn(column).setPreferredWidth(WIDTHS[column]);
    }
    return table;
  }

  /** A group is named in its first line; what does not fit in is shown under the mouse. */
  private final class Cells extends DefaultTableCellRenderer {
    private static final long serialVersionUID = 1L;

    @Override
    public Component getTableCellRendererComponent(
        JTable table, Object value, boolean selected, boolean focused, int row, int column) {
      boolean repeated = column == 0 && !model.beginsGroup(row);
      Object shown = repeated ? "" : value;
      super.getTableCellRendererComponent(table, shown, selected, focused, row, column);
      setFont(column == 0 ? table.getFont().deriveFont(Font.BOLD) : table.getFont());
      setToolTipText(String.valueOf(value));
      return this;
    }
  }
}
