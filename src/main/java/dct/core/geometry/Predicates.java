package dct.core.geometry;

/**
 * The two geometric tests on which everything rests, decided exactly for every finite double.
 *
 * <p>Stages, each taken only where those before cannot decide: the determinant in floating point
 * with a bound on its rounding error (the static filter of J. R. Shewchuk, <i>Adaptive Precision
 * Floating-Point Arithmetic and Fast Robust Geometric Predicates</i>, 1997); the same where nothing
 * had to be rounded, as on lattices; in circles, with twice the digits ({@link Twofold}), as on a
 * circle; the exact determinant as a sum of doubles ({@link Expansion}); and {@link
 * java.math.BigDecimal} where an exponent is so extreme that such a sum could overflow or
 * underflow. No tolerance anywhere.
 */
public final class Predicates {

  /** Which stage decided; only tests look at it. */
  enum Stage {
    FILTER,
    UNROUNDED,
    TWOFOLD,
    EXPANSION,
    BIG_DECIMAL
  }

  private static final double EPSILON = 0x1p-53;
  private static final double ORIENT_BOUND = (3 + 16 * EPSILON) * EPSILON;
  private static final double IN_CIRCLE_BOUND = (10 + 96 * EPSILON) * EPSILON;

  private static final double TWOFOLD_BOUND = 0x1p-90; // some sixty times the rounding errors

  // Within these the filters' bounds hold although a product may have underflowed.
  private static final double ORIENT_SMALLEST = 0x1p-900;
  private static final double IN_CIRCLE_SMALLEST = 0x1p-400;
  private static final double IN_CIRCLE_LARGEST_LIFT = 0x1p400;

  // Coordinates of these magnitudes, and zero, keep every term of the fourth degree normal.
  private static final double SMALLEST = 0x1p-200;
  private static final double LARGEST = 0x1p200;

  // In ulps of the largest, the unit of numbers of twelve bits.
  private static final double SHORT = 0x1p41;

  private Predicates() {}

  /**
   * The turn from a by b to c: positive if it is to the left (the triangle abc is
   * counter-clockwise), negative if to the right, zero if the three lie on one line.
   *
   * @return −1, 0 or 1
   */
  public static int orient(double ax, double ay, double bx, double by, double cx, double cy) {
    double det = filteredOrient(ax, ay, bx, by, cx, cy);
    return det != 0 ? (det > 0 ? 1 : -1) : orientExactly(ax, ay, bx, by, cx, cy);
  }

  /** The determinant in floating point if its sign is certain, or else zero. */
  private static double filteredOrient(
      double ax, double ay, double bx, double by, double cx, double cy) {
    double left = (ax - cx) * (by - cy);
    double right = (ay - cy) * (bx - cx);
    double det = left - right;
    double magnitude = Math.abs(left) + Math.abs(right);
    boolean certain = Math.abs(det) > ORIENT_BOUND * magnitude && magnitude > ORIENT_SMALLEST;
    return certain ? det : 0;
  }

  /** The determinant if nothing but its last difference is rounded, or else not a number. */
  private static double unroundedOrient(
      double ax, double ay, double bx, double by, double cx, double cy) {
    double acx = ax - cx;
    double acy = ay - cy;
    double bcx = bx - cx;
    double bcy = by - cy;
    double left = acx * bcy;
    double right = acy * bcx;
    boolean exact =
        isExact(ax, cx, acx)
            && isExact(ay, cy, acy)
            && isExact(bx, cx, bcx)
            && isExact(by, cy, bcy)
            && Math.fma(acx, bcy, -left) == 0
            && Math.fma(acy, bcx, -right) == 0;
    return exact ? left - right : Double.NaN;
  }

  /** Whether a − b did not have to be rounded. */
  private static boolean isExact(double a, double b, double difference) {
    return Expansion.twoSumTail(a, -b, difference) == 0;
  }

  /**
   * Whether d lies inside the circle through a, b and c, which must be counter-clockwise: positive
   * if inside, negative if outside, zero if on it. (For clockwise a, b, c the sign is reversed.)
   *
   * @return −1, 0 or 1
   */
  public static int inCircle(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
    double det = filteredInCircle(ax, ay, bx, by, cx, cy, dx, dy);
    return det != 0 ? (det > 0 ? 1 : -1) : inCircleExactly(ax, ay, bx, by, cx, cy, dx, dy);
  }

