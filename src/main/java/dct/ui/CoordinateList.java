package dct.ui;

import dct.core.Decimals;
import dct.core.geometry.Points;
import java.awt.Color;
import java.awt.Font;
import javax.swing.BorderFactory;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.Timer;
import javax.swing.UIManager;

/**
 * The coordinates of the displayed vertices, in order, a vertex a line, in the form of the
 * program's files; their numbers stand in a column of their own, so that lines can be copied.
 */
final class CoordinateList extends JScrollPane {
  private static final long serialVersionUID = 1L;

  /** A text of more lines would take longer to lay out than the mouse takes to move on. */
  private static final int MOST_LINES = 5_000;

  /** Longer texts are written when the vertices have come to rest. */
  private static final int AT_ONCE = 200;

  private static final int PAUSE_MILLIS = 150;

  private final JTextArea coordinates = new BrightText();
  private final LineNumbers numbers = new LineNumbers(coordinates);
  private final Timer pause = new Timer(PAUSE_MILLIS, e -> write(shown()));
  private transient Points shown;

  CoordinateList() {
    pause.setRepeats(false);
    coordinates.setName("coordinates");
    coordinates.getAccessibleContext().setAccessibleName("Coordinates of the vertices");
    coordinates.setEditable(false);
    coordinates.setFont(new Font(Font.MONOSPACED, Font.PLAIN, 12));
    coordinates.setBorder(BorderFactory.createEmptyBorder(4, 4, 4, 8));
    setViewportView(coordinates);
    setRowHeaderView(numbers);
  }

  private Points shown() {
    return shown;
  }

  /** Shows these points. */
  void show(Points points) {
    if (points.equals(shown)) {
      return;
    }
    shown = points;
    if (points.size() <= AT_ONCE) {
      pause.stop();
      write(points);
    } else {
      pause.restart();
    }
  }

  private void write(Points points) {
    int lines = Math.min(points.size(), MOST_LINES);
    StringBuilder text = new StringBuilder();
    for (int v = 0; v < lines; v++) {
      text.append(Decimals.format(points.x(v)))
          .append(' ')
          .append(Decimals.format(points.y(v)))
          .append('\n');
    }
    if (lines < points.size()) {
      text.append("and ").append(points.size() - lines).append(" more");
    }
    int caret = Math.min(coordinates.getCaretPosition(), text.length());
    coordinates.setText(text.toString());
    coordinates.setCaretPosition(caret);
    numbers.setLines(lines);
  }

  /** A text that cannot be edited, but is not disabled either, in every look. */
  private static final class BrightText extends JTextArea {
    private static final long serialVersionUID = 1L;

    @Override
    public void updateUI() {
      super.updateUI();
      // A colour of the look's own would be replaced when the look changes, by that of fields that
      // are disabled.
      setBackground(new Color(UIManager.getColor("TextField.background").getRGB()));
      setDropTarget(null); // what is dropped is for the window
    }
  }
}
