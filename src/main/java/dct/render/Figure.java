package dct.render;

import dct.core.Decimals;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * How a scene becomes a picture in a file: how large, how much of what, and in which colours;
 * immutable. {@link #DEFAULT} is a figure as wide as a column of a paper.
 *
 * @param size how wide it is
 * @param scale how many times finer the pixels of a PNG are; other pictures have none
 * @param isCropped whether it ends at the drawing, with a margin, or has the shape of a canvas
 * @param labels what is written beside the vertices, over what the scene says itself
 * @param counts whether the counts of even and odd vertices are written
 * @param legend whether it says what the colours and shapes stand for
 * @param yUp whether y runs upwards
 * @param theme its colours
 * @param isStandalone whether TikZ is a document of its own and not a part of one
 */
public record Figure(
    Size size,
    int scale,
    boolean isCropped,
    Labels labels,
    boolean counts,
    boolean legend,
    boolean yUp,
    Theme theme,
    boolean isStandalone)
    implements PictureStyle {

  /** The finest pixels that a PNG can have. */
  public static final int LARGEST_SCALE = 4;

  /** A column wide, cropped, with the counts, light on white, y downwards. */
  public static final Figure DEFAULT =
      new Figure(Size.COLUMN, 1, true, Labels.NONE, true, false, false, Theme.LIGHT, false);

  /**
   * Checks the scale.
   *
   * @throws IllegalArgumentException if it is less than 1 or more than {@link #LARGEST_SCALE}
   */
  public Figure {
    if (scale < 1 || scale > LARGEST_SCALE) {
      throw new IllegalArgumentException("a scale of " + scale);
    }
  }

  /** The unit of a width: that of paper, or that of a screen. */
  public enum Unit {
    /** Millimetres; letters have 7 to 9 pt and lines 0.4 pt or more, a PNG 300 dots an inch. */
    MM("mm", 10, 1000),
    /** Pixels, 96 of them an inch; letters and lines are as on the screen. */
    PX("px", 50, 4000);

    private final String word;
    private final double least;
    private final double most;

    Unit(String word, double least, double most) {
      this.word = word;
      this.least = least;
      this.most = most;
    }

    /** What it is written as. */
    public String word() {
      return word;
    }

    /** The smallest width in it. */
    public double least() {
      return least;
    }

    /** The largest width in it. */
    public double most() {
      return most;
    }
  }

  /**
   * The width of a picture. It is only less where a tall drawing would be too high.
   *
   * @param width how many units
   */
  public record Size(double width, Unit unit) {
    /** The width of a column of a paper. */
    public static final Size COLUMN = new Size(84, Unit.MM);

    private static final Pattern WRITTEN =
        Pattern.compile("([0-9]{1,6}(?:\\.[0-9]{1,6})?) ?(mm|px)");

    /**
     * Checks the width.
     *
     * @throws IllegalArgumentException if it is not in the range of the unit; its message says so
     */
    public Size {
      if (!(width >= unit.least && width <= unit.most)) {
        throw new IllegalArgumentException(
            String.format(
                Locale.ROOT,
                "%s%s is out of range; take from %.0f%s to %.0f%s",
                Decimals.format(width),
                unit.word,
                unit.least,
                unit.word,
                unit.most,
                unit.word));
      }
    }

    /**
     * The width that is written like {@code 84mm} or {@code 600px}.
     *
     * @throws IllegalArgumentException if it is none of these; its message says so
     */
    public static Size parse(String written) {
      Matcher parts = WRITTEN.matcher(written);
      if (!parts.matches()) {
        throw new IllegalArgumentException(written + " is no width; write 84mm or 600px");
      }
      Unit unit = parts.group(2).equals("mm") ? Unit.MM : Unit.PX;
      return new Size(Double.parseDouble(parts.group(1)), unit);
    }
  }

  /** This figure of another width. */
  public Figure withSize(Size other) {
    return new Figure(other, scale, isCropped, labels, counts, legend, yUp, theme, isStandalone);
  }

  /** This figure with y upwards or downwards. */
  public Figure withYUp(boolean up) {
    return new Figure(size, scale, isCropped, labels, counts, legend, up, theme, isStandalone);
  }

  /** This figure with other labels. */
  public Figure withLabels(Labels other) {
    return new Figure(size, scale, isCropped, other, counts, legend, yUp, theme, isStandalone);
  }

  /** This figure in other colours. */
  public Figure withTheme(Theme other) {
    return new Figure(size, scale, isCropped, labels, counts, legend, yUp, other, isStandalone);
  }

  /** This figure with or without a legend. */
  public Figure withLegend(boolean wished) {
    return new Figure(size, scale, isCropped, labels, counts, wished, yUp, theme, isStandalone);
  }
}