  /** The determinant in floating point if its sign is certain, or else zero. */
  private static double filteredInCircle(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
    double adx = ax - dx;
    double ady = ay - dy;
    double bdx = bx - dx;
    double bdy = by - dy;
    double cdx = cx - dx;
    double cdy = cy - dy;
    double aLift = adx * adx + ady * ady;
    double bLift = bdx * bdx + bdy * bdy;
    double cLift = cdx * cdx + cdy * cdy;
    double det = inCircleDeterminant(adx, ady, bdx, bdy, cdx, cdy);
    double magnitude =
        aLift * (Math.abs(bdx * cdy) + Math.abs(cdx * bdy))
            + bLift * (Math.abs(cdx * ady) + Math.abs(adx * cdy))
            + cLift * (Math.abs(adx * bdy) + Math.abs(bdx * ady));
    boolean certain =
        Math.abs(det) > IN_CIRCLE_BOUND * magnitude
            && magnitude > IN_CIRCLE_SMALLEST
            && aLift + bLift + cLift < IN_CIRCLE_LARGEST_LIFT;
    return certain ? det : 0;
  }

  /** In floating point. */
  private static double inCircleDeterminant(
      double adx, double ady, double bdx, double bdy, double cdx, double cdy) {
    return (adx * adx + ady * ady) * (bdx * cdy - cdx * bdy)
        + (bdx * bdx + bdy * bdy) * (cdx * ady - adx * cdy)
        + (cdx * cdx + cdy * cdy) * (adx * bdy - bdx * ady);
  }

  /**
   * The determinant if nothing is rounded, or else not a number. Sure of it only where the
   * differences are multiples of one power of two by at most 2¹², so that those of the fourth
   * degree stay below 2⁵³.
   */
  private static double unroundedInCircle(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
    double adx = ax - dx;
    double ady = ay - dy;
    double bdx = bx - dx;
    double bdy = by - dy;
    double cdx = cx - dx;
    double cdy = cy - dy;
    double largestX = Math.max(Math.abs(adx), Math.max(Math.abs(bdx), Math.abs(cdx)));
    double largestY = Math.max(Math.abs(ady), Math.max(Math.abs(bdy), Math.abs(cdy)));
    double perUnit = 1 / (SHORT * Math.ulp(Math.max(largestX, largestY)));
    boolean exact =
        isShort(ax, dx, adx, perUnit)
            && isShort(ay, dy, ady, perUnit)
            && isShort(bx, dx, bdx, perUnit)
            && isShort(by, dy, bdy, perUnit)
            && isShort(cx, dx, cdx, perUnit)
            && isShort(cy, dy, cdy, perUnit);
    return exact ? inCircleDeterminant(adx, ady, bdx, bdy, cdx, cdy) : Double.NaN;
  }

  /** Whether a − b did not have to be rounded and is a whole number of units. */
  private static boolean isShort(double a, double b, double difference, double perUnit) {
    double units = difference * perUnit;
    return units == Math.rint(units) && isExact(a, b, difference);
  }

  /** The determinant with twice the digits if its sign is certain, or else zero. */
  private static double twofoldInCircle(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
    Twofold adx = Twofold.difference(ax, dx);
    Twofold ady = Twofold.difference(ay, dy);
    Twofold bdx = Twofold.difference(bx, dx);
    Twofold bdy = Twofold.difference(by, dy);
    Twofold cdx = Twofold.difference(cx, dx);
    Twofold cdy = Twofold.difference(cy, dy);
    Twofold aLift = adx.times(adx).plus(ady.times(ady));
    Twofold bLift = bdx.times(bdx).plus(bdy.times(bdy));
    Twofold cLift = cdx.times(cdx).plus(cdy.times(cdy));
    Twofold a = aLift.times(bdx.times(cdy).minus(cdx.times(bdy)));
    Twofold b = bLift.times(cdx.times(ady).minus(adx.times(cdy)));
    Twofold c = cLift.times(adx.times(bdy).minus(bdx.times(ady)));
    double det = a.plus(b).plus(c).high();
    double largest = aLift.high() + bLift.high() + cLift.high(); // |xy| is at most (x² + y²) / 2
    return Math.abs(det) > TWOFOLD_BOUND * largest * largest ? det : 0;
  }

