package dct.core.geometry;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import java.util.Optional;

/**
 * The points inside a segment whose coordinates doubles hold exactly: those c for which the turn a,
 * b, c is zero without any rounding.
 *
 * <p>With all coordinates as whole multiples of one power of two and u the shortest such vector
 * along the segment, they are a + k · u / 2ʳ for the k at which both coordinates are multiples of
 * the unit in the last place there: one linear congruence modulo a power of two for each
 * coordinate. Coarser units are tried first, since their coordinates have fewer digits. Whole
 * coordinates always have such a point (the middle is one); two arbitrary doubles often have none.
 *
 * <p>Some ten microseconds, in integers of any length.
 */
public final class SegmentPoints {
  private static final int COARSER_UNITS = 60; // than the last place; then that one
  private static final int DIGITS = 53;
  private static final int LEAST_EXPONENT = -1074;

  /**
   * A point of the segment.
   *
   * @param x its x
   * @param y its y
   */
  public record Place(double x, double y) {}

  private final int unit; // coordinates are whole multiples of 2 to this power
  private final BigInteger ax;
  private final BigInteger ay;
  private final BigInteger ux; // along the segment, without a common divisor
  private final BigInteger uy;
  private final BigInteger steps; // of u from a to b
  private final double x; // of the place that is asked for
  private final double y;
  private final double t;

  private SegmentPoints(double ax, double ay, double bx, double by, double t) {
    unit = Math.min(Math.min(lastBit(ax), lastBit(ay)), Math.min(lastBit(bx), lastBit(by)));
    this.ax = multiple(ax, unit);
    this.ay = multiple(ay, unit);
    BigInteger dx = multiple(bx, unit).subtract(this.ax);
    BigInteger dy = multiple(by, unit).subtract(this.ay);
    steps = dx.gcd(dy);
    ux = dx.divide(steps);
    uy = dy.divide(steps);
    x = ax * (1 - t) + bx * t;
    y = ay * (1 - t) + by * t;
    this.t = t;
  }

  /**
   * A point strictly inside the segment from a to b, which are different and finite.
   *
   * @param t which point is asked for: a + t (b − a), with t from 0 to 1
   * @param within a point so near is near enough in each coordinate; of these one with few digits
   *     is taken
   * @return else the nearest, as long as neither coordinate doubles or halves on the way; nothing
   *     if none was found
   */
  public static Optional<Place> near(
      double ax, double ay, double bx, double by, double t, double within) {
    return new SegmentPoints(ax, ay, bx, by, t).search(within);
  }

  private Optional<Place> search(double within) {
    if (within > 0) {
      int coarsest = Math.getExponent(within);
      int finest = Math.max(coarsest - COARSER_UNITS, LEAST_EXPONENT);
      for (int last = coarsest; last > finest; last--) {
        Optional<Place> place = onMultiplesOf(last);
        if (place.isPresent() && isWithin(place.get(), within)) {
          return place;
        }
      }
    }
    return onMultiplesOf(LEAST_EXPONENT);
  }

  private boolean isWithin(Place place, double within) {
    return Math.abs(place.x() - x) <= within && Math.abs(place.y() - y) <= within;
  }

  /** The nearest point whose coordinates are multiples of 2 to this power, as far as needed. */
  private Optional<Place> onMultiplesOf(int exponent) {
    int lastX = Math.max(exponent, lastPlace(x));
    int lastY = Math.max(exponent, lastPlace(y));
    int finer = Math.max(0, unit - Math.min(lastX, lastY));
    Residue both =
        Residue.of(ax.shiftLeft(finer), ux, lastX - unit + finer)
            .and(Residue.of(ay.shiftLeft(finer), uy, lastY - unit + finer));
    if (both.equals(Residue.NONE)) {
      return Optional.empty();
    }
    BigInteger end = steps.shiftLeft(finer);
    BigInteger k = both.nearest(new BigDecimal(end).multiply(new BigDecimal(t)));
    if (k.signum() <= 0) {
      k = k.add(both.modulus());
    } else if (k.compareTo(end) >= 0) {
      k = k.subtract(both.modulus());
    }
    return k.signum() > 0 && k.compareTo(end) < 0 ? place(k, finer) : Optional.empty();
  }

