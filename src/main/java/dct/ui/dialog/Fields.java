package dct.ui.dialog;

import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** Questions below each other, each with its answer on the right. */
public class Fields extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final int GAP = 4;

  private int rows;

  /** No questions yet. */
  public Fields() {
    super(new GridBagLayout());
  }

  /** Adds a question; Alt with the letter leads to its answer. */
  public final void ask(String question, char letter, String name, JComponent answer, String tip) {
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
  public final void offer(AbstractButton box, char letter, String name, String tip) {
    box.setName(name);
    box.setMnemonic(letter);
    box.setToolTipText(tip);
    add(box, at(1, GridBagConstraints.LINE_START));
    rows++;
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
}
