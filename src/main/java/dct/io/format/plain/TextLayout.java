package dct.io.format.plain;

import dct.core.geometry.Points;
import dct.io.format.Columns;
import dct.io.format.UnclearColumns;
import dct.io.text.BadInputException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * What the lines of a text tell beside its vertices: how many there are, and groups that could be
 * rings of their own.
 *
 * <p>A line of counts is never taken for a vertex silently. A line with one whole number, with as
 * many vertices behind it, is understood. Two whole numbers are counts where the first is the
 * number of lines that follow, three or more, and the second 0, 1 or 2 (a flag, or the number of
 * columns), where the same goes on until the last line (rings one after the other), or where as
 * many vertices and edges follow.
 */
public final class TextLayout {
  private static final int SMALLEST_RING = 3;

  private final String name;
  private int count = -1; // of the last line with one number
  private long counted; // where the ring of the last count ends
  private int countLine;
  private boolean startsWhole; // the first vertex is written as two whole numbers
  private boolean startsWithComma; // or semicolon, between them
  private boolean moreWhole; // another vertex has a whole number
  private int groupStart; // the first vertex of the present group
  private final List<Integer> gaps = new ArrayList<>(); // the first vertex behind each blank line
  private boolean hasRing; // a group has enough vertices

  /** The layout of a text, which messages call by this name. */
  TextLayout(String name) {
    this.name = name;
  }

  /**
   * Whether a line with one whole number, behind this many vertices, is a line of counts: the first
   * line, or the one behind a ring that is complete.
   */
  boolean isCount(double number, int vertices, int line) {
    boolean isNext = count >= 0 && vertices == counted;
    if (!isNext && (vertices > 0 || count >= 0)) {
      return false;
    }
    count = (int) Math.min(number, Integer.MAX_VALUE);
    counted = Math.addExact((long) vertices, count);
    countLine = line;
    if (isNext) {
      ring(vertices);
    }
    return true;
  }

  /** Whether the first vertex is written as two whole numbers. */
  boolean startsWhole() {
    return startsWhole && count < 0;
  }

  /** The number in the first line, if two whole numbers follow that could be counts; or else 0. */
  int polygons() {
    return startsWhole && counted == count ? count : 0;
  }

  /** The last line of counts. */
  int countLine() {
    return countLine;
  }

  /** Whether there was a line of counts. */
  boolean hasCount() {
    return count >= 0;
  }

  /** Hears of a vertex: its number, whether its parts are written whole, what stands between. */
  void vertex(int v, boolean xWhole, boolean yWhole, byte separator) {
    if (v == 0) {
      startsWhole = xWhole && yWhole;
      startsWithComma = separator == ',' || separator == ';';
    } else {
      moreWhole |= xWhole || yWhole;
    }
  }

  /** Hears of a blank line behind this many vertices. */
  void blankLine(int vertices) {
    if (vertices > groupStart) {
      endGroup(vertices);
      gaps.add(vertices);
    }
  }

  /** Hears that another ring begins behind this many vertices. */
  void ring(int vertices) {
    endGroup(vertices);
    hasRing = true;
    gaps.add(vertices);
  }

  private void endGroup(int vertices) {
    hasRing |= vertices - groupStart >= SMALLEST_RING;
    groupStart = vertices;
  }

  /**
   * The first vertex of each group between blank lines, if one of them has enough vertices for a
   * ring; otherwise 0 alone: single vertices with blank lines between them are one ring.
   *
   * @param vertices how many there are
   */
  int[] groups(int vertices) {
    endGroup(vertices);
    return hasRing
        ? IntStream.concat(IntStream.of(0), gaps.stream().mapToInt(Integer::intValue))
            .filter(start -> start < vertices)
            .toArray()
        : new int[1];
  }

  /**
   * Looks for a count that is wrong, and for a header of numbers.
   *
   * @throws BadInputException if there is one
   */
  void check(Points points, int[] lines) {
    if (count >= 0 && counted != lines.length) {
      String fault =
          "this looks like a count of "
              + count
              + " vertices, but "
              + (lines.length - (counted - count))
              + " follow";
      throw new BadInputException(name, countLine, fault + "; correct or remove the line");
    }
    if (count < 0 && startsWhole) {
      checkHeader(points, lines[0]);
    }
  }

  private void checkHeader(Points points, int line) {
    boolean isPair = points.x(0) == 0 && points.y(0) == 1;
    if (isPair && startsWithComma && !moreWhole && points.size() > 1) {
      List<double[]> rows =
          IntStream.range(0, Math.min(points.size(), UnclearColumns.ROWS))
              .mapToObj(v -> new double[] {points.x(v), points.y(v)})
              .toList();
      throw new UnclearColumns(
          name,
          line,
          "this looks like a header that numbers the columns; remove the line, give --skip 1, or"
              + " write 0.0 1.0 if it is a vertex",
          rows,
          new Columns(Optional.empty(), line));
    }
  }

  /** Whether the first of these points, written as whole numbers, would be taken for counts. */
  public static boolean looksLikeCounts(Points points) {
    return points.size() > 0 && (isCounts(points) || isCountsOfEdges(points));
  }

  /** Rings one after the other, each behind its count and a number from 0 to 2. */
  static boolean isCounts(Points points) {
    long i = 0;
    while (i < points.size()) {
      double x = points.x((int) i);
      double y = points.y((int) i);
      if (!isWhole(x, SMALLEST_RING) || !isWhole(y, 0) || y > 2) {
        return false;
      }
      i += (long) x + 1;
    }
    return i == points.size();
  }

  /** Vertices, then edges as pairs of their numbers, behind both counts. */
  static boolean isCountsOfEdges(Points points) {
    double x = points.x(0);
    double y = points.y(0);
    if (!isWhole(x, SMALLEST_RING) || !isWhole(y, 1) || x + y != points.size() - 1) {
      return false;
    }
    for (int e = (int) x + 1; e < points.size(); e++) {
      boolean isEdge = isWhole(points.x(e), 0) && isWhole(points.y(e), 0);
      if (!isEdge || Math.max(points.x(e), points.y(e)) > x) {
        return false;
      }
    }
    return true;
  }

  private static boolean isWhole(double value, int least) {
    return value >= least && value == (int) value;
  }
}