  private Optional<Place> place(BigInteger k, int finer) {
    Optional<Double> px = exact(ax.shiftLeft(finer).add(k.multiply(ux)), unit - finer);
    Optional<Double> py = exact(ay.shiftLeft(finer).add(k.multiply(uy)), unit - finer);
    return px.flatMap(foundX -> py.map(foundY -> new Place(foundX, foundY)));
  }

  /** This multiple of a power of two, if a double can hold it. */
  private static Optional<Double> exact(BigInteger multiple, int power) {
    if (multiple.signum() == 0) {
      return Optional.of(0.0);
    }
    int zeros = multiple.getLowestSetBit();
    BigInteger digits = multiple.shiftRight(zeros);
    boolean fits = digits.bitLength() <= DIGITS && power + zeros >= LEAST_EXPONENT;
    return fits ? Optional.of(Math.scalb(digits.doubleValue(), power + zeros)) : Optional.empty();
  }

  /** The power of two that the last digit of doubles of this size stands for. */
  private static int lastPlace(double value) {
    return Math.max(Math.getExponent(value) - DIGITS + 1, LEAST_EXPONENT);
  }

  /** The power of two that the last digit of this double that is not zero stands for. */
  private static int lastBit(double value) {
    long digits = digits(value);
    return digits == 0
        ? Double.MAX_EXPONENT
        : lastPlace(value) + Long.numberOfTrailingZeros(digits);
  }

  private static long digits(double value) {
    long bits = Double.doubleToRawLongBits(value);
    long fraction = bits & 0xFFFFFFFFFFFFFL;
    return Math.getExponent(value) < Double.MIN_EXPONENT ? fraction : fraction | 0x10000000000000L;
  }

  private static BigInteger multiple(double value, int power) {
    BigInteger digits = BigInteger.valueOf(value < 0 ? -digits(value) : digits(value));
    return digits.signum() == 0 ? digits : shifted(digits, lastPlace(value) - power);
  }

  private static BigInteger shifted(BigInteger value, int by) {
    return by >= 0 ? value.shiftLeft(by) : value.shiftRight(-by);
  }

  /** All whole numbers that leave this remainder by a power of two. */
  private record Residue(BigInteger remainder, BigInteger modulus) {
    static final Residue ALL = new Residue(BigInteger.ZERO, BigInteger.ONE);
    static final Residue NONE = new Residue(BigInteger.ZERO, BigInteger.ZERO);

    /** The k for which a + k u is divisible by 2 to this power. */
    static Residue of(BigInteger a, BigInteger u, int power) {
      if (u.signum() == 0 || power <= 0) {
        return ALL; // the coordinate is that of both ends
      }
      int twos = Math.min(u.getLowestSetBit(), power);
      if (a.signum() != 0 && a.getLowestSetBit() < twos) {
        return NONE;
      }
      BigInteger modulus = BigInteger.ONE.shiftLeft(power - twos);
      if (power == twos) {
        return ALL;
      }
      BigInteger inverse = u.shiftRight(twos).modInverse(modulus);
      return new Residue(a.shiftRight(twos).negate().multiply(inverse).mod(modulus), modulus);
    }

    /** What is in both. */
    Residue and(Residue other) {
      if (equals(NONE) || other.equals(NONE)) {
        return NONE;
      }
      if (modulus.compareTo(other.modulus) < 0) {
        return other.and(this);
      }
      return remainder.mod(other.modulus).equals(other.remainder) ? this : NONE;
    }

    /** The number nearest to this one. */
    BigInteger nearest(BigDecimal value) {
      BigDecimal periods =
          value
              .subtract(new BigDecimal(remainder))
              .divide(new BigDecimal(modulus), MathContext.UNLIMITED);
      return periods
          .setScale(0, java.math.RoundingMode.HALF_EVEN)
          .toBigInteger()
          .multiply(modulus)
          .add(remainder);
    }
  }
}
