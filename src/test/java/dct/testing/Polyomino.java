package dct.testing;

import dct.core.geometry.Points;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;

/**
 * Unit cells that form a region whose outline is one simple polygon: no hole, no touching corner.
 */
final class Polyomino {
  private static final int[] DX = {1, 1, 0, -1, -1, -1, 0, 1};
  private static final int[] DY = {0, 1, 1, 1, 0, -1, -1, -1};

  private record Cell(int x, int y) {
    Cell near(int direction) {
      return new Cell(x + DX[direction], y + DY[direction]);
    }
  }

  private final Set<Cell> cells = new HashSet<>();
  private final List<Cell> inOrder = new ArrayList<>();

  private Polyomino() {}

  /** About so many cells, each joined to a random earlier one. */
  static Polyomino grow(int count, Random random) {
    Polyomino region = new Polyomino();
    region.add(new Cell(0, 0));
    for (int tries = 0; region.cells.size() < count && tries < 50 * count; tries++) {
      Cell from = region.inOrder.get(random.nextInt(region.inOrder.size()));
      Cell to = from.near(2 * random.nextInt(4));
      if (region.mayAdd(to)) {
        region.add(to);
      }
    }
    return region;
  }

  /** The corridors of a random tree over squares two cells apart. */
  static Polyomino maze(int squares, Random random) {
    Polyomino region = new Polyomino();
    List<Cell> open = new ArrayList<>();
    open.add(new Cell(0, 0));
    region.add(open.get(0));
    while (open.size() < squares) {
      Cell from = open.get(Math.max(0, open.size() - 1 - random.nextInt(8)));
      from = random.nextInt(4) == 0 ? open.get(random.nextInt(open.size())) : from;
      int direction = 2 * random.nextInt(4);
      Cell wall = from.near(direction);
      Cell square = wall.near(direction);
      if (!region.cells.contains(square)) {
        region.add(wall);
        region.add(square);
        open.add(square);
      }
    }
    return region;
  }

  private void add(Cell cell) {
    if (cells.add(cell)) {
      inOrder.add(cell);
    }
  }

  /** Whether the filled ones among the eight neighbours are one run that a side takes part in. */
  private boolean mayAdd(Cell cell) {
    int runs = 0;
    boolean corner = false;
    for (int d = 0; d < 8; d++) {
      boolean here = cells.contains(cell.near(d));
      runs += here && !cells.contains(cell.near((d + 1) % 8)) ? 1 : 0;
      corner |=
          here
              && d % 2 == 1
              && !cells.contains(cell.near(d - 1))
              && !cells.contains(cell.near((d + 1) % 8));
    }
    return runs == 1 && !corner && !cells.contains(cell);
  }

  /** The boundary, counter-clockwise; with every grid point on it, or with the corners only. */
  Points outline(boolean everyGridPoint) {
    Cell lowest = inOrder.get(0);
    for (Cell cell : inOrder) {
      if (cell.y < lowest.y || (cell.y == lowest.y && cell.x < lowest.x)) {
        lowest = cell;
      }
    }
    List<long[]> corners = new ArrayList<>();
    int x = lowest.x;
    int y = lowest.y;
    int direction = 0; // in quarter turns
    do {
      int turned = turn(x, y, direction);
      if (everyGridPoint || turned != direction) {
        corners.add(new long[] {x, y});
      }
      direction = turned;
      x += DX[2 * direction];
      y += DY[2 * direction];
    } while (x != lowest.x || y != lowest.y);
    return RandomPolygons.points(withStart(corners, lowest, everyGridPoint));
  }

  private static long[][] withStart(List<long[]> corners, Cell lowest, boolean everyGridPoint) {
    if (!everyGridPoint) {
      corners.add(0, new long[] {lowest.x, lowest.y});
    }
    return corners.toArray(long[][]::new);
  }

  /** The direction in which the boundary goes on at a grid point, the region on its left. */
  private int turn(int x, int y, int direction) {
    for (int d : new int[] {(direction + 3) % 4, direction, (direction + 1) % 4}) {
      if (isInside(x, y, d, true) && !isInside(x, y, d, false)) {
        return d;
      }
    }
    throw new IllegalStateException("no way on at " + x + ", " + y);
  }

  /** Whether the cell on the left (or right) of the unit edge from (x, y) is filled. */
  private boolean isInside(int x, int y, int d, boolean left) {
    int cx = (d == 1 && left) || (d == 3 && !left) || d == 2 ? x - 1 : x;
    int cy = (d == 0 && !left) || (d == 2 && left) || d == 3 ? y - 1 : y;
    return cells.contains(new Cell(cx, cy));
  }
}
