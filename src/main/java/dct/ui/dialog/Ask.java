package dct.ui.dialog;

import java.awt.Component;
import java.util.OptionalInt;
import java.util.stream.Stream;
import javax.swing.JDialog;
import javax.swing.JOptionPane;
import javax.swing.SwingUtilities;

/**
 * Questions and messages, in sentences that wrap. Enter takes the answer by which nothing is lost,
 * Esc none.
 */
public final class Ask {

  private Ask() {}

  /** An option pane whose lines have a length that is good to read. */
  private static final class Pane extends JOptionPane {
    private static final long serialVersionUID = 1L;

    Pane(String message, int kind, int onEnter, Object... options) {
      super(Formulas.unbroken(message), kind, DEFAULT_OPTION, null, options, options[onEnter]);
    }

    @Override
    public int getMaxCharactersPerLineCount() {
      return 72;
    }
  }

  /** Says that something is wrong. */
  public static void sorry(Component parent, String title, String sentence) {
    show(parent, title, new Pane(sentence, JOptionPane.ERROR_MESSAGE, 0, "OK"));
  }

  /** Says something. */
  public static void tell(Component parent, String title, String sentence) {
    show(parent, title, new Pane(sentence, JOptionPane.INFORMATION_MESSAGE, 0, "OK"));
  }

  /**
   * Asks whether to do something by which something may be lost; Enter cancels.
   *
   * @param yes what the first button says; the second says Cancel
   * @return whether the first button was pressed
   */
  public static boolean confirm(Component parent, String title, String question, String yes) {
    return choose(parent, title, question, 1, yes, "Cancel") == 0;
  }

  /**
   * Says that something is wrong, and offers what can be done about it, or to close the message.
   *
   * @return the number of the remedy chosen
   */
  public static OptionalInt offer(
      Component parent, String title, String sentence, String... remedies) {
    String[] answers =
        Stream.concat(Stream.of(remedies), Stream.of("Close")).toArray(String[]::new);
    Pane pane = new Pane(sentence, JOptionPane.ERROR_MESSAGE, 0, (Object[]) answers);
    int chosen = chosen(parent, title, pane, answers);
    return chosen < 0 || chosen == remedies.length ? OptionalInt.empty() : OptionalInt.of(chosen);
  }

  /**
   * Asks a question of several answers; the number of the one chosen, or −1.
   *
   * @param onEnter the number of the answer that Enter gives: one by which nothing is lost
   */
  public static int choose(
      Component parent, String title, String question, int onEnter, String... answers) {
    Pane pane = new Pane(question, JOptionPane.QUESTION_MESSAGE, onEnter, (Object[]) answers);
    return chosen(parent, title, pane, answers);
  }

  /**
   * Asks by components that are to be filled in; Enter is OK.
   *
   * @param begin gives the first of them the focus
   * @return whether OK was chosen
   */
  static boolean fill(Component parent, String title, Component content, Runnable begin) {
    return choose(parent, title, content, begin, "OK", "Cancel") == 0;
  }

  /**
   * Asks by components and several answers; the number of the one chosen, or −1. Enter gives the
   * first.
   *
   * @param begin gives the first of the components the focus
   */
  static int choose(
      Component parent, String title, Component content, Runnable begin, String... answers) {
    JOptionPane pane =
        new JOptionPane(
            content,
            JOptionPane.QUESTION_MESSAGE,
            JOptionPane.DEFAULT_OPTION,
            null,
            answers,
            answers[0]) {
          private static final long serialVersionUID = 1L;

          @Override
          public void selectInitialValue() {
            super.selectInitialValue(); // makes the first answer the button of the Enter key
            begin.run();
          }
        };
    return chosen(parent, title, pane, answers);
  }

  /** Gives an answer of the question that a component is part of, as its button does. */
  static void answer(Component part, String answer) {
    ((JOptionPane) SwingUtilities.getAncestorOfClass(JOptionPane.class, part)).setValue(answer);
  }

  private static int chosen(Component parent, String title, JOptionPane pane, String... answers) {
    Object value = show(parent, title, pane);
    for (int i = 0; i < answers.length; i++) {
      if (answers[i].equals(value)) {
        return i;
      }
    }
    return -1;
  }

  private static Object show(Component parent, String title, JOptionPane pane) {
    JDialog dialog = pane.createDialog(parent, title);
    dialog.setResizable(pane.getMessage() instanceof Component); // a list may want more room
    dialog.setVisible(true); // returns when it is closed
    dialog.dispose();
    return pane.getValue();
  }
}
