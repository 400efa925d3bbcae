package dct.core;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/**
 * Decimal numbers, the one way in which they are read and printed: read correctly rounded, written
 * as shortly as they can be read back.
 *
 * <p>Up to 15 digits are one exact division (Clinger, "How to read floating point numbers
 * accurately", 1990). Up to 18 digits are a division whose remainder is known and which is rounded
 * twice, from just below and just above the truth: where both agree, they are right. The rest goes
 * through the library. What is written does not depend on the JDK.
 */
public final class Decimals {
  private static final double[] POWER_OF_TEN = {
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22
  };
  private static final long EXACT = 1L << 53; // whole numbers up to here are doubles
  private static final double PLAIN_FROM = 1e-7;
  private static final double PLAIN_TO = 1e21;

  private Decimals() {}

  /**
   * The number written in {@code text[from … to)}: sign, digits with at most one point, exponent.
   *
   * @return NaN if it is not a number of this form; infinite if it is beyond the doubles
   */
  public static double parse(byte[] text, int from, int to) {
    int i = from;
    boolean negative = i < to && text[i] == '-';
    if (negative || (i < to && text[i] == '+')) {
      i++;
    }
    // A hot loop over the bytes of the file, hence not cut into smaller methods.
    long digits = 0;
    int significant = 0; // digits in the mantissa, leading zeros left out
    int point = -1;
    int first = i;
    for (; i < to; i++) {
      int digit = text[i] - '0';
      if (digit >= 0 && digit <= 9) {
        digits = 10 * digits + digit;
        significant += significant > 0 || digit > 0 ? 1 : 0;
      } else if (text[i] == '.' && point < 0) {
        point = i;
      } else {
        break;
      }
    }
    int fraction = point < 0 ? 0 : i - point - 1;
    if (i - first == (point < 0 ? 0 : 1)) {
      return Double.NaN; // not one digit
    }
    if (i < to) {
      return isExponent(text, i, to) ? library(text, from, to) : Double.NaN;
    }
    double value = significant <= 18 && fraction <= 22 ? quotient(digits, fraction) : Double.NaN;
    if (Double.isNaN(value)) {
      return library(text, from, to);
    }
    return negative ? -value : value;
  }

  /**
   * The double nearest to {@code digits / 10^places}, or NaN where it is too close to call.
   *
   * @param digits at most 10^18
   * @param places at most 22
   */
  private static double quotient(long digits, int places) {
    double power = POWER_OF_TEN[places];
    double high = digits;
    if (Math.abs(digits) < EXACT) {
      return high / power;
    }
    double low = digits - (long) high;
    double quotient = high / power;
    double remainder = Math.fma(-quotient, power, high); // exact
    double correction = (remainder + low) / power; // off by less than 2^-51 of itself
    double below = quotient + correction * (1 - 0x1p-48);
    double above = quotient + correction * (1 + 0x1p-48);
    return below == above ? below : Double.NaN;
  }

  private static boolean isExponent(byte[] text, int from, int to) {
    int i = from + 1;
    if ((text[from] | 0x20) != 'e') {
      return false;
    }
    if (i < to && (text[i] == '-' || text[i] == '+')) {
      i++;
    }
    int first = i;
    while (i < to && text[i] >= '0' && text[i] <= '9') {
      i++;
    }
    return i == to && i > first;
  }

  private static double library(byte[] text, int from, int to) {
    StringBuilder ascii = new StringBuilder(to - from);
    for (int i = from; i < to; i++) {
      ascii.append((char) text[i]);
    }
    return Double.parseDouble(ascii.toString());
  }

  /** {@link #parse(byte[], int, int)} of a string. */
  public static double parse(String text) {
    byte[] bytes = new byte[text.length()];
    for (int i = 0; i < bytes.length; i++) {
      char c = text.charAt(i);
      bytes[i] = c < 0x80 ? (byte) c : -1; // no number has a character beyond ASCII
    }
    return parse(bytes, 0, bytes.length);
  }

