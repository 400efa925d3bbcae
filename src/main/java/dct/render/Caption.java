package dct.render;

import dct.core.geometry.Box;
import dct.render.Pen.Anchor;
import java.util.List;
import java.util.stream.Stream;

/** Lines of text in a corner of a picture, on a ground of their own so that they stay legible. */
public final class Caption {
  private static final double SIZE = 14;
  private static final double LEADING = 19;
  private static final double PADDING = 5;
  static final double MARGIN = 7; // from the borders of the picture

  /** The mean width of a character; no pen need know its font. */
  private static final double ADVANCE = 0.61 * SIZE;

  private Caption() {}

  /** The part of a picture whose corners captions fill. */
  static Box room(Box screen) {
    return screen.grown(-MARGIN);
  }

  /** The width of lines of which the longest has so many characters. */
  static double width(int longest) {
    return ADVANCE * longest + 2 * PADDING;
  }

  static double width(List<String> lines) {
    return width(lines.stream().mapToInt(String::length).max().orElse(0));
  }

  /** The height of so many lines; nothing for none. */
  static double height(int lines) {
    return lines == 0 ? 0 : LEADING * lines + PADDING;
  }

  /** The lines, those that are wider than the screen cut at spaces into several. */
  static List<String> folded(List<String> lines, Box screen) {
    int longest = (int) ((2 * room(screen).halfWidth() - 2 * PADDING) / ADVANCE);
    return lines.stream().flatMap(line -> folded(line, longest)).toList();
  }

  private static Stream<String> folded(String line, int longest) {
    int space = line.length() > longest && longest > 0 ? line.lastIndexOf(' ', longest) : -1;
    if (space <= 0) {
      return Stream.of(line);
    }
    return Stream.concat(
        Stream.of(line.substring(0, space)), folded(line.substring(space + 1), longest));
  }

  /** Writes the lines below each other into a corner; nothing if there are none. */
  static void paint(Pen pen, Box screen, Corner corner, List<String> lines) {
    if (lines.isEmpty()) {
      return;
    }
    paint(
        pen, corner.box(room(screen), width(lines), height(lines.size())), corner.anchor(), lines);
  }

  /** Writes a line beside a place of the picture: the place is where the ground begins. */
  public static void paint(Pen pen, double left, double top, String line) {
    List<String> lines = List.of(line);
    Box box = new Box(left, top, left + width(lines), top + height(1));
    paint(pen, box, Anchor.START, lines);
  }

  private static void paint(Pen pen, Box box, Anchor anchor, List<String> lines) {
    ground(pen, box);
    write(pen, box, anchor, lines);
  }

  /** Writes the lines below each other, without a ground. */
  static void write(Pen pen, Box box, Anchor anchor, List<String> lines) {
    pen.style(Stroke.fill(Ink.LABEL));
    double x = anchor == Anchor.START ? box.minX() + PADDING : box.maxX() - PADDING;
    double baseline = box.minY() + PADDING + SIZE - 1;
    for (String line : lines) {
      pen.text(x, baseline, anchor, SIZE, line);
      baseline += LEADING;
    }
  }

  /** The ground of a caption. */
  static void ground(Pen pen, Box box) {
    pen.style(Stroke.fill(Ink.BACKGROUND));
    pen.rectangle(box.minX(), box.minY(), 2 * box.halfWidth(), 2 * box.halfHeight());
  }
}
