package dct.ui.study;

import com.formdev.flatlaf.FlatLaf;
import dct.render.Theme;
import dct.render.chart.Chart;
import dct.render.chart.ChartPainter;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import javax.swing.JPanel;

/** Shows one chart, as large as there is room. */
final class ChartPanel extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final Dimension SIZE = new Dimension(700, 440);

  private transient Chart chart; // null while there is nothing to show

  ChartPanel() {
    setName("chart");
    setPreferredSize(SIZE);
  }

  /** Shows this chart in place of the one there was. */
  void show(Chart shown) {
    chart = shown;
    getAccessibleContext().setAccessibleName(shown.title());
    repaint();
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    super.paintComponent(graphics);
    if (chart != null && getWidth() > 0 && getHeight() > 0) {
      Graphics2D own = (Graphics2D) graphics.create();
      own.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
      Theme theme = FlatLaf.isLafDark() ? Theme.DARK : Theme.LIGHT;
      ChartPainter.paint(chart, own, getWidth(), getHeight(), theme);
      own.dispose();
    }
  }
}
