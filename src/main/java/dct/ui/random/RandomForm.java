package dct.ui.random;

import dct.core.triangulate.Domain;
import dct.experiment.generate.Area;
import dct.experiment.generate.CannotGenerateException;
import dct.ui.dialog.Form;
import java.awt.Component;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JList;
import javax.swing.JTextField;

/** The questions which random sites, polygon or region to make: the number first. */
public final class RandomForm extends Form {
  private static final long serialVersionUID = 1L;
  private static final int MOST = 1_000_000;
  private static final Pattern AREA = Pattern.compile("(\\d{1,9})\\s*[x×]\\s*(\\d{1,9})");

  private final Domain domain;
  private final JTextField number = new JTextField("100", 12);
  private final JComboBox<RandomPlan.Shape> shapes;
  private final JTextField seed = new JTextField("1", 12);
  private final JTextField area = new JTextField(12);
  private final JTextField holes = new JTextField("1", 12);
  private final JCheckBox real = new JCheckBox("Real coordinates");

  /**
   * Questions with their usual answers.
   *
   * @param copy takes the call of the program that makes the same
   */
  RandomForm(Domain domain, Consumer<RandomForm> copy) {
    this.domain = domain;
    shapes = new JComboBox<>(RandomPlan.shapes(domain).toArray(RandomPlan.Shape[]::new));
    shapes.setRenderer(new Described());
    ask("Number of " + domain.vertices() + ":", 'n', "vertices", number, "From " + least() + " on");
    ask("Shape:", 's', "shape", shapes, "How they lie; each says so under the mouse");
    if (domain == Domain.REGION) {
      ask("Number of holes:", 'h', "holes", holes, "From 1 on; an annulus has one");
    }
    ask("Seed:", 'e', "seed", seed, "Which of the random ones; the same gives the same again");
    if (domain != Domain.REGION) {
      area.putClientProperty("JTextField.placeholderText", "as large as needed");
      ask("Area:", 'a', "area", area, "Width and height, as 1000x700; empty for as much as needed");
      offer(real, 'r', "real", "Otherwise all coordinates are whole numbers");
    }
    offerCopy(() -> copy.accept(this));
  }

  private int least() {
    return domain == Domain.SITES ? 1 : 3;
  }

  @Override
  protected JTextField first() {
    return number;
  }

  /**
   * What was answered.
   *
   * @throws IllegalArgumentException if that cannot be; the message is a sentence for a person
   */
  RandomPlan plan() {
    long n = whole(number, least(), MOST, "number of " + domain.vertices());
    long chosen = whole(seed, Long.MIN_VALUE, Long.MAX_VALUE, "seed");
    RandomPlan.Shape shape = shapes.getItemAt(shapes.getSelectedIndex());
    long chosenHoles = whole(holes, 1, MOST, "number of holes");
    return new RandomPlan(
        domain, (int) n, shape, chosen, chosenArea(), real.isSelected(), (int) chosenHoles);
  }

  private Optional<Area> chosenArea() {
    String typed = area.getText().strip();
    if (typed.isEmpty()) {
      return Optional.empty();
    }
    Matcher sides = AREA.matcher(typed);
    if (!sides.matches()) {
      throw new IllegalArgumentException(
          "“" + typed + "” is no area; type a width and a height such as 1000x700, or nothing.");
    }
    try {
      return Optional.of(
          new Area(Integer.parseInt(sides.group(1)), Integer.parseInt(sides.group(2)), true));
    } catch (CannotGenerateException e) {
      throw new IllegalArgumentException("Nothing was changed: " + e.getMessage() + ".");
    }
  }

  /** Suggests the next seed after one that was used. */
  void suggestAfter(long used) {
    seed.setText(Long.toString(used + 1));
  }

  /** Says under the mouse what a shape is. */
  private static final class Described extends DefaultListCellRenderer {
    private static final long serialVersionUID = 1L;

    @Override
    public Component getListCellRendererComponent(
        JList<?> list, Object value, int index, boolean selected, boolean focused) {
      super.getListCellRendererComponent(list, value, index, selected, focused);
      setToolTipText(((RandomPlan.Shape) value).description());
      return this;
    }
  }
}
