package dct.render;

import dct.core.geometry.Box;

/**
 * The screen cut into small squares, each of them taken or free. The squares lie fast in the
 * picture: when it is panned they move with it, and the same ones are taken as before.
 */
final class Cells {
  /** The side of a square, in pixels. */
  static final double SIDE = 4;

  private static final int WORD = Long.SIZE;

  private final double left;
  private final double top;
  private final int columns;
  private final int rows;
  private final int words; // of a row
  private final long[] taken; // a bit for each square, row by row

  /** Free squares over a part of the screen. */
  Cells(Box screen, Viewport view) {
    left = screen.minX() - offset(view.screenX(0) - screen.minX());
    top = screen.minY() - offset(view.screenY(0) - screen.minY());
    columns = (int) Math.ceil((screen.maxX() - left) / SIDE) + 1;
    rows = (int) Math.ceil((screen.maxY() - top) / SIDE) + 1;
    words = (columns + WORD - 1) / WORD;
    taken = new long[words * rows];
  }

  /** How far the first square reaches out of the screen, so that one begins at the origin. */
  private static double offset(double origin) {
    double rest = origin % SIDE;
    return Double.isNaN(rest) ? 0 : (SIDE - rest) % SIDE;
  }

  private int column(double x) {
    return Math.max(0, Math.min(columns - 1, (int) ((x - left) / SIDE)));
  }

  private int row(double y) {
    return Math.max(0, Math.min(rows - 1, (int) ((y - top) / SIDE)));
  }

  /** Takes the squares that meet a box. */
  void take(double minX, double minY, double maxX, double maxY) {
    int first = column(minX);
    int last = column(maxX);
    for (int row = row(minY); row <= row(maxY); row++) {
      for (int word = first / WORD; word <= last / WORD; word++) {
        taken[row * words + word] |= mask(word, first, last);
      }
    }
  }

  /** Takes the squares along a line, as far as it is on the screen. */
  void takeLine(double x1, double y1, double x2, double y2) {
    double dx = x2 - x1;
    double dy = y2 - y1;
    double right = left + columns * SIDE;
    double bottom = top + rows * SIDE;
    double from = Math.max(enter(x1, dx, left, right), enter(y1, dy, top, bottom));
    double to = 1 - Math.max(enter(x2, -dx, left, right), enter(y2, -dy, top, bottom));
    double length = (to - from) * Math.max(Math.abs(dx), Math.abs(dy));
    double steps = Math.ceil(2 * length / SIDE); // two in each cell that is crossed
    for (int i = 0; i <= steps; i++) {
      double part = steps == 0 ? from : from + (to - from) * i / steps;
      int column = column(x1 + part * dx);
      taken[row(y1 + part * dy) * words + column / WORD] |= 1L << (column % WORD);
    }
  }

  /** The part of a way from a by d that lies before a range; 2 if it never reaches it. */
  private static double enter(double a, double d, double low, double high) {
    if (a >= low && a <= high) {
      return 0;
    }
    double part = ((a < low ? low : high) - a) / d;
    return part >= 0 ? part : 2;
  }

  /** Whether the square at this place is free. */
  boolean isFree(double x, double y) {
    int column = column(x);
    return (taken[row(y) * words + column / WORD] & 1L << (column % WORD)) == 0;
  }

  /** Whether no square that meets a box is taken. */
  boolean isFree(double minX, double minY, double maxX, double maxY) {
    return count(minX, minY, maxX, maxY, 1) == 0;
  }

  /** How many of the squares that meet a box are taken. */
  int count(double minX, double minY, double maxX, double maxY) {
    return count(minX, minY, maxX, maxY, Integer.MAX_VALUE);
  }

  private int count(double minX, double minY, double maxX, double maxY, int enough) {
    int first = column(minX);
    int last = column(maxX);
    int lastRow = row(maxY);
    int count = 0;
    for (int row = row(minY); row <= lastRow && count < enough; row++) {
      for (int word = first / WORD; word <= last / WORD; word++) {
        count += Long.bitCount(taken[row * words + word] & mask(word, first, last));
      }
    }
    return count;
  }

  /** The bits of a word that stand for columns of a range. */
  private static long mask(int word, int first, int last) {
    int from = Math.max(first - word * WORD, 0);
    int to = Math.min(last - word * WORD, WORD - 1);
    return (-1L << from) & (-1L >>> (WORD - 1 - to));
  }
}
