package dct.ui.command;

import java.util.function.Consumer;
import javax.swing.JMenu;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;

/** A menu that is filled each time it is opened. */
final class LazyMenu extends JMenu implements MenuListener {
  private static final long serialVersionUID = 1L;

  private final transient Consumer<JMenu> fill;

  LazyMenu(String name, Consumer<JMenu> fill) {
    super(name);
    this.fill = fill;
    setName(name);
    addMenuListener(this);
    fill.accept(this);
  }

  @Override
  public void menuSelected(MenuEvent e) {
    removeAll();
    fill.accept(this);
    Mnemonics.give(this);
  }

  @Override
  public void menuDeselected(MenuEvent e) {
    // what it shows stays until it is opened again
  }

  @Override
  public void menuCanceled(MenuEvent e) {
    // likewise
  }
}
