package dct.ui.study;

import dct.experiment.study.SizeList;
import dct.experiment.study.StudyPlan;
import java.awt.BorderLayout;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.Insets;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;

/** The fields in which the user says what a study tries. */
final class StudyOptions extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final int COLUMNS = 18;
  private static final int MOST_ROWS = 6;

  private final StudyKind kind;
  private final JTextField sizes = new JTextField(COLUMNS);
  private final JTextField sets = new JTextField(COLUMNS);
  private final JTextField seed = new JTextField("1", COLUMNS);
  private final JList<String> shapes;

  StudyOptions(StudyKind kind) {
    super(new BorderLayout(12, 0));
    this.kind = kind;
    sizes.setText(kind.sizes());
    sets.setText(String.valueOf(kind.sets()));
    shapes = new JList<>(kind.shapes().toArray(new String[0]));
    shapes.setVisibleRowCount(Math.min(MOST_ROWS, kind.shapes().size()));
    shapes.setSelectedIndices(
        kind.usualShapes().stream().mapToInt(kind.shapes()::indexOf).toArray());
    JPanel fields = new JPanel(new GridBagLayout());
    place(fields, 0, "Sizes:", sizes, "Numbers of vertices, as 50,100 or 50-500:50");
    place(fields, 1, "Sets:", sets, "How many of each shape and size");
    place(fields, 2, "Seed:", seed, "From which all others follow; the same gives the same rows");
    add(fields, BorderLayout.WEST);
    add(shapeList(), BorderLayout.CENTER);
  }

  private static void place(
      JPanel panel, int row, String title, JComponent field, String description) {
    JLabel label = new JLabel(title);
    label.setLabelFor(field);
    field.setName(title.replace(":", ""));
    field.setToolTipText(description);
    GridBagConstraints at = new GridBagConstraints();
    at.gridy = row;
    at.anchor = GridBagConstraints.LINE_END;
    at.insets = new Insets(2, 2, 2, 6);
    panel.add(label, at);
    panel.add(field, at);
  }

  private JComponent shapeList() {
    shapes.setName("Shapes");
    shapes.setToolTipText("The shapes that are tried; Ctrl+click adds one or takes it away");
    JLabel label = new JLabel("Shapes:");
    label.setLabelFor(shapes);
    JPanel panel = new JPanel(new BorderLayout(6, 0));
    panel.add(label, BorderLayout.WEST);
    panel.add(new JScrollPane(shapes), BorderLayout.CENTER);
    return panel;
  }

  /**
   * What the user wishes.
   *
   * @throws IllegalArgumentException if that cannot be; the message is a sentence for a person
   */
  StudyPlan plan() {
    List<String> chosen = shapes.getSelectedValuesList();
    if (chosen.isEmpty()) {
      throw new IllegalArgumentException("No shape is chosen; click one in the list.");
    }
    return new StudyPlan(chosen, chosenSizes(), chosenSets(), number("seed", seed));
  }

  private List<Integer> chosenSizes() {
    try {
      return SizeList.parse(sizes.getText().strip(), kind.most());
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException("The sizes cannot be used: " + e.getMessage() + ".");
    }
  }

  private int chosenSets() {
    long number = number("number of sets", sets);
    if (number < 1 || number > kind.most()) {
      throw new IllegalArgumentException(
          "The number of sets is not from 1 to " + kind.most() + ".");
    }
    return (int) number;
  }

  private static long number(String what, JTextField field) {
    try {
      return Long.parseLong(field.getText().strip());
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(
          "The " + what + " “" + field.getText() + "” is no whole number.");
    }
  }

  /** Lets the user change the fields, or not while a study runs. */
  void setOpen(boolean open) {
    for (JComponent field : List.of(sizes, sets, seed, shapes)) {
      field.setEnabled(open);
    }
  }
}
