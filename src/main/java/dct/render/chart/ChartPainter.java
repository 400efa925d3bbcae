package dct.render.chart;

import dct.render.Ink;
import dct.render.Theme;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.util.List;
import java.util.Locale;
import org.knowm.xchart.CategoryChart;
import org.knowm.xchart.CategoryChartBuilder;
import org.knowm.xchart.CategorySeries;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.AxesChartStyler;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** Draws charts on any {@link Graphics2D}, by XChart. */
public final class ChartPainter {
  private static final int MARKER = 7;
  private static final float LINE = 2;
  private static final float HAIR = 0.7f; // width of the grid, without dashes: each would be a path
  private static final int TITLE = 14; // size of letters
  private static final int TEXT = 11;
  private static final int SLANT = 25; // degrees; of the names below bars
  private static final int GRID_ALPHA = 0x50000000;
  private static final double BARS = 0.86; // part of the width that bars take
  private static final double WHOLE = 100; // per cent
  private static final double RANGE = 50; // of the x-values, beyond which their axis is logarithmic

  private final Chart chart;
  private final Theme theme;
  private final int width;
  private final int height;
  private final Font letters;

  private ChartPainter(Chart chart, Theme theme, int width, int height, Font letters) {
    this.chart = chart;
    this.theme = theme;
    this.width = width;
    this.height = height;
    this.letters = letters;
  }

  /** Draws a chart with its upper left corner at the origin. */
  public static void paint(Chart chart, Graphics2D graphics, int width, int height, Theme theme) {
    paint(chart, graphics, width, height, theme, new Font(Font.SANS_SERIF, Font.PLAIN, TEXT));
  }

  /** The same with letters of a font, whatever its size. */
  static void paint(
      Chart chart, Graphics2D graphics, int width, int height, Theme theme, Font letters) {
    ChartPainter painter = new ChartPainter(chart, theme, width, height, letters);
    if (chart.hasBars()) {
      painter.bars().paint(graphics, width, height);
    } else {
      painter.lines().paint(graphics, width, height);
    }
  }

  private XYChart lines() {
    XYChart made =
        new XYChartBuilder()
            .width(width)
            .height(height)
            .title(chart.title())
            .xAxisTitle(chart.xLabel())
            .yAxisTitle(chart.yLabel())
            .build();
    style(made.getStyler());
    made.getStyler().setDecimalPattern("0.###");
    made.getStyler().setXAxisLogarithmic(isWide());
    for (Chart.Series series : withValues()) {
      XYSeries line =
          made.addSeries(
              series.name(), array(series.x()), array(series.y()), array(series.error()));
      line.setMarker(SeriesMarkers.CIRCLE).setMarkerColor(colour(series));
      line.setLineColor(colour(series)).setLineStyle(new BasicStroke(LINE));
    }
    return made;
  }

  private List<Chart.Series> withValues() {
    return chart.series().stream().filter(series -> !series.y().isEmpty()).toList();
  }

  private boolean isWide() {
    double[] all =
        chart.series().stream().flatMap(s -> s.x().stream()).mapToDouble(x -> x).sorted().toArray();
    return all.length > 0 && all[0] > 0 && all[all.length - 1] > RANGE * all[0];
  }

  private CategoryChart bars() {
    CategoryChart made =
        new CategoryChartBuilder()
            .width(width)
            .height(height)
            .title(chart.title())
            .xAxisTitle(chart.xLabel())
            .yAxisTitle(chart.yLabel())
            .build();
    style(made.getStyler());
    made.getStyler().setAvailableSpaceFill(BARS).setXAxisLabelRotation(SLANT);
    for (Chart.Series series : withValues()) {
      CategorySeries bar =
          made.addSeries(series.name(), chart.categories(), series.y(), series.error());
      bar.setFillColor(colour(series));
    }
    return made;
  }

  private void style(AxesChartStyler styler) {
    Color ground = new Color(Ink.BACKGROUND.rgb(theme));
    Color ink = new Color(Ink.LABEL.rgb(theme));
    styler.setChartBackgroundColor(ground).setPlotBackgroundColor(ground);
    styler.setLegendBackgroundColor(ground).setChartFontColor(ink);
    styler.setAxisTickLabelsColor(ink).setAxisTickMarksColor(ink);
    styler.setXAxisTitleColor(ink).setYAxisTitleColor(ink);
    styler.setLegendPosition(LegendPosition.OutsideE).setLegendBorderColor(ground);
    styler.setChartTitleFont(font(Font.BOLD, TITLE)).setLegendFont(font(Font.PLAIN, TEXT));
    styler.setAxisTitleFont(font(Font.PLAIN, TEXT)).setAxisTickLabelsFont(font(Font.PLAIN, TEXT));
    styler
        .setLocale(Locale.ROOT)
        .setMarkerSize(MARKER)
        .setPlotBorderVisible(false)
        .setToolTipsEnabled(false);
    if (chart.isShare()) {
      styler.setYAxisMax(WHOLE);
      if (chart.hasBars()) {
        styler.setYAxisMin(0.0);
      }
    }
    styler.setErrorBarsColorSeriesColor(!chart.hasBars()).setErrorBarsColor(ink);
    styler.setPlotGridLinesStroke(new BasicStroke(HAIR));
    styler.setPlotGridLinesColor(new Color(Ink.PROPOSED.rgb(theme) | GRID_ALPHA, true));
  }

  private Font font(int style, float size) {
    return letters.deriveFont(style, size);
  }

  private static Color colour(Chart.Series series) {
    return new Color(series.look().rgb());
  }

  private static double[] array(List<Double> values) {
    return values.stream().mapToDouble(v -> v).toArray();
  }
}
