package dct.io;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.nio.charset.StandardCharsets;

/**
 * Decimal numbers in files: read correctly rounded, written as shortly as they can be read back.
 *
 * <p>The ordinary case, up to 15 digits, is one exact division or multiplication (Clinger, "How to
 * read floating point numbers accurately", 1990); the rest goes through the library. What is
 * written does not depend on the JDK.
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
  static double parse(byte[] text, int from, int to) {
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
    if (significant > 15 || fraction > 22) {
      return library(text, from, to);
    }
    double value = digits / POWER_OF_TEN[fraction];
    return negative ? -value : value;
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
    return Double.parseDouble(new String(text, from, to - from, StandardCharsets.US_ASCII));
  }

  /** {@link #parse(byte[], int, int)} of a string. */
  static double parse(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    return parse(bytes, 0, bytes.length);
  }

  /** The shortest decimal that is read back as this finite number; whole numbers have no point. */
  public static String format(double value) {
    StringBuilder text = new StringBuilder(24);
    append(text, value);
    return text.toString();
  }

  /** Appends {@link #format} of the value. */
  static void append(StringBuilder text, double value) {
    double size = Math.abs(value);
    if (value < 0) {
      text.append('-');
    }
    if (size < EXACT && size == (long) size) {
      text.append((long) size);
    } else if (!appendFraction(text, size)) {
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

  private static void appendPlaces(StringBuilder text, long scaled, int places) {
    long unit = (long) POWER_OF_TEN[places];
    text.append(scaled / unit).append('.');
    String behind = Long.toString(scaled % unit);
    text.append("0".repeat(places - behind.length())).append(behind);
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
