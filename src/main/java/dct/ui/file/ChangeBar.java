package dct.ui.file;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.UIManager;

/**
 * A line above the canvas which says that the file of the document is not what it was, with buttons
 * for what can be done about it. It takes no keyboard focus when it comes.
 */
final class ChangeBar extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final int GAP = 8;

  private final JLabel sentence = new JLabel();
  private final JPanel buttons = new JPanel(new FlowLayout(FlowLayout.LEADING, GAP, 0));

  /** What a button does. */
  record Answer(String name, char mnemonic, String description, Runnable action) {}

  /** A bar that is not shown yet. */
  ChangeBar() {
    setLayout(new BoxLayout(this, BoxLayout.LINE_AXIS));
    setName("changeBar");
    sentence.setName("fileChange");
    sentence.setMinimumSize(new Dimension(0, 0)); // of the two, the buttons keep their size
    buttons.setOpaque(false);
    add(sentence);
    add(buttons);
    setVisible(false);
    recolour();
  }

  /** Shows a sentence and its answers; the buttons stay if it is the sentence that is there. */
  void show(String words, Iterable<Answer> answers) {
    if (isVisible() && words.equals(sentence.getText())) {
      return;
    }
    sentence.setText(words);
    sentence.setToolTipText(words); // where it does not fit
    getAccessibleContext().setAccessibleName("File changed");
    getAccessibleContext().setAccessibleDescription(words);
    buttons.removeAll();
    Consumer<Answer> add =
        answer -> {
          JButton button = new JButton(answer.name());
          button.setName(answer.name());
          button.setMnemonic(answer.mnemonic());
          button.setToolTipText(answer.description());
          button.addActionListener(e -> answer.action().run());
          buttons.add(button);
        };
    answers.forEach(add);
    setVisible(true);
    revalidate();
    repaint();
  }

  @Override
  public void updateUI() {
    super.updateUI();
    recolour();
  }

  /** In the colour of tool tips, which every look has for what is said beside the work. */
  private void recolour() {
    Color ground = UIManager.getColor("ToolTip.background");
    Color line = UIManager.getColor("Component.borderColor");
    setBackground(ground);
    setBorder(
        BorderFactory.createCompoundBorder(
            BorderFactory.createMatteBorder(0, 0, 1, 0, line == null ? Color.GRAY : line),
            BorderFactory.createEmptyBorder(GAP / 2, GAP, GAP / 2, GAP)));
  }
}