  /** The stage that decides {@link #orient} for these arguments. */
  static Stage orientStage(double ax, double ay, double bx, double by, double cx, double cy) {
    if (filteredOrient(ax, ay, bx, by, cx, cy) != 0) {
      return Stage.FILTER;
    }
    if (!isModerate(ax, ay, bx, by, cx, cy)) {
      return Stage.BIG_DECIMAL;
    }
    boolean rounded = Double.isNaN(unroundedOrient(ax, ay, bx, by, cx, cy));
    return rounded ? Stage.EXPANSION : Stage.UNROUNDED;
  }

  /** The stage that decides {@link #inCircle} for these arguments. */
  static Stage inCircleStage(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
    if (filteredInCircle(ax, ay, bx, by, cx, cy, dx, dy) != 0) {
      return Stage.FILTER;
    }
    if (!isModerate(ax, ay, bx, by, cx, cy, dx, dy)) {
      return Stage.BIG_DECIMAL;
    }
    if (!Double.isNaN(unroundedInCircle(ax, ay, bx, by, cx, cy, dx, dy))) {
      return Stage.UNROUNDED;
    }
    boolean certain = twofoldInCircle(ax, ay, bx, by, cx, cy, dx, dy) != 0;
    return certain ? Stage.TWOFOLD : Stage.EXPANSION;
  }

  private static int orientExactly(
      double ax, double ay, double bx, double by, double cx, double cy) {
    if (!isModerate(ax, ay, bx, by, cx, cy)) {
      return BigPredicates.orient(ax, ay, bx, by, cx, cy);
    }
    double det = unroundedOrient(ax, ay, bx, by, cx, cy);
    if (!Double.isNaN(det)) {
      return (int) Math.signum(det);
    }
    Expansion left = Expansion.difference(ax, cx).times(Expansion.difference(by, cy));
    Expansion right = Expansion.difference(ay, cy).times(Expansion.difference(bx, cx));
    return left.minus(right).sign();
  }

  private static int inCircleExactly(
      double ax, double ay, double bx, double by, double cx, double cy, double dx, double dy) {
    if (!isModerate(ax, ay, bx, by, cx, cy, dx, dy)) {
      return BigPredicates.inCircle(ax, ay, bx, by, cx, cy, dx, dy);
    }
    double det = unroundedInCircle(ax, ay, bx, by, cx, cy, dx, dy);
    if (!Double.isNaN(det)) {
      return (int) Math.signum(det);
    }
    det = twofoldInCircle(ax, ay, bx, by, cx, cy, dx, dy);
    if (det != 0) {
      return det > 0 ? 1 : -1;
    }
    Expansion adx = Expansion.difference(ax, dx);
    Expansion ady = Expansion.difference(ay, dy);
    Expansion bdx = Expansion.difference(bx, dx);
    Expansion bdy = Expansion.difference(by, dy);
    Expansion cdx = Expansion.difference(cx, dx);
    Expansion cdy = Expansion.difference(cy, dy);
    Expansion a = lift(adx, ady).times(cross(bdx, bdy, cdx, cdy));
    Expansion b = lift(bdx, bdy).times(cross(cdx, cdy, adx, ady));
    Expansion c = lift(cdx, cdy).times(cross(adx, ady, bdx, bdy));
    return a.plus(b).plus(c).sign();
  }

  private static Expansion lift(Expansion x, Expansion y) {
    return x.times(x).plus(y.times(y));
  }

  private static Expansion cross(Expansion ux, Expansion uy, Expansion vx, Expansion vy) {
    return ux.times(vy).minus(vx.times(uy));
  }

  private static boolean isModerate(double... coordinates) {
    for (double c : coordinates) {
      double magnitude = Math.abs(c);
      if (magnitude > LARGEST || (magnitude < SMALLEST && magnitude != 0)) {
        return false;
      }
    }
    return true;
  }
}
