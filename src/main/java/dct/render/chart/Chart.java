package dct.render.chart;

import java.util.List;

/**
 * A chart: series of values over a number or over categories; immutable.
 *
 * @param word its name on the command line
 * @param title what it shows
 * @param xLabel what runs to the right
 * @param yLabel what runs upwards
 * @param isShare whether y is a share in per cent, whose axis ends at 100
 * @param categories the names along x for a chart of bars; empty where x is a number
 * @param series what is drawn, in the order of the legend
 */
public record Chart(
    String word,
    String title,
    String xLabel,
    String yLabel,
    boolean isShare,
    List<String> categories,
    List<Series> series) {

  public Chart {
    categories = List.copyOf(categories);
    series = List.copyOf(series);
  }

  /** Whether it has categories and bars. */
  public boolean hasBars() {
    return !categories.isEmpty();
  }

  /** How a series looks; methods that belong together share a hue, pale and strong. */
  public enum Look {
    PALE_BLUE(0x8FBBE0),
    BLUE(0x1F6FB4),
    PALE_ORANGE(0xF7B27A),
    ORANGE(0xD95F0E),
    PALE_GREEN(0x94CF96),
    GREEN(0x2A8C3C),
    GREY(0x8A93A3),
    VIOLET(0x7B3FA0);

    private final int rgb;

    Look(int rgb) {
      this.rgb = rgb;
    }

    /** The colour as 0xRRGGBB. */
    int rgb() {
      return rgb;
    }
  }

  /**
   * A series of values.
   *
   * @param name its name in the legend
   * @param look its colour
   * @param x where the values are; of a chart of bars nothing
   * @param y the values, NaN for none; of a chart of bars one for each category
   * @param error half the height of each value's error bar
   */
  public record Series(String name, Look look, List<Double> x, List<Double> y, List<Double> error) {

    /** Checks that there is an error for each value. */
    public Series {
      x = List.copyOf(x);
      y = List.copyOf(y);
      error = List.copyOf(error);
      if (error.size() != y.size() || (!x.isEmpty() && x.size() != y.size())) {
        throw new IllegalArgumentException(name + " has values without place or error");
      }
    }
  }
}
