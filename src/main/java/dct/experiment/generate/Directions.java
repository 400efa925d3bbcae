package dct.experiment.generate;

import dct.core.geometry.Predicates;

/** The order of vectors by direction, exactly, for components of at most 53 bits. */
final class Directions {
  private Directions() {}

  /** Compares the angles of two vectors other than zero, from 0 to a full turn. */
  static int compare(long ux, long uy, long vx, long vy) {
    int half = Boolean.compare(isLower(ux, uy), isLower(vx, vy));
    return half != 0 ? half : -turn(ux, uy, vx, vy);
  }

  private static boolean isLower(long x, long y) {
    return y < 0 || (y == 0 && x < 0);
  }

  /** The turn from u to v: 1 to the left, −1 to the right, 0 if they are parallel. */
  static int turn(long ux, long uy, long vx, long vy) {
    return Predicates.orient(0, 0, (double) ux, (double) uy, (double) vx, (double) vy);
  }
}
