package dct.render;

import java.math.BigDecimal;
import java.math.RoundingMode;

/** Numbers in pictures that are text: two places, a point whatever the locale, no exponent. */
final class PenNumbers {
  private PenNumbers() {}

  static String of(double value) {
    BigDecimal rounded = BigDecimal.valueOf(value).setScale(2, RoundingMode.HALF_EVEN);
    return rounded.stripTrailingZeros().toPlainString();
  }
}
