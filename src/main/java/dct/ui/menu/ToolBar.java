package dct.ui.menu;

import static java.util.Map.entry;

import dct.ui.command.Command;
import dct.ui.command.CommandMenu;
import dct.ui.command.CommandRegistry;
import dct.ui.icon.ToolIcon;
import java.util.List;
import java.util.Map;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JToggleButton;
import javax.swing.JToolBar;

/** The commands that are used most, as icons below the menu bar. */
public final class ToolBar extends JToolBar {
  private static final long serialVersionUID = 1L;

  private static final Map<String, ToolIcon> ICONS =
      Map.ofEntries(
          entry("New", ToolIcon.NEW),
          entry("Open", ToolIcon.OPEN),
          entry("Save", ToolIcon.SAVE),
          entry("Undo", ToolIcon.UNDO),
          entry("Redo", ToolIcon.REDO),
          entry("Perform Flip", ToolIcon.FLIP),
          entry("Most Even Vertices", ToolIcon.MOST_EVEN),
          entry("Most Odd Vertices", ToolIcon.MOST_ODD),
          entry("Wish Parity", ToolIcon.WISH),
          entry("Zoom In", ToolIcon.ZOOM_IN),
          entry("Zoom Out", ToolIcon.ZOOM_OUT),
          entry("Fit", ToolIcon.FIT),
          entry("Vertex Numbers", ToolIcon.NUMBERS),
          entry("Legend", ToolIcon.LEGEND));

  /**
   * A bar of these commands.
   *
   * @param items names of commands that have an icon, and {@link CommandMenu#LINE}
   */
  public ToolBar(List<String> items, CommandRegistry commands) {
    super("Tool Bar");
    setName("toolBar");
    setFloatable(false);
    for (String item : items) {
      if (item.equals(CommandMenu.LINE)) {
        addSeparator();
      } else {
        add(button(commands.get(item)));
      }
    }
  }

  private static AbstractButton button(Command command) {
    AbstractButton button = command.isSwitch() ? new JToggleButton() : new JButton();
    button.setHideActionText(true);
    button.setAction(command);
    button.setIcon(ICONS.get(command.id()));
    button.setName(command.id() + ", tool bar");
    button.getAccessibleContext().setAccessibleName(command.id());
    button.setFocusable(false); // a key after the click still belongs to the canvas
    return button;
  }
}
