package dct.render;

import dct.core.geometry.Box;
import java.util.Arrays;

/** Things in a row, cut into runs of {@value #SIZE}; each run has the box of what is in it. */
final class Blocks {
  static final int SIZE = 256;

  private final int things;
  private final double[] minX; // by block
  private final double[] minY;
  private final double[] maxX;
  private final double[] maxY;

  /** Blocks of so many things, their boxes still empty. */
  Blocks(int things) {
    this.things = things;
    int count = (things + SIZE - 1) / SIZE;
    minX = filled(count, Double.POSITIVE_INFINITY);
    minY = filled(count, Double.POSITIVE_INFINITY);
    maxX = filled(count, Double.NEGATIVE_INFINITY);
    maxY = filled(count, Double.NEGATIVE_INFINITY);
  }

  private static double[] filled(int count, double value) {
    double[] values = new double[count];
    Arrays.fill(values, value);
    return values;
  }

  /** Says that a thing reaches this point. */
  void include(int thing, double x, double y) {
    int block = thing / SIZE;
    minX[block] = Math.min(minX[block], x);
    minY[block] = Math.min(minY[block], y);
    maxX[block] = Math.max(maxX[block], x);
    maxY[block] = Math.max(maxY[block], y);
  }

  /** The number of blocks. */
  int count() {
    return minX.length;
  }

  /** The first thing in a block. */
  int first(int block) {
    return block * SIZE;
  }

  /** The thing behind the last one in a block. */
  int end(int block) {
    return Math.min(things, (block + 1) * SIZE);
  }

  /** Whether a thing of the block can reach into this part of the screen. */
  boolean mayMeet(int block, Viewport view, Box screen) {
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
