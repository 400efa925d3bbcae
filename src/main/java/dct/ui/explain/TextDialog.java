package dct.ui.explain;

import dct.core.geometry.Box;
import dct.ui.canvas.CanvasPanel;
import dct.ui.command.CloseKeys;
import dct.ui.dialog.Formulas;
import dct.ui.dialog.Placement;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Window;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;

/**
 * A dialog with text to read, beside which the window can be used on. The text can be selected,
 * copied, and read line by line by a screen reader. Esc, Ctrl+W, Enter and Close close it.
 */
final class TextDialog extends JDialog {
  private static final long serialVersionUID = 1L;
  private static final Dimension SIZE = new Dimension(460, 360); // of the text

  // The sizes that the dialog may have instead, so that it covers no vertex.
  private static final Dimension UPRIGHT = new Dimension(340, 520);
  private static final Dimension NARROW = new Dimension(272, 640);
  private static final Dimension LOW = new Dimension(640, 220);

  private static final int AROUND = 24; // pixels round a vertex, for its ring and its label
  private static final int MANY = 200; // it does not matter how many more

  /**
   * A dialog that is not visible yet.
   *
   * @param name of the dialog, for tests
   * @param heading a clause that stands out above the text
   */
  TextDialog(Window owner, String title, String name, String heading, String text) {
    super(owner, title, ModalityType.MODELESS);
    setName(name);
    JTextArea area = new JTextArea(Formulas.unbroken(text));
    area.setName(name + "Text");
    area.getAccessibleContext().setAccessibleName(title + ": " + heading);
    area.setEditable(false);
    area.setLineWrap(true);
    area.setWrapStyleWord(true);
    area.setMargin(new Insets(6, 12, 10, 12));
    area.setCaretPosition(0);
    JScrollPane scroll = new JScrollPane(area);
    scroll.setPreferredSize(SIZE);
    scroll.setBorder(BorderFactory.createEmptyBorder());
    add(new Heading(Formulas.unbroken(heading), SIZE.width), BorderLayout.NORTH);
    add(scroll, BorderLayout.CENTER);
    add(buttons(), BorderLayout.SOUTH);
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
    CloseKeys.close(this);
    pack();
  }

  private JPanel buttons() {
    JButton close = new JButton("Close");
    close.setName("closeText");
    close.setToolTipText("Closes this text, and takes its marks off the picture");
    close.addActionListener(e -> dispose());
    getRootPane().setDefaultButton(close);
    JPanel row = new JPanel(new FlowLayout(FlowLayout.TRAILING, 8, 8));
    row.add(close);
    return row;
  }

  /**
   * Shows it beside its window, or else where it covers no vertex of a picture in it.
   *
   * @param others frames, which make room for it where it would cover a part of one
   */
  void showBeside(CanvasPanel picture, List<? extends Window> others) {
    Rectangle screen = Placement.usable(getOwner());
    List<? extends Window> frames =
        others.stream().filter(frame -> frame.getBounds().intersects(screen)).toList();
    List<Rectangle> taken = frames.stream().map(Window::getBounds).toList();
    Rectangle on = new Rectangle(picture.getLocationOnScreen(), picture.getSize());
    TextPlace place =
        TextPlace.of(
            List.of(getSize(), UPRIGHT, NARROW, LOW),
            NARROW,
            new TextPlace.Desk(screen, getOwner().getBounds(), on, taken),
            part -> vertices(picture, on, part));
    for (int i = 0; i < frames.size(); i++) {
      if (!place.frames().get(i).equals(taken.get(i))) {
        frames.get(i).setBounds(place.frames().get(i));
      }
    }
    setBounds(place.text());
    setVisible(true);
    SwingUtilities.invokeLater(this::toFront);
  }

  /** How many vertices, with what is written beside them, are seen in a part of the screen. */
  private static int vertices(CanvasPanel picture, Rectangle on, Rectangle part) {
    Rectangle common = part.intersection(on);
    if (common.isEmpty() || !picture.scene().isAtHand()) {
      return common.isEmpty() ? 0 : MANY;
    }
    Box box =
        new Box(
            common.x - on.x,
            common.y - on.y,
            common.x - on.x + common.width,
            common.y - on.y + common.height);
    return picture.scene().verticesIn(picture.viewport(), box.grown(AROUND), MANY);
  }
}
