package dct.ui.edit;

import dct.core.Decimals;
import dct.ui.dialog.Ask;
import dct.ui.dialog.Form;
import dct.ui.tool.Snap;
import java.awt.Component;
import java.util.Locale;
import javax.swing.JTextField;

/** Snap ▸ Snap Settings…: the size of the grid and the angle. */
final class SnapForm extends Form {
  private static final long serialVersionUID = 1L;
  static final String TITLE = "Snap Settings";
  private static final int COLUMNS = 12;
  private static final double MOST_DEGREES = 180;

  private final JTextField grid;
  private final JTextField angle;

  private SnapForm(Snap snap) {
    grid = new JTextField(Decimals.format(snap.grid()), COLUMNS);
    angle = new JTextField(Decimals.format(snap.angle()), COLUMNS);
    ask("Size of the grid:", 's', "grid", grid, "The distance of its lines");
    ask("Angle in degrees:", 'a', "angle", angle, "Directions are multiples of it");
  }

  /** Asks until the answers can be used, or Cancel is chosen; whether they were. */
  static boolean ask(Component parent, Snap snap) {
    SnapForm form = new SnapForm(snap);
    while (form.show(parent, TITLE)) {
      try {
        double size = number(form.grid, Double.MAX_VALUE, "size of a grid; type a number above 0.");
        double degrees =
            number(form.angle, MOST_DEGREES, "angle; type a number above 0, up to 180.");
        snap.setGrid(size);
        snap.setAngle(degrees);
        return true;
      } catch (IllegalArgumentException e) {
        Ask.sorry(parent, TITLE, e.getMessage());
      }
    }
    return false;
  }

  @Override
  protected JTextField first() {
    return grid;
  }

  /** The number that was typed, which is to be above 0 and at most the largest. */
  private static double number(JTextField field, double most, String what) {
    String typed = field.getText().strip();
    double number = Decimals.parse(typed);
    if (number > 0 && number <= most) {
      return number;
    }
    throw new IllegalArgumentException(String.format(Locale.ROOT, "“%s” is no %s", typed, what));
  }
}
