package dct.io.format.drawing;

import java.math.BigDecimal;

/**
 * A coordinate of a pen that is moved to a number or by one. Moves are added up as the decimals
 * that they are, so that a pen that comes back to where it was is there exactly.
 */
final class Coordinate {
  private static final int LONGEST = 400; // digits, or places behind the point, that are added up

  private double value;
  private BigDecimal exact = BigDecimal.ZERO;
  private String written = ""; // the number moved to; empty where exact holds

  double value() {
    return value;
  }

  /** Goes to where another one is. */
  void set(Coordinate other) {
    value = other.value;
    exact = other.exact;
    written = other.written;
  }

  /** Goes to a number. */
  void moveTo(double number, String decimal) {
    value = number;
    written = decimal;
  }

  /** Goes on by a number. */
  void moveBy(double number, String decimal) {
    exact = sum(written.isEmpty() ? exact : decimal(value, written), decimal(number, decimal));
    written = "";
    value = exact.doubleValue();
  }

  private static BigDecimal sum(BigDecimal one, BigDecimal other) {
    BigDecimal sum = one.add(other);
    return sum.precision() > 2 * LONGEST ? new BigDecimal(sum.doubleValue()) : sum;
  }

  /**
   * The decimal as it is written, unless it is so long that adding it up would take long, or so
   * small that it is no number but zero.
   */
  private static BigDecimal decimal(double number, String written) {
    if (number != 0 && written.length() <= LONGEST) {
      BigDecimal decimal = new BigDecimal(written);
      if (Math.abs(decimal.scale()) <= LONGEST) {
        return decimal;
      }
    }
    return new BigDecimal(number);
  }
}
