package dct.ui.dialog;

import java.awt.Component;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.util.Locale;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JTextField;

/** Questions below each other, asked in a dialog whose Enter key is OK. */
public abstract class Form extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final int GAP = 4;

  private int rows;

  protected Form() {
    super(new GridBagLayout());
  }

  /** The field that is answered first. */
  protected abstract JTextField first();

  /** Adds a question; Alt with the letter leads to its answer. */
  protected final void ask(
      String question, char letter, String name, JComponent answer, String tip) {
    JLabel label = new JLabel(question);
    label.setDisplayedMnemonic(letter);
    label.setLabelFor(answer);
    answer.setName(name);
    answer.setToolTipText(tip);
    add(label, at(0, GridBagConstraints.LINE_START));
    add(answer, at(1, GridBagConstraints.LINE_START));
    rows++;
  }

  /** Adds a box to tick. */
  protected final void offer(AbstractButton box, char letter, String name, String tip) {
    box.setName(name);
    box.setMnemonic(letter);
    box.setToolTipText(tip);
    add(box, at(1, GridBagConstraints.LINE_START));
    rows++;
  }

  /** Adds the button that copies the call of the program that does the same. */
  protected final void offerCopy(Runnable copy) {
    JButton button = new JButton("Copy as Command Line");
    button.addActionListener(e -> copy.run());
    offer(button, 'l', "copyCall", "Copies the dct command that does the same");
  }

  private GridBagConstraints at(int column, int anchor) {
    GridBagConstraints at = new GridBagConstraints();
    at.gridx = column;
    at.gridy = rows;
    at.anchor = anchor;
    at.fill = column == 1 ? GridBagConstraints.HORIZONTAL : GridBagConstraints.NONE;
    at.insets = new Insets(GAP, 0, GAP, column == 0 ? 3 * GAP : 0);
    return at;
  }

  /** Asks, the first field ready to be typed over; whether OK was chosen. */
  public final boolean show(Component parent, String title) {
    JOptionPane pane =
        new JOptionPane(this, JOptionPane.QUESTION_MESSAGE, JOptionPane.OK_CANCEL_OPTION) {
          private static final long serialVersionUID = 1L;

          @Override
          public void selectInitialValue() {
            super.selectInitialValue(); // makes OK the button of the Enter key
            first().selectAll();
            first().requestFocusInWindow();
          }
        };
    JDialog dialog = pane.createDialog(parent, title);
    dialog.setVisible(true); // returns when it is closed
    dialog.dispose();
    return Integer.valueOf(JOptionPane.OK_OPTION).equals(pane.getValue());
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