  /**
   * The shortest decimal that is read back as this number; whole numbers have no point. The same on
   * every JDK.
   */
  public static String format(double value) {
    StringBuilder text = new StringBuilder(24);
    append(text, value);
    return text.toString();
  }

  /**
   * The number rounded to at most two places, half to even, without exponent: as pictures that are
   * text need it.
   */
  public static String rounded(double value) {
    BigDecimal rounded = new BigDecimal(format(value)).setScale(2, RoundingMode.HALF_EVEN);
    return rounded.stripTrailingZeros().toPlainString();
  }

  /** Appends {@link #format} of the value. */
  public static void append(StringBuilder text, double value) {
    if (!Double.isFinite(value)) {
      text.append(value);
      return;
    }
    double size = Math.abs(value);
    if (value < 0) {
      text.append('-');
    }
    if (size < EXACT && size == (long) size) {
      text.append((long) size);
    } else if (!appendFraction(text, size) && !appendScaled(text, size)) {
      appendLong(text, size);
    }
  }

  /** A number of at most 15 digits is a whole number over a power of ten. */
  private static boolean appendFraction(StringBuilder text, double size) {
    for (int places = 1; places <= 15; places++) {
      double scaled = Math.rint(size * POWER_OF_TEN[places]);
      if (scaled >= 1e15) {
        return false;
      }
      if (scaled / POWER_OF_TEN[places] == size && size >= PLAIN_FROM) {
        appendPlaces(text, (long) scaled, places);
        return true;
      }
    }
    return false;
  }

  /** A number of 15 to 17 digits is scaled to a whole number; false where that is uncertain. */
  private static boolean appendScaled(StringBuilder text, double size) {
    if (size < 1e-5 || size >= EXACT) {
      return false;
    }
    int exponent = (int) Math.floor(StrictMath.log10(size));
    for (int places = 14 - exponent; places <= 16 - exponent; places++) {
      long scaled = nearest(size, Math.max(places, 0));
      if (quotient(scaled, Math.max(places, 0)) == size) {
        appendPlaces(text, scaled, Math.max(places, 0));
        return true;
      }
    }
    return false;
  }

  /** The whole number nearest to {@code size * 10^places}. */
  private static long nearest(double size, int places) {
    double product = size * POWER_OF_TEN[places];
    double error = Math.fma(size, POWER_OF_TEN[places], -product); // exact
    double whole = Math.rint(product);
    return (long) whole + (long) Math.rint(product - whole + error);
  }

  private static void appendPlaces(StringBuilder text, long scaled, int places) {
    long digits = scaled;
    int behind = places;
    while (digits % 10 == 0 && behind > 1) {
      digits /= 10;
      behind--;
    }
    int start = text.length();
    text.append(digits);
    int missing = behind + 1 - (text.length() - start); // of a zero before the point and after it
    if (missing > 0) {
      text.insert(start, "0".repeat(missing));
    }
    text.insert(text.length() - behind, '.');
  }

  private static void appendLong(StringBuilder text, double size) {
    BigDecimal exact = new BigDecimal(size);
    BigDecimal shortest = exact;
    // Any number of up to 15 digits is found at 15; only below the normal doubles are fewer needed.
    for (int digits = size < Double.MIN_NORMAL ? 1 : 15; digits <= 17; digits++) {
      shortest = exact.round(new MathContext(digits, RoundingMode.HALF_EVEN));
      if (shortest.doubleValue() == size) {
        break;
      }
    }
    appendDigits(text, shortest.stripTrailingZeros(), size);
  }

  private static void appendDigits(StringBuilder text, BigDecimal number, double size) {
    if (size >= PLAIN_FROM && size < PLAIN_TO) {
      text.append(number.toPlainString());
      return;
    }
    String digits = number.unscaledValue().toString();
    text.append(digits.charAt(0));
    if (digits.length() > 1) {
      text.append('.').append(digits, 1, digits.length());
    }
    text.append('e').append(digits.length() - 1 - number.scale());
  }
}
