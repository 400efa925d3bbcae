package dct.ui.solve;

import dct.ui.document.Result;
import java.awt.Component;
import java.awt.GridLayout;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.swing.JComboBox;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;

/** Asks which two results to compare: at first the last two. */
public final class CompareDialog {
  private static final String COMPARE = "Compare";

  private CompareDialog() {}

  /** Two results, the first of which is called A. */
  record Pair(Result first, Result second) {}

  /** Asks; nothing on Cancel. */
  static Optional<Pair> ask(Component parent, List<Result> results) {
    JComboBox<String> first = choice("First Result", results, results.size() - 2);
    JComboBox<String> second = choice("Second Result", results, results.size() - 1);
    JPanel panel = new JPanel(new GridLayout(0, 1, 0, 4));
    panel.add(label("A, edges of its own solid:", 'A', first));
    panel.add(first);
    panel.add(label("B, edges of its own dashed:", 'B', second));
    panel.add(second);
    JOptionPane pane =
        new JOptionPane(
            panel,
            JOptionPane.PLAIN_MESSAGE,
            JOptionPane.DEFAULT_OPTION,
            null,
            new Object[] {COMPARE, "Cancel"},
            COMPARE);
    JDialog dialog = pane.createDialog(parent, "Compare Results");
    dialog.setVisible(true); // returns when it is closed
    dialog.dispose();
    return COMPARE.equals(pane.getValue())
        ? Optional.of(
            new Pair(results.get(first.getSelectedIndex()), results.get(second.getSelectedIndex())))
        : Optional.empty();
  }

  private static JComboBox<String> choice(String name, List<Result> results, int chosen) {
    String[] titles =
        IntStream.range(0, results.size())
            .mapToObj(i -> i + 1 + ". " + results.get(i).title())
            .toArray(String[]::new);
    JComboBox<String> choice = new JComboBox<>(titles);
    choice.setName(name);
    choice.getAccessibleContext().setAccessibleName(name);
    choice.setSelectedIndex(chosen);
    return choice;
  }

  private static JLabel label(String text, char mnemonic, Component of) {
    JLabel label = new JLabel(text);
    label.setDisplayedMnemonic(mnemonic);
    label.setLabelFor(of);
    return label;
  }
}
