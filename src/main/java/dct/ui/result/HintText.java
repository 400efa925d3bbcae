package dct.ui.result;

import java.awt.Dimension;
import java.awt.Insets;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.JTextArea;
import javax.swing.UIManager;

/**
 * A hint below a view, wrapped where the view is narrow. Its height follows from its width alone:
 * the view above it does not jump when the hint changes.
 */
public final class HintText extends JTextArea {
  private static final long serialVersionUID = 1L;
  private static final int COLUMNS = 62; // of most hints; below, they need a second line

  /** An empty hint. */
  public HintText() {
    setName("status");
    getAccessibleContext().setAccessibleName("Status");
    setEditable(false);
    setFocusable(false);
    setOpaque(false);
    setBorder(null);
    setMargin(new Insets(0, 0, 0, 0));
    setLineWrap(true);
    setWrapStyleWord(true);
    addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent e) {
            revalidate();
          }
        });
  }

  /** Shows another hint; all of it is in the tooltip, too. */
  public void say(String hint) {
    if (!hint.equals(getText())) {
      setText(hint);
      setToolTipText(hint.isEmpty() ? null : hint);
    }
  }

  @Override
  public void updateUI() {
    super.updateUI();
    setFont(UIManager.getFont("Label.font"));
    setForeground(UIManager.getColor("Label.foreground"));
  }

  private int lines() {
    int wide = COLUMNS * getFontMetrics(getFont()).charWidth('n');
    return getWidth() == 0 || getWidth() >= wide ? 1 : 2;
  }

  @Override
  public Dimension getPreferredSize() {
    return new Dimension(0, lines() * getRowHeight());
  }

  @Override
  public Dimension getMinimumSize() {
    return new Dimension(0, getRowHeight());
  }
}
