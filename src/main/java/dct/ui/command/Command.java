package dct.ui.command;

import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.KeyStroke;

/** Something that a menu, a button or a key can do. */
public final class Command extends AbstractAction {
  private static final long serialVersionUID = 1L;

  private final String description;
  private final transient Runnable run;
  private transient BooleanSupplier condition = () -> true;
  private transient Supplier<String> name;

  /**
   * A command that is always enabled.
   *
   * @param key as {@link KeyStroke#getKeyStroke(String)} takes it; empty for none
   * @param description a sentence for the tooltip and the list of commands
   */
  public Command(String name, String key, String description, Runnable run) {
    super(name);
    this.description = description;
    this.run = run;
    this.name = () -> name;
    if (!key.isEmpty()) {
      putValue(ACCELERATOR_KEY, KeyStroke.getKeyStroke(key));
    }
    putValue(SHORT_DESCRIPTION, key.isEmpty() ? description : description + " (" + keyText() + ")");
  }

  /** Makes the command depend on a condition, looked at by {@link #refresh}. */
  public Command enabledWhen(BooleanSupplier condition) {
    this.condition = condition;
    refresh();
    return this;
  }

  /** Makes the name depend on the state, looked at by {@link #refresh}. */
  public Command named(Supplier<String> supplier) {
    name = supplier;
    refresh();
    return this;
  }

  /** Brings name and enablement up to date. */
  public void refresh() {
    putValue(Action.NAME, name.get());
    setEnabled(condition.getAsBoolean());
  }

  /** The name as it is now. */
  public String name() {
    return (String) getValue(Action.NAME);
  }

  /** What the command does. */
  public String description() {
    return description;
  }

  /** Its key for a person to read; empty if it has none. */
  public String keyText() {
    return getValue(ACCELERATOR_KEY) instanceof KeyStroke key ? text(key) : "";
  }

  /** A key for a person to read, as "Ctrl+Shift+Z". */
  static String text(KeyStroke key) {
    String modifiers = InputEvent.getModifiersExText(key.getModifiers());
    String main = KeyEvent.getKeyText(key.getKeyCode());
    return modifiers.isEmpty() ? main : modifiers + "+" + main;
  }

  @Override
  public void actionPerformed(ActionEvent e) {
    run.run();
  }
}
