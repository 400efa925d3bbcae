package dct.ui.help;

import dct.ui.command.Command;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Font;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.ListCellRenderer;
import javax.swing.UIManager;

/** A command in a list: its name and key, and below them what it does. */
public final class CommandCell extends JPanel implements ListCellRenderer<Command> {
  private static final long serialVersionUID = 1L;

  private final JLabel name = new JLabel();
  private final JLabel key = new JLabel();
  private final JLabel what = new JLabel();

  CommandCell() {
    super(new BorderLayout(12, 0));
    setBorder(BorderFactory.createEmptyBorder(4, 8, 4, 8));
    Font font = what.getFont();
    what.setFont(font.deriveFont(font.getSize2D() - 1));
    add(name, BorderLayout.CENTER);
    add(key, BorderLayout.EAST);
    add(what, BorderLayout.SOUTH);
  }

  @Override
  public Component getListCellRendererComponent(
      JList<? extends Command> list,
      Command command,
      int index,
      boolean selected,
      boolean focused) {
    name.setText(command.name());
    key.setText(command.keyText());
    what.setText(command.description());
    setBackground(selected ? list.getSelectionBackground() : list.getBackground());
    Component[] labels = {name, key, what};
    for (Component label : labels) {
      label.setForeground(selected ? list.getSelectionForeground() : list.getForeground());
      label.setEnabled(command.isEnabled());
    }
    if (!selected) {
      what.setForeground(UIManager.getColor("Label.disabledForeground"));
    }
    String state = command.isEnabled() ? "" : ", not possible now";
    getAccessibleContext().setAccessibleName(command.name() + " " + command.keyText() + state);
    getAccessibleContext().setAccessibleDescription(command.description());
    return this;
  }
}
