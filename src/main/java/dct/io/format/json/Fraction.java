package dct.io.format.json;

import dct.core.Decimals;
import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import java.util.regex.Pattern;

/**
 * A fraction of whole numbers as the double that equals it, or else the nearest one.
 *
 * @param value the double; infinite if the fraction is beyond the doubles
 * @param isExact whether it equals the fraction
 */
record Fraction(double value, boolean isExact) {
  private static final Pattern WHOLE = Pattern.compile("[-+]?[0-9]{1,1000}");
  private static final int EXACT = 15; // digits
  private static final MathContext DIGITS = new MathContext(800);

  /** Not a number, for what is no fraction. */
  private static final Fraction NONE = new Fraction(Double.NaN, false);

  /** The fraction or the decimal number that a text stands for; not a number for any other text. */
  static Fraction of(String text) {
    int slash = text.indexOf('/');
    return slash < 0
        ? new Fraction(Decimals.parse(text), true)
        : of(text.substring(0, slash).strip(), text.substring(slash + 1).strip());
  }

  /** The fraction of two numbers of at most a thousand digits; not a number for other texts. */
  static Fraction of(String numerator, String denominator) {
    if (!WHOLE.matcher(numerator).matches() || !WHOLE.matcher(denominator).matches()) {
      return NONE;
    }
    BigDecimal above = new BigDecimal(new BigInteger(numerator));
    BigDecimal below = new BigDecimal(new BigInteger(denominator));
    if (below.signum() == 0) {
      return NONE;
    }
    boolean isSmall = Math.max(numerator.length(), denominator.length()) <= EXACT;
    double value =
        isSmall // then both are doubles
            ? above.doubleValue() / below.doubleValue()
            : above.divide(below, DIGITS).doubleValue();
    boolean isExact =
        Double.isFinite(value) && new BigDecimal(value).multiply(below).compareTo(above) == 0;
    return new Fraction(value + 0.0, isExact);
  }
}
