package dct.ui.command;

import java.util.List;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;

/** A menu of commands, which are looked up by their names. */
public final class CommandMenu extends JMenu {
  private static final long serialVersionUID = 1L;

  /** Stands for a line between items. */
  public static final String LINE = "-";

  /**
   * What a menu holds, from top to bottom.
   *
   * @param title its title; Alt and a letter of it open it
   * @param items names of commands or of menus, and lines
   */
  public record Plan(String title, List<String> items) {
    /** A plan of these items. */
    public static Plan of(String title, String... items) {
      return new Plan(title, List.of(items));
    }
  }

  private CommandMenu(Plan plan, CommandRegistry registry) {
    super(plan.title());
    setName(plan.title());
    for (String name : plan.items()) {
      if (name.equals(LINE)) {
        addSeparator();
      } else {
        add(
            registry
                .submenu(name)
                .map(JMenuItem.class::cast)
                .orElseGet(() -> item(registry.get(name))));
      }
    }
    Mnemonics.give(this);
  }

  private static JMenuItem item(Command command) {
    JMenuItem item = command.isSwitch() ? new JCheckBoxMenuItem(command) : new JMenuItem(command);
    item.setName(command.id());
    item.setToolTipText(null); // a menu shows the key itself
    return item;
  }

  /**
   * A menu bar.
   *
   * @throws java.util.NoSuchElementException if the registry lacks a command of a plan
   */
  public static JMenuBar bar(List<Plan> plans, CommandRegistry registry) {
    JMenuBar bar = new JMenuBar();
    List<CommandMenu> menus = plans.stream().map(plan -> new CommandMenu(plan, registry)).toList();
    Mnemonics.give(menus);
    menus.forEach(bar::add);
    return bar;
  }
}
