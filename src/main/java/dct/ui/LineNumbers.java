package dct.ui;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import javax.swing.JComponent;
import javax.swing.JTextArea;
import javax.swing.UIManager;

/** The column beside a text area that names the vertex of each line. */
final class LineNumbers extends JComponent {
  private static final long serialVersionUID = 1L;
  private static final int PADDING = 8;

  private final JTextArea text;
  private int lines;

  LineNumbers(JTextArea text) {
    this.text = text;
  }

  /** Says how many lines have a number. */
  void setLines(int lines) {
    this.lines = lines;
    revalidate();
    repaint();
  }

  @Override
  public Dimension getPreferredSize() {
    int width = text.getFontMetrics(text.getFont()).stringWidth(name(Math.max(lines - 1, 0)));
    return new Dimension(width + 2 * PADDING, text.getPreferredSize().height);
  }

  private static String name(int line) {
    return "v" + line;
  }

  @Override
  protected void paintComponent(Graphics g) {
    Graphics2D graphics = (Graphics2D) g.create();
    graphics.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    graphics.setColor(text.getBackground());
    graphics.fill(graphics.getClipBounds());
    Color grey = UIManager.getColor("Label.disabledForeground");
    graphics.setColor(grey == null ? text.getForeground() : grey);
    graphics.setFont(text.getFont());
    paintNames(graphics);
    graphics.dispose();
  }

  private void paintNames(Graphics2D graphics) {
    int height = text.getFontMetrics(text.getFont()).getHeight();
    int ascent = text.getFontMetrics(text.getFont()).getAscent();
    int top = text.getInsets().top;
    int first = Math.max(0, (graphics.getClipBounds().y - top) / height);
    int last = (graphics.getClipBounds().y + graphics.getClipBounds().height - top) / height;
    for (int line = first; line <= Math.min(last, lines - 1); line++) {
      graphics.drawString(name(line), PADDING, top + line * height + ascent);
    }
  }
}
