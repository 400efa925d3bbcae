package dct.ui.help;

import dct.ui.command.Command;
import dct.ui.command.CommandMenu;
import dct.ui.command.CommandMenu.Plan;
import dct.ui.command.CommandRegistry;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * Everything that can be done in a window, by menu.
 *
 * @param group the menu, or "Keys" or "Mouse" for what no menu has
 * @param name what it is called
 * @param keys how it is done without the menu; may be empty
 * @param description what it does
 */
public record CommandLines(String group, String name, String keys, String description) {
  private static final String KEYS = "Keys";

  /** The lines of all commands: those of the menus in their order, then those of no menu. */
  static List<CommandLines> of(List<Plan> menus, CommandRegistry commands) {
    List<CommandLines> lines = new ArrayList<>();
    Set<String> listed = new HashSet<>();
    for (Plan menu : menus) {
      for (String item : menu.items()) {
        listed.add(item);
        if (commands.isSubmenu(item)) {
          lines.add(new CommandLines(menu.title(), item, "", "A menu of its own"));
        } else if (!item.equals(CommandMenu.LINE)) {
          lines.add(line(menu.title(), commands.get(item)));
        }
      }
    }
    commands.all().stream()
        .filter(command -> !listed.contains(command.id()))
        .forEach(command -> lines.add(line(KEYS, command)));
    return lines;
  }

  private static CommandLines line(String group, Command command) {
    return new CommandLines(group, command.id(), command.keyTexts(), command.description());
  }

  /** Whether each of the words typed stands somewhere in the line. */
  boolean holds(String typed) {
    String all = String.join(" ", group, name, keys, description).toLowerCase(Locale.ROOT);
    for (String word : typed.strip().toLowerCase(Locale.ROOT).split(" +", -1)) {
      if (!all.contains(word)) {
        return false;
      }
    }
    return true;
  }
}
