package dct.render;

import dct.render.Pen.Anchor;
import java.util.List;

/** Lines of text in a corner of a picture, on a ground of their own so that they stay legible. */
public final class Caption {
  private static final double SIZE = 14;
  private static final double LEADING = 19;
  private static final double PADDING = 5;

  /** The mean width of a character; no pen need know its font. */
  private static final double ADVANCE = 0.61 * SIZE;

  private Caption() {}

  /** Where so many lines end, the first of them beginning at this height. */
  static double bottom(double top, int lines) {
    return lines == 0 ? top : top + LEADING * lines;
  }

  /**
   * Writes the lines below each other; nothing if there are none.
   *
   * @param x the left end of the lines, or their right end for {@link Anchor#END}
   * @param top the top of the first line
   */
  public static void paint(Pen pen, double x, double top, Anchor anchor, List<String> lines) {
    if (lines.isEmpty()) {
      return;
    }
    double width = ADVANCE * lines.stream().mapToInt(String::length).max().orElse(0);
    double left = anchor == Anchor.END ? x - width : x;
    pen.style(Stroke.fill(Ink.BACKGROUND));
    pen.rectangle(
        left - PADDING, top - PADDING, width + 2 * PADDING, LEADING * lines.size() + PADDING);
    pen.style(Stroke.fill(Ink.LABEL));
    double baseline = top + SIZE - 1;
    for (String line : lines) {
      pen.text(x, baseline, anchor, SIZE, line);
      baseline += LEADING;
    }
  }
}
