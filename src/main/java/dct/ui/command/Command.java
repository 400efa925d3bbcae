package dct.ui.command;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;

/** Something that a menu, a button or a key can do. */
public final class Command extends AbstractAction {
  private static final long serialVersionUID = 1L;

  private final String id;
  private final String description;
  private final transient Runnable run;
  private final transient List<KeyStroke> keys = new ArrayList<>();
  private transient BooleanSupplier condition = () -> true;
  private transient BooleanSupplier selection; // null if the command is neither on nor off
  private transient Supplier<String> name;
  private transient Supplier<Optional<Command>> inFront = Optional::empty;

  /**
   * A command that is always enabled.
   *
   * @param id what it is called, in tables of commands and as long as nothing else is said
   * @param key as {@link KeyStroke#getKeyStroke(String)} takes it; empty for none
   * @param description a sentence for the tooltip and the list of commands
   */
  public Command(String id, String key, String description, Runnable run) {
    super(id);
    this.id = id;
    this.description = description;
    this.run = run;
    this.name = () -> id;
    if (!key.isEmpty()) {
      KeyStroke stroke = stroke(key);
      keys.add(stroke);
      putValue(ACCELERATOR_KEY, stroke);
    }
    putValue(SHORT_DESCRIPTION, key.isEmpty() ? description : description + " (" + keyText() + ")");
  }

  private static KeyStroke stroke(String key) {
    KeyStroke stroke = KeyStroke.getKeyStroke(key);
    if (stroke == null) {
      throw new IllegalArgumentException("there is no key " + key);
    }
    return stroke;
  }

  /** Gives the command further keys, which menus do not show. */
  public Command alsoOn(String... others) {
    for (String key : others) {
      keys.add(stroke(key));
    }
    return this;
  }

  /** Makes the command depend on a condition, looked at by {@link #refresh}. */
  public Command enabledWhen(BooleanSupplier condition) {
    this.condition = condition;
    refresh();
    return this;
  }

  /** Makes the command one that is on or off, looked at by {@link #refresh}. */
  public Command selectedWhen(BooleanSupplier on) {
    selection = on;
    refresh();
    return this;
  }

  /** Makes the name depend on the state, looked at by {@link #refresh}. */
  public Command named(Supplier<String> supplier) {
    name = supplier;
    refresh();
    return this;
  }

  /** Says which command is done in place of this one, while there is one. */
  void setInFront(Supplier<Optional<Command>> other) {
    inFront = other;
  }

  private Command done() {
    return inFront.get().orElse(this);
  }

  /** Brings name, enablement and selection up to date. */
  public void refresh() {
    Command done = done();
    putValue(Action.NAME, done.name.get());
    setEnabled(done.condition.getAsBoolean());
    if (selection != null) {
      putValue(Action.SELECTED_KEY, done.selection != null && done.selection.getAsBoolean());
    }
  }

  /** What tables of commands call it, whatever the state. */
  public String id() {
    return id;
  }

  /** The name as it is now. */
  public String name() {
    return (String) getValue(Action.NAME);
  }

  /** What the command does. */
  public String description() {
    return description;
  }

  /** Whether the command is one that is on or off. */
  public boolean isSwitch() {
    return selection != null;
  }

  /** All its keys, the one that menus show first. */
  public List<KeyStroke> keys() {
    return List.copyOf(keys);
  }

  /** Its key for a person to read; empty if it has none. */
  public String keyText() {
    return getValue(ACCELERATOR_KEY) instanceof KeyStroke key ? text(key) : "";
  }

  /** All its keys for a person to read, as "Ctrl+Shift+Z or Ctrl+Y". */
  public String keyTexts() {
    return keys.stream().map(Command::text).collect(Collectors.joining(" or "));
  }

  /** A key for a person to read, as "Ctrl+Shift+Z". */
  static String text(KeyStroke key) {
    String modifiers = InputEvent.getModifiersExText(key.getModifiers());
    String main = KeyEvent.getKeyText(key.getKeyCode());
    return modifiers.isEmpty() ? main : modifiers + "+" + main;
  }

  /** Does it, if it is enabled. */
  public void perform() {
    if (isEnabled()) {
      done().run.run();
    }
  }

  @Override
  public void actionPerformed(ActionEvent e) {
    if (!isTyping()) {
      perform();
    }
    if (isSwitch()) {
      refresh(); // a button has turned the switch already, whatever came of it
    }
  }

  /** Whether the event is a plain key that belongs to the text which is being typed. */
  private static boolean isTyping() {
    return EventQueue.getCurrentEvent() instanceof KeyEvent key
        && !key.isControlDown()
        && !key.isAltDown()
        && !key.isMetaDown()
        && !key.isActionKey()
        && takesText(key.getComponent());
  }

  /** Whether what is typed there becomes text: in a field, or in a cell of a table. */
  private static boolean takesText(Component component) {
    if (component instanceof JTextComponent text) {
      return text.isEditable();
    }
    Component around = SwingUtilities.getAncestorOfClass(JTable.class, component);
    return (component instanceof JTable table && table.isEditing())
        || (around instanceof JTable other && other.isEditing());
  }
}
