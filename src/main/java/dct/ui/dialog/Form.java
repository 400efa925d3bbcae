package dct.ui.dialog;

import java.awt.Component;
import java.util.Locale;
import javax.swing.JButton;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;

/** Questions below each other, asked in a dialog whose Enter key is OK. */
public abstract class Form extends Fields {
  private static final long serialVersionUID = 1L;

  /** The field that is answered first. */
  protected abstract JTextField first();

  /** Adds the button that copies the call of the program that does the same. */
  protected final void offerCopy(Runnable copy) {
    JButton button = new JButton("Copy as Command Line");
    button.addActionListener(e -> copy.run());
    offer(button, 'l', "copyCall", "Copies the dct command that does the same");
  }

  /** Asks, the first field ready to be typed over; whether OK was chosen. */
  public final boolean show(Component parent, String title) {
    HeldKey.typesNothing(); // what follows is no longer known as the work of a key
    SwingUtilities.updateComponentTreeUI(this); // the look may have changed since it was made
    return Ask.fill(
        parent,
        title,
        this,
        () -> {
          first().selectAll();
          first().requestFocusInWindow();
        });
  }

  /**
   * The whole number in a field.
   *
   * @throws IllegalArgumentException if there is none of these; the message says so
   */
  protected static long whole(JTextField field, long least, long most, String what) {
    String typed = field.getText().strip();
    try {
      long number = Long.parseLong(typed);
      if (number >= least && number <= most) {
        return number;
      }
    } catch (NumberFormatException e) {
      // is answered below, as a number that is too small or too large is
    }
    throw new IllegalArgumentException(
        String.format(
            Locale.ROOT,
            "“%s” is no %s; type a whole number from %d to %d.",
            typed,
            what,
            least,
            most));
  }
}
