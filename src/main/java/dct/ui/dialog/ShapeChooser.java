package dct.ui.dialog;

import dct.core.triangulate.Domain;
import dct.io.format.Choice;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ListSelectionModel;

/** Asks which of the shapes of a file is meant, with a small picture of each. */
final class ShapeChooser {
  private static final String WITH_HOLES = "Open with Holes";
  private static final String OPEN = "Open";
  private static final String AS_SITES = "All as Sites";
  private static final String CANCEL = "Cancel";
  private static final int GAP = 8;

  private final Shapes shapes;
  private final JList<Shape> list;
  private final JPanel panel = new JPanel(new BorderLayout(0, GAP));

  private ShapeChooser(Shapes shapes) {
    this.shapes = shapes;
    this.list = new JList<>(shapes.shapes().toArray(Shape[]::new));
    list.setName("shapes");
    list.getAccessibleContext().setAccessibleName("Shapes in the file");
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.setSelectedIndex(0);
    list.setVisibleRowCount(Math.min(8, shapes.shapes().size()));
    list.setFixedCellHeight(ShapeIcon.HEIGHT + GAP);
    list.setFixedCellWidth(420);
    list.setCellRenderer(new Cell());
    JLabel question = new JLabel(question());
    question.setDisplayedMnemonic('W');
    question.setLabelFor(list);
    panel.add(question, BorderLayout.NORTH);
    panel.add(new JScrollPane(list));
    list.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent e) {
            if (e.getClickCount() == 2) {
              Ask.answer(list, OPEN);
            }
          }
        });
  }

  private String question() {
    return "Which of the " + shapes.shapes().size() + " shapes (" + shapes.format() + ")?";
  }

  /**
   * Asks; returns how to read the file again, or nothing if it shall not be read.
   *
   * @param before how it has been read
   */
  static Optional<Choice> ask(Component parent, String title, Shapes shapes, Choice before) {
    return new ShapeChooser(shapes).ask(parent, title, before);
  }

  private Optional<Choice> ask(Component parent, String title, Choice before) {
    List<String> options = new ArrayList<>(List.of(OPEN, AS_SITES, CANCEL));
    if (hasHoles() && before.as().isEmpty()) {
      options.add(0, WITH_HOLES);
    }
    int answer =
        Ask.choose(
            parent, title, panel, list::requestFocusInWindow, options.toArray(String[]::new));
    int chosen = list.getSelectedIndex();
    return switch (answer < 0 ? CANCEL : options.get(answer)) {
      case WITH_HOLES -> Optional.of(before.as(Domain.REGION));
      case OPEN -> Optional.of(chosen).filter(k -> k >= 0).map(k -> before.picking(k + 1));
      case AS_SITES -> Optional.of(before.as(Domain.SITES));
      default -> Optional.empty();
    };
  }

  private boolean hasHoles() {
    return shapes.shapes().stream().anyMatch(shape -> shape.kind() == Shape.Kind.HOLE);
  }

  /** A shape with its picture and its description. */
  private final class Cell extends DefaultListCellRenderer {
    private static final long serialVersionUID = 1L;

    @Override
    public Component getListCellRendererComponent(
        JList<?> all, Object value, int index, boolean selected, boolean focused) {
      Shape shape = shapes.shapes().get(index);
      String text = (index + 1) + ": " + shape.description();
      super.getListCellRendererComponent(all, text, index, selected, focused);
      setIcon(new ShapeIcon(shape));
      setIconTextGap(2 * GAP);
      setToolTipText(text);
      return this;
    }
  }
}
