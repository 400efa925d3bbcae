package dct.ui;

import dct.core.Progress;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.Domain;
import dct.experiment.generate.PolygonShape;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import java.awt.Component;
import java.awt.GridLayout;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JTextField;

/**
 * Asks for a number of vertices, a shape and a seed, and puts that random polygon on the canvas.
 */
final class RandomPolygon {
  private static final String TITLE = "Random Polygon";
  private static final int MOST = 1_000_000;
  private static final int GAP = 6;

  private final Component parent;
  private final Workbench workbench;
  private final Runnable shown;
  private final JTextField vertices = new JTextField("100", 10);
  private final JComboBox<PolygonShape> shapes = new JComboBox<>(PolygonShape.values());
  private final JTextField seed = new JTextField("1", 10);
  private final JPanel questions = new JPanel(new GridLayout(0, 2, GAP, GAP));

  /**
   * A dialog that is not shown yet.
   *
   * @param shown is run when another polygon was put on the canvas
   */
  RandomPolygon(Component parent, Workbench workbench, Runnable shown) {
    this.parent = parent;
    this.workbench = workbench;
    this.shown = shown;
    ask("Number of vertices:", "vertices", vertices);
    ask("Shape:", "shape", shapes);
    ask("Seed:", "seed", seed);
    shapes.setRenderer(new Titles());
  }

  /** Shows each shape by its title. */
  private static final class Titles extends DefaultListCellRenderer {
    private static final long serialVersionUID = 1L;

    @Override
    public Component getListCellRendererComponent(
        JList<?> list, Object value, int index, boolean selected, boolean focused) {
      PolygonShape shape = (PolygonShape) value;
      super.getListCellRendererComponent(list, shape.title(), index, selected, focused);
      setToolTipText(shape.description());
      return this;
    }
  }

  private void ask(String question, String name, JComponent answer) {
    JLabel label = new JLabel(question);
    label.setLabelFor(answer);
    answer.setName(name);
    questions.add(label);
    questions.add(answer);
  }

  /** Asks until the answers are numbers, or Cancel is chosen; then makes the polygon. */
  void ask() {
    while (JOptionPane.showConfirmDialog(
            parent, questions, TITLE, JOptionPane.OK_CANCEL_OPTION, JOptionPane.QUESTION_MESSAGE)
        == JOptionPane.OK_OPTION) {
      Long n = number(vertices, 3, MOST, "number of vertices");
      Long chosen = n == null ? null : number(seed, Long.MIN_VALUE, Long.MAX_VALUE, "seed");
      if (chosen != null) {
        make(shapes.getItemAt(shapes.getSelectedIndex()), n.intValue(), chosen);
        return;
      }
    }
  }

  /** The whole number that was typed; says so and returns null if it is none of these. */
  private Long number(JTextField field, long least, long most, String what) {
    String typed = field.getText().strip();
    try {
      long number = Long.parseLong(typed);
      if (number >= least && number <= most) {
        return number;
      }
    } catch (NumberFormatException e) {
      // is answered below, as a number that is too small or too large is
    }
    Ask.sorry(
        parent,
        TITLE,
        String.format(
            Locale.ROOT,
            "“%s” is no %s; type a whole number from %d to %d.",
            typed,
            what,
            least,
            most));
    return null;
  }

  private void make(PolygonShape shape, int n, long chosenSeed) {
    Consumer<SimplePolygon> show =
        polygon -> {
          Editor editor = workbench.editor(Domain.POLYGON);
          editor.perform(Edit.replace(TITLE, editor.document(), polygon.points()));
          shown.run();
          workbench.say(shape.title() + ", " + n + " vertices, seed " + chosenSeed);
          seed.setText(Long.toString(chosenSeed + 1));
        };
    workbench.jobs().submit(TITLE, progress -> generate(shape, n, chosenSeed, progress), show);
  }

  private static SimplePolygon generate(PolygonShape shape, int n, long seed, Progress progress) {
    return shape.generate(n, shape.areaFor(n), seed, progress);
  }
}
