package dct.core.triangulate;

import dct.core.geometry.Box;
import dct.core.geometry.Points;

/**
 * The cells of a grid over the bounding box of some points, numbered so that halving the numbers
 * again and again halves the box, first between left and right, then between lower and upper.
 *
 * <p>A point whose cell is further right than another's has a larger x, and one whose cell is
 * higher has a larger y: each step from coordinate to cell is monotone, however it is rounded.
 */
final class CellNumbers {
  private final double left;
  private final double bottom;
  private final double perX; // columns a unit of length; infinite if all have the same x
  private final double perY;
  private final int columns;
  private final int rows;
  private final boolean endsWithX; // the last halving is between left and right

  CellNumbers(Points points, int levels) {
    Box box = Box.of(points);
    left = box.minX();
    bottom = box.minY();
    columns = 1 << ((levels + 1) / 2);
    rows = 1 << (levels / 2);
    perX = columns / (box.maxX() - box.minX());
    perY = rows / (box.maxY() - box.minY());
    endsWithX = (levels & 1) == 1;
  }

  /** The number of the cell with this point, 0 … 2^levels − 1. */
  int of(double x, double y) {
    int column = index((x - left) * perX, columns);
    int row = index((y - bottom) * perY, rows);
    return endsWithX ? spread(column) | spread(row) << 1 : spread(column) << 1 | spread(row);
  }

  /** Of a value from 0 on; not a number, from a box without width or of infinite width, is 0. */
  private static int index(double value, int count) {
    return Math.min((int) value, count - 1);
  }

  /** The lower sixteen bits, each followed by a zero above it. */
  private static int spread(int bits) {
    int b = (bits | bits << 8) & 0x00FF00FF;
    b = (b | b << 4) & 0x0F0F0F0F;
    b = (b | b << 2) & 0x33333333;
    return (b | b << 1) & 0x55555555;
  }
}
