package dct.render;

import dct.core.geometry.Box;
import java.util.Arrays;

/**
 * Things in a row, cut into runs of {@value #SIZE}; each run has the box of what is in it, and so
 * have groups of runs, and groups of groups. What is in a part of the screen is found without a
 * look at most of the others.
 */
final class Blocks {
  static final int SIZE = 256;
  private static final int GROUP = 32;

  private final int things;
  private final int size;
  private final double[] minX; // by block
  private final double[] minY;
  private final double[] maxX;
  private final double[] maxY;
  private final Blocks groups; // the blocks are its things; null if there are few of them

  /** Blocks of so many things, their boxes still empty. */
  Blocks(int things) {
    this(things, SIZE);
  }

  private Blocks(int things, int size) {
    this.things = things;
    this.size = size;
    int count = (things + size - 1) / size;
    minX = filled(count, Double.POSITIVE_INFINITY);
    minY = filled(count, Double.POSITIVE_INFINITY);
    maxX = filled(count, Double.NEGATIVE_INFINITY);
    maxY = filled(count, Double.NEGATIVE_INFINITY);
    groups = count > GROUP ? new Blocks(count, GROUP) : null;
  }

  private static double[] filled(int count, double value) {
    double[] values = new double[count];
    Arrays.fill(values, value);
    return values;
  }

  /** Says that a thing reaches this point. */
  void include(int thing, double x, double y) {
    int block = thing / size;
    minX[block] = Math.min(minX[block], x);
    minY[block] = Math.min(minY[block], y);
    maxX[block] = Math.max(maxX[block], x);
    maxY[block] = Math.max(maxY[block], y);
  }

  /** Says that all has been included. */
  void close() {
    if (groups != null) {
      for (int block = 0; block < minX.length; block++) {
        groups.include(block, minX[block], minY[block]);
        groups.include(block, maxX[block], maxY[block]);
      }
      groups.close();
    }
  }

  /** The number of blocks. */
  int count() {
    return minX.length;
  }

  /** The first thing in a block. */
  int first(int block) {
    return block * size;
  }

  /** The thing behind the last one in a block. */
  int end(int block) {
    return Math.min(things, (block + 1) * size);
  }

  /**
   * The first block, from this one on, of which a thing can reach into this part of the screen; the
   * number of blocks if there is none.
   */
  int next(int block, Viewport view, Box screen) {
    int b = block;
    while (b < count()) {
      if (groups != null && b % GROUP == 0) {
        b = groups.next(b / GROUP, view, screen) * GROUP;
      }
      if (b < count() && mayMeet(b, view, screen)) {
        return b;
      }
      b++;
    }
    return count();
  }

  private boolean mayMeet(int block, Viewport view, Box screen) {
    return screen.mayMeet(
        view.screenX(minX[block]),
        view.screenY(minY[block]),
        view.screenX(maxX[block]),
        view.screenY(maxY[block]));
  }

  /** How far a point of the screen is from the box of a block, in pixels. */
  double distance(int block, Viewport view, double x, double y) {
    double dx = outside(x, view.screenX(minX[block]), view.screenX(maxX[block]));
    double dy = outside(y, view.screenY(minY[block]), view.screenY(maxY[block]));
    return Math.sqrt(dx * dx + dy * dy);
  }

  private static double outside(double value, double end, double otherEnd) {
    double low = Math.min(end, otherEnd);
    double high = Math.max(end, otherEnd);
    return Math.max(0, Math.max(low - value, value - high));
  }
}
