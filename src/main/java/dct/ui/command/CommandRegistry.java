package dct.ui.command;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.KeyStroke;

/**
 * The commands of a window, each known by its name. The parts of the window offer them here; menus,
 * buttons, the list of keys and the search for a command take them from here.
 */
public final class CommandRegistry {
  private final Map<String, Command> commands = new LinkedHashMap<>();
  private final Map<String, JMenu> submenus = new LinkedHashMap<>();
  private final Map<String, Consumer<JMenu>> fillers = new LinkedHashMap<>();
  private Optional<CommandRegistry> front = Optional.empty();
  private Runnable whenRefreshed = () -> {};

  /**
   * Takes in a command.
   *
   * @return the command
   * @throws IllegalArgumentException if there is one of that name or with one of its keys already
   */
  public Command add(Command command) {
    for (Command other : commands.values()) {
      if (command.keys().stream().anyMatch(other.keys()::contains)) {
        throw new IllegalArgumentException(
            command.id() + " and " + other.id() + " have one key, " + command.keyText());
      }
    }
    if (commands.containsKey(command.id())) {
      throw new IllegalArgumentException("there are two commands " + command.id());
    }
    commands.put(command.id(), command);
    command.setInFront(() -> front.map(part -> part.commands.get(command.id())));
    return command;
  }

  /**
   * Lets the commands of a part of the window be done in place of those that have the same names
   * here: the part is what the user works with now.
   */
  public void setFront(Optional<CommandRegistry> part) {
    front.ifPresent(old -> old.whenRefreshed = () -> {});
    front = part;
    front.ifPresent(other -> other.whenRefreshed = this::refresh);
    refresh();
  }

  /** Takes in a new command; see {@link Command}. */
  public Command add(String id, String key, String description, Runnable run) {
    return add(new Command(id, key, description, run));
  }

  /** Takes in a menu within a menu, whose items are no commands, filled each time it is opened. */
  public void addSubmenu(String name, Consumer<JMenu> fill) {
    fillers.put(name, fill);
  }

  /** The command of this name. */
  public Command get(String id) {
    Command command = commands.get(id);
    if (command == null) {
      throw new NoSuchElementException("there is no command " + id);
    }
    return command;
  }

  /** Whether this is the name of a menu within a menu. */
  public boolean isSubmenu(String name) {
    return fillers.containsKey(name);
  }

  /** The menu within a menu of this name, if there is one. */
  Optional<JMenu> submenu(String name) {
    Consumer<JMenu> fill = fillers.get(name);
    return Optional.ofNullable(fill)
        .map(f -> submenus.computeIfAbsent(name, n -> new LazyMenu(n, f)));
  }

  /** All commands, in the order in which they were taken in. */
  public List<Command> all() {
    return List.copyOf(commands.values());
  }

  /** Brings names, enablement and ticks up to date. */
  public void refresh() {
    commands.values().forEach(Command::refresh);
    whenRefreshed.run();
  }

  /** Lets the keys do what they are for, wherever in the window the focus is. */
  public void bindKeys(JComponent root) {
    bindKeys(root, JComponent.WHEN_IN_FOCUSED_WINDOW);
  }

  /** Lets the keys do what they are for while the focus is within this part of a window. */
  public void bindKeysWithin(JComponent part) {
    bindKeys(part, JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT);
  }

  private void bindKeys(JComponent root, int condition) {
    for (Command command : commands.values()) {
      for (KeyStroke key : command.keys()) {
        root.getInputMap(condition).put(key, command.id());
        root.getActionMap().put(command.id(), command);
      }
    }
  }
}
