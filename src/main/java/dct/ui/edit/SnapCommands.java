package dct.ui.edit;

import dct.core.Decimals;
import dct.ui.command.CommandRegistry;
import dct.ui.dialog.Ask;
import dct.ui.session.Settings;
import dct.ui.tool.Snap;
import java.awt.Component;
import java.awt.GridLayout;
import java.util.OptionalDouble;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JTextField;

/** The commands that say what places snap to, with Ipe's keys. */
public final class SnapCommands {
  private static final String TITLE = "Snap Settings";
  private static final int GAP = 8;

  private final Component parent;
  private final Snap snap;
  private final Settings settings;

  private SnapCommands(Component parent, Snap snap, Settings settings) {
    this.parent = parent;
    this.snap = snap;
    this.settings = settings;
  }

  /** Sets what was set in the run before, and offers the commands. */
  public static void offer(
      CommandRegistry commands, Component parent, Snap snap, Settings settings) {
    SnapMemory.restore(snap, settings);
    SnapCommands offered = new SnapCommands(parent, snap, settings);
    offered.toggle(
        commands,
        "Snap to Vertices",
        "F4",
        "Places vertices within reach of another exactly on it",
        Snap.To.VERTICES);
    offered.toggle(
        commands,
        "Snap to Edges",
        "F5",
        "Places vertices within reach of an edge exactly on it",
        Snap.To.EDGES);
    offered.toggle(
        commands, "Snap to Grid", "F7", "Shows a grid and places vertices on it", Snap.To.GRID);
    offered.toggle(
        commands,
        "Snap to Angles",
        "F9",
        "Draws and drags in directions of some angles; with Shift, of right angles",
        Snap.To.ANGLES);
    commands.add(TITLE + "…", "", "Sets the size of the grid and the angle", offered::ask);
  }

  private void toggle(
      CommandRegistry commands, String name, String key, String description, Snap.To to) {
    commands.add(name, key, description, () -> toggle(to)).selectedWhen(() -> snap.isOn(to));
  }

  private void toggle(Snap.To to) {
    snap.toggle(to);
    SnapMemory.remember(snap, settings);
  }

  private void ask() {
    JTextField grid = new JTextField(Decimals.format(snap.grid()), 8);
    JTextField angle = new JTextField(Decimals.format(snap.angle()), 8);
    JPanel questions = new JPanel(new GridLayout(0, 2, GAP, GAP));
    add(questions, "Size of the grid:", "grid", grid);
    add(questions, "Angle in degrees:", "angle", angle);
    while (JOptionPane.showConfirmDialog(
            parent, questions, TITLE, JOptionPane.OK_CANCEL_OPTION, JOptionPane.PLAIN_MESSAGE)
        == JOptionPane.OK_OPTION) {
      OptionalDouble size = number(grid, Double.MAX_VALUE);
      OptionalDouble degrees = number(angle, 180);
      if (size.isEmpty()) {
        sorry(grid, "size of a grid; type a number above 0.");
      } else if (degrees.isEmpty()) {
        sorry(angle, "angle; type a number above 0, up to 180.");
      } else {
        snap.setGrid(size.getAsDouble());
        snap.setAngle(degrees.getAsDouble());
        SnapMemory.remember(snap, settings);
        return;
      }
    }
  }

  private static void add(JPanel questions, String question, String name, JTextField answer) {
    JLabel label = new JLabel(question);
    label.setLabelFor(answer);
    answer.setName(name);
    questions.add(label);
    questions.add(answer);
  }

  /** The number that was typed, if it is above 0 and not above the most. */
  private static OptionalDouble number(JTextField field, double most) {
    try {
      double number = Double.parseDouble(field.getText().strip());
      return number > 0 && number <= most ? OptionalDouble.of(number) : OptionalDouble.empty();
    } catch (NumberFormatException e) {
      return OptionalDouble.empty();
    }
  }

  private void sorry(JTextField field, String what) {
    Ask.sorry(parent, TITLE, "“" + field.getText().strip() + "” is no " + what);
  }
}
