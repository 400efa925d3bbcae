package dct.ui.explain;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Font;
import java.awt.GraphicsConfiguration;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.KeyEvent;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;

/**
 * A dialog with text to read, beside which the window can be used on. The text can be selected,
 * copied, and read line by line by a screen reader. Esc, Enter and Close close it.
 */
final class TextDialog extends JDialog {
  private static final long serialVersionUID = 1L;
  private static final Dimension SIZE = new Dimension(460, 360);

  /**
   * A dialog that is not visible yet.
   *
   * @param name of the dialog, for tests
   * @param heading a clause that stands out above the text
   */
  TextDialog(Window owner, String title, String name, String heading, String text) {
    super(owner, title, ModalityType.MODELESS);
    setName(name);
    JTextArea area = new JTextArea(text);
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
    add(heading(heading), BorderLayout.NORTH);
    add(scroll, BorderLayout.CENTER);
    add(buttons(), BorderLayout.SOUTH);
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
    getRootPane()
        .registerKeyboardAction(
            e -> dispose(),
            KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0),
            JComponent.WHEN_IN_FOCUSED_WINDOW);
    pack();
  }

  private static JLabel heading(String text) {
    JLabel label = new JLabel(text);
    label.setName("heading");
    label.setFont(label.getFont().deriveFont(Font.BOLD));
    label.setBorder(BorderFactory.createEmptyBorder(12, 12, 6, 12));
    return label;
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

  /** Shows it to the right of its window, or else where it covers the least of a component. */
  void showBeside(Component picture) {
    Rectangle screen = usable();
    Window owner = getOwner();
    int right = owner.getX() + owner.getWidth();
    int edge = screen.x + screen.width - getWidth();
    int x = Math.max(screen.x, Math.min(right, edge));
    int bottom = picture.getLocationOnScreen().y + picture.getHeight();
    boolean covers = x < right;
    int y = covers ? bottom - getHeight() : owner.getY();
    int lowest = screen.y + screen.height - getHeight();
    setLocation(x, Math.max(screen.y, Math.min(y, lowest)));
    setVisible(true);
    SwingUtilities.invokeLater(this::toFront);
  }

  private Rectangle usable() {
    GraphicsConfiguration configuration = getOwner().getGraphicsConfiguration();
    Rectangle screen = configuration.getBounds();
    Insets bars = Toolkit.getDefaultToolkit().getScreenInsets(configuration);
    return new Rectangle(
        screen.x + bars.left,
        screen.y + bars.top,
        screen.width - bars.left - bars.right,
        screen.height - bars.top - bars.bottom);
  }
}
