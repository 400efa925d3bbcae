package dct.experiment.generate;

import dct.core.SeededRandom;

/**
 * Unit cells that form a region without holes whose parts do not touch at a corner, so that its
 * outline is one simple polygon; it grows by random cells.
 */
final class CellRegion {
  private static final int TRIES = 100;

  private final int width; // of the box, with an empty cell on either side
  private final boolean[] filled;
  private final int[] around; // from a cell to its neighbours, counter-clockwise from the right
  private final int[] open; // filled cells beside which there may be room
  private int openCount;
  private int corners = 4;

  /** One cell in the middle of a box. */
  CellRegion(int columns, int rows) {
    width = columns + 2;
    filled = new boolean[width * (rows + 2)];
    around = new int[] {1, width + 1, width, width - 1, -1, -width - 1, -width, 1 - width};
    open = new int[columns * rows];
    fill((rows / 2 + 1) * width + columns / 2 + 1);
  }

  private void fill(int cell) {
    filled[cell] = true;
    open[openCount++] = cell;
  }

  /** Adds random cells until the outline has n corners; false if it does not come to that. */
  boolean growTo(int n, SeededRandom random) {
    for (long tries = 0; tries < (long) TRIES * (n + TRIES) && openCount > 0; tries++) {
      if (corners == n) {
        return true;
      }
      int k = random.nextInt(openCount);
      int cell = open[k] + around[2 * random.nextInt(4)];
      if (mayFill(cell)) {
        if (corners + gain(cell) <= n) {
          corners += gain(cell);
          fill(cell);
        }
      } else if (isClosed(open[k])) {
        open[k] = open[--openCount];
      }
    }
    return corners == n;
  }

  private boolean isClosed(int cell) {
    for (int side = 0; side < 8; side += 2) {
      if (mayFill(cell + around[side])) {
        return false;
      }
    }
    return true;
  }

  /**
   * Whether a cell is empty, in the box, its filled neighbours are one run, and it takes no corner
   * away. Without the last the bays would fill up, and corners be as few as a round region has.
   */
  private boolean mayFill(int cell) {
    int column = cell % width;
    if (filled[cell]
        || column == 0
        || column == width - 1
        || cell < width
        || cell >= filled.length - width) {
      return false;
    }
    int runs = 0;
    for (int k = 0; k < 8; k++) {
      runs += filled[cell + around[k]] && !filled[cell + around[(k + 1) % 8]] ? 1 : 0;
    }
    return runs == 1 && gain(cell) >= 0;
  }

  /** By how much the number of corners grows if this cell is filled. */
  private int gain(int cell) {
    int gain = 0;
    for (int k = 0; k < 8; k += 2) {
      int count = 0; // of the other three cells at this corner, the filled ones
      for (int i = 0; i < 3; i++) {
        count += filled[cell + around[(k + i) % 8]] ? 1 : 0;
      }
      gain += count % 2 == 0 ? 1 : -1;
    }
    return gain;
  }

  /** The width of the box with its empty border, in which {@link #outline} counts. */
  int width() {
    return width;
  }

  /**
   * The corners of the outline, counter-clockwise; each is row · width + column of the cell on its
   * upper right.
   */
  int[] outline() {
    int[] outline = new int[corners];
    int at = lowest();
    int way = 0; // right, up, left, down
    for (int size = 0; size < corners; at += around[2 * way]) {
      int turned = turned(at, way);
      if (size == 0 || turned != way) {
        outline[size++] = at;
      }
      way = turned;
    }
    return outline;
  }

  /** The way on at a corner of a cell, the region on the left. */
  private int turned(int at, int way) {
    if (isFilled(at, way + 3)) {
      return (way + 3) % 4;
    }
    return isFilled(at, way) ? way : (way + 1) % 4;
  }

  /** Whether the cell is filled that is ahead on the left; a quarter turn less: on the right. */
  private boolean isFilled(int at, int way) {
    return switch (way % 4) {
      case 0 -> filled[at];
      case 1 -> filled[at - 1];
      case 2 -> filled[at - 1 - width];
      default -> filled[at - width];
    };
  }

  private int lowest() {
    int cell = 0;
    while (!filled[cell]) {
      cell++;
    }
    return cell;
  }
}
