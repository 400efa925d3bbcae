package dct.io.format.drawing;

import dct.core.Decimals;

/**
 * The numbers in an attribute of SVG or Ipe, one after the other: parted by white space, at most
 * one comma, or nothing where sign or point tell that the next one starts.
 */
final class NumberText {
  private final String text;
  private final byte[] ascii;
  private int at;
  private int start; // of the last number

  NumberText(String text) {
    this.text = text;
    ascii = new byte[text.length()];
    for (int i = 0; i < ascii.length; i++) {
      char c = text.charAt(i);
      ascii[i] = c < 0x80 ? (byte) c : -1;
    }
  }

  /** Skips white space. */
  void skipSpace() {
    while (at < ascii.length
        && (ascii[at] == ' ' || ascii[at] == '\t' || ascii[at] == '\n' || ascii[at] == '\r')) {
      at++;
    }
  }

  /** Skips white space and at most one comma in it. */
  void skipComma() {
    skipSpace();
    if (at < ascii.length && ascii[at] == ',') {
      at++;
      skipSpace();
    }
  }

  boolean isAtEnd() {
    return at == ascii.length;
  }

  /** The character here, 0 at the end. */
  char peek() {
    return isAtEnd() ? 0 : text.charAt(at);
  }

  /** Goes behind the character here. */
  void advance() {
    at++;
  }

  /** Whether a number starts here. */
  boolean isAtNumber() {
    char c = peek();
    return isDigit(at) || c == '-' || c == '+' || c == '.';
  }

  /** Goes behind the number here and gives it: NaN if it is none. */
  double number() {
    start = at;
    int i = at;
    if (i < ascii.length && (ascii[i] == '-' || ascii[i] == '+')) {
      i++;
    }
    i = behindDigits(i);
    if (i < ascii.length && ascii[i] == '.') {
      i = behindDigits(i + 1);
    }
    i = behindExponent(i);
    double value = Decimals.parse(ascii, start, i);
    at = Double.isNaN(value) ? start : i;
    return value;
  }

  private int behindExponent(int from) {
    if (from == ascii.length || (ascii[from] | 0x20) != 'e') {
      return from;
    }
    int i = from + 1;
    if (i < ascii.length && (ascii[i] == '-' || ascii[i] == '+')) {
      i++;
    }
    return isDigit(i) ? behindDigits(i) : from;
  }

  private int behindDigits(int from) {
    int i = from;
    while (isDigit(i)) {
      i++;
    }
    return i;
  }

  private boolean isDigit(int i) {
    return i < ascii.length && ascii[i] >= '0' && ascii[i] <= '9';
  }

  /** The last number as it is written. */
  String written() {
    return text.substring(start, at);
  }

  private static boolean isWord(byte b) {
    return b == -1 || (b > ' ' && b != ',' && b != ')');
  }

  /** What stands here up to the next white space or comma. */
  String word() {
    int end = at;
    while (end < ascii.length && isWord(ascii[end])) {
      end++;
    }
    return text.substring(at, Math.max(end, Math.min(at + 1, text.length())));
  }

  /** A length in user units, which px are; 0 if it is empty, NaN if it is in another unit. */
  static double length(String value) {
    String number = value.strip();
    String plain = number.endsWith("px") ? number.substring(0, number.length() - 2) : number;
    return plain.isEmpty() ? 0 : Decimals.parse(plain);
  }
}
