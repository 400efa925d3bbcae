package dct.ui.command;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuItem;

/** A menu of commands, which it can list. */
public final class CommandMenu extends JMenu {
  private static final long serialVersionUID = 1L;

  private final transient List<Command> commands = new ArrayList<>();

  /** An empty menu, opened by Alt and the first letter of its title. */
  public CommandMenu(String title) {
    super(title);
    setName(title);
    setMnemonic(title.charAt(0));
  }

  /** Adds a command. */
  public CommandMenu with(Command command) {
    commands.add(command);
    add(named(new JMenuItem(command), command));
    return this;
  }

  /** Adds a command that is on or off. */
  public CommandMenu withSwitch(Command command, boolean on) {
    commands.add(command);
    JCheckBoxMenuItem item = new JCheckBoxMenuItem(command);
    item.setSelected(on);
    add(named(item, command));
    return this;
  }

  private static JMenuItem named(JMenuItem item, Command command) {
    item.setName(command.name());
    item.setToolTipText(null); // a menu shows the key itself
    return item;
  }

  /** Adds a menu within this one. */
  public CommandMenu with(JMenu menu) {
    add(menu);
    return this;
  }

  /** Adds a line. */
  public CommandMenu line() {
    addSeparator();
    return this;
  }

  /** The commands, in the order of the menu. */
  public List<Command> commands() {
    return List.copyOf(commands);
  }
}
