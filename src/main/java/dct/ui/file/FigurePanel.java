package dct.ui.file;

import dct.render.Figure;
import dct.render.Labels;
import dct.render.PictureStyle;
import dct.render.PictureView;
import dct.render.Theme;
import dct.ui.canvas.CanvasPanel;
import dct.ui.dialog.Fields;
import dct.ui.dialog.Memory;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.GridLayout;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import javax.swing.text.JTextComponent;

/**
 * What is asked of a picture beside its file, with a preview: what it shows and how large, its
 * colours, labels, counts and legend. The answers are those of the last time, but labels and the
 * direction of y, which are those of the canvas.
 */
final class FigurePanel extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final int GAP = 6;
  private static final int WINDOW = 1; // the place of what the window shows among the extents

  private final CanvasPanel canvas;
  private final JComboBox<String> extent =
      new JComboBox<>(new String[] {"Everything, as a figure", "What the window shows"});
  private final JComboBox<String> width =
      new JComboBox<>(new String[] {"84 mm", "174 mm", "600 px"});
  private final JComboBox<String> scale =
      new JComboBox<>(new String[] {"1 ×", "2 ×", "3 ×", "4 ×"});
  private final JComboBox<String> theme = new JComboBox<>(new String[] {"Light", "Print", "Dark"});
  private final JCheckBox numbers = new JCheckBox("Numbers");
  private final JCheckBox degrees = new JCheckBox("Degrees");
  private final JCheckBox coordinates = new JCheckBox("Coordinates");
  private final JCheckBox counts = new JCheckBox("Counts", true);
  private final JCheckBox legend = new JCheckBox("Legend");
  private final JCheckBox cropped = new JCheckBox("Cropped", true);
  private final JCheckBox upwards = new JCheckBox("Y axis up");
  private final JCheckBox standalone = new JCheckBox("Whole LaTeX file");
  private final FigurePreview preview;

  /** Fields for pictures of what a canvas shows. */
  FigurePanel(CanvasPanel canvas) {
    super(new BorderLayout(0, GAP));
    this.canvas = canvas;
    preview = new FigurePreview(canvas.scene());
    setBorder(BorderFactory.createEmptyBorder(0, 2 * GAP, 0, 0));
    width.setEditable(true);
    JPanel questions = new JPanel(new BorderLayout(0, GAP));
    questions.add(fields(), BorderLayout.NORTH);
    questions.add(boxes(), BorderLayout.SOUTH);
    add(questions, BorderLayout.NORTH);
    add(preview);
    recall();
    numbers.setSelected(canvas.labels().numbers());
    degrees.setSelected(canvas.labels().degrees());
    upwards.setSelected(canvas.viewport().yUp());
    choices().forEach(choice -> choice.addActionListener(e -> changed()));
    ticks().forEach(box -> box.addActionListener(e -> changed()));
    typedWidth().getDocument().addDocumentListener(new Typing());
    changed();
  }

  /** The picture that was asked for last, of what this canvas shows now. */
  static PictureStyle remembered(CanvasPanel canvas) {
    FigurePanel panel = new FigurePanel(canvas);
    return panel.usable().orElseGet(() -> Figure.DEFAULT.withYUp(canvas.viewport().yUp()));
  }

  private Fields fields() {
    Fields fields = new Fields();
    fields.ask("Shows:", 'h', "extent", extent, "All, laid out for a paper, or the window's part");
    fields.ask("Width:", 'w', "width", width, "84mm is a column; letters keep their size in mm");
    fields.ask("PNG scale:", 'g', "scale", scale, "Pixels of a PNG; others are sharp at any size");
    fields.ask("Colours:", 'o', "theme", theme, "Print is told apart in grey, too");
    return fields;
  }

  private JPanel boxes() {
    JPanel boxes = new JPanel(new GridLayout(0, 2, GAP, 0));
    offer(boxes, numbers, 'b', "numbers", "Writes the numbers of the vertices beside them");
    offer(boxes, counts, 't', "counts", "Writes how many vertices are even and odd");
    offer(boxes, degrees, 'd', "degrees", "Writes the degrees of the vertices beside them");
    offer(boxes, legend, 'l', "legend", "Says what colours and shapes stand for");
    offer(boxes, coordinates, 'c', "coordinates", "Writes the coordinates beside the vertices");
    offer(boxes, cropped, 'p', "cropped", "Ends at the drawing; else it has the shape of a canvas");
    offer(boxes, upwards, 'y', "upwards", "Lets y grow upwards");
    offer(boxes, standalone, 'x', "standalone", "A .tex is a document, else a part for \\input");
    return boxes;
  }

  private static void offer(JPanel to, JCheckBox box, char letter, String name, String tip) {
    box.setName(name);
    box.setMnemonic(letter);
    box.setToolTipText(tip);
    to.add(box);
  }

  private List<JComboBox<String>> choices() {
    return List.of(extent, width, scale, theme);
  }

  private List<JCheckBox> ticks() {
    return Stream.concat(kept().stream(), Stream.of(numbers, degrees, coordinates, upwards))
        .toList();
  }

  private List<JCheckBox> kept() {
    return List.of(counts, legend, cropped, standalone);
  }

  /**
   * The picture asked for.
   *
   * @throws IllegalArgumentException if the width that was typed is none; the message says so
   */
  PictureStyle style() {
    return isFigure()
        ? figure()
        : new PictureView(
            canvas.viewport(), canvas.getWidth(), canvas.getHeight(), canvas.notes(), scale());
  }

  private Figure figure() {
    Theme colours = Theme.valueOf(theme.getSelectedItem().toString().toUpperCase(Locale.ROOT));
    return new Figure(
        Figure.Size.parse(typedWidth().getText().strip()),
        scale(),
        cropped.isSelected(),
        new Labels(numbers.isSelected(), degrees.isSelected(), coordinates.isSelected()),
        counts.isSelected(),
        legend.isSelected(),
        upwards.isSelected(),
        colours,
        standalone.isSelected());
  }

  private boolean isFigure() {
    return extent.getSelectedIndex() != WINDOW;
  }

  private int scale() {
    return scale.getSelectedIndex() + 1;
  }

  private JTextComponent typedWidth() {
    return (JTextComponent) width.getEditor().getEditorComponent();
  }

  /** Keeps the answers for the next time. */
  void remember() {
    for (JComboBox<String> choice : List.of(extent, scale, theme)) {
      Memory.put(memory(choice), choice.getSelectedIndex());
    }
    Memory.put(memory(width), typedWidth().getText().strip());
    kept().forEach(box -> Memory.put(memory(box), box.isSelected()));
  }

  private void recall() {
    for (JComboBox<String> choice : List.of(extent, scale, theme)) {
      int last = Memory.number(memory(choice)).orElse(0);
      choice.setSelectedIndex(last < 0 || last >= choice.getItemCount() ? 0 : last);
    }
    Memory.get(memory(width)).ifPresent(width::setSelectedItem);
    kept()
        .forEach(box -> Memory.get(memory(box)).map(Boolean::valueOf).ifPresent(box::setSelected));
  }

  private static String memory(Component field) {
    return "figure." + field.getName();
  }

  private void changed() {
    ticks().forEach(box -> box.setEnabled(isFigure()));
    theme.setEnabled(isFigure());
    width.setEnabled(isFigure());
    preview.show(usable());
  }

  /** The picture asked for, if the width is usable. */
  private Optional<PictureStyle> usable() {
    try {
      return Optional.of(style());
    } catch (IllegalArgumentException e) {
      return Optional.empty(); // is said when it is to be written
    }
  }

  /** Follows the width as it is typed. */
  private final class Typing implements DocumentListener {
    @Override
    public void insertUpdate(DocumentEvent e) {
      changed();
    }

    @Override
    public void removeUpdate(DocumentEvent e) {
      changed();
    }

    @Override
    public void changedUpdate(DocumentEvent e) {
      changed();
    }
  }
}
