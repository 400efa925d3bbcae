package dct.ui.explain;

import java.awt.Font;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.BorderFactory;
import javax.swing.JTextArea;
import javax.swing.UIManager;

/** A heading above a text, wrapped where it is wider than what it heads. */
final class Heading extends JTextArea {
  private static final long serialVersionUID = 1L;

  /** A heading that is so wide at first; later it is as high as its width asks for. */
  Heading(String text, int width) {
    super(text);
    setName("heading");
    getAccessibleContext().setAccessibleName("Heading");
    setEditable(false);
    setFocusable(false);
    setOpaque(false);
    setLineWrap(true);
    setWrapStyleWord(true);
    setBorder(BorderFactory.createEmptyBorder(12, 12, 6, 12));
    setSize(width, Short.MAX_VALUE); // what the height follows from
    addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent e) {
            revalidate();
          }
        });
  }

  @Override
  public void updateUI() {
    super.updateUI();
    setFont(UIManager.getFont("Label.font").deriveFont(Font.BOLD));
    setForeground(UIManager.getColor("Label.foreground"));
  }
}
