package dct.io.format.plain;

import dct.core.Decimals;
import dct.io.text.ByteLines;
import java.util.Arrays;
import java.util.Optional;

/**
 * The rows of numbers in a line of ASCII, scanned byte by byte. It is used again for each line, so
 * that lines make no objects. Linear.
 */
final class NumberScan {
  /** Stands for white space that may be round numbers, but does not part them. */
  static final byte OUTER_BLANK = 0x1C;

  /** Stands for a character that is no part of a number. */
  static final byte NO_NUMBER = -1;

  private byte[] text = {};
  private double[] values = new double[16];
  private boolean[] whole = new boolean[16];
  private int count; // of all numbers
  private int[] ends = new int[4]; // the count behind each row
  private int rows;

  /**
   * Reads the rows of a line: one, or each that stands in brackets of its own.
   *
   * @return this, until the next line is read; nothing if it is no line of numbers
   */
  Optional<NumberScan> read(byte[] line, int from, int to) {
    text = line;
    count = 0;
    rows = 0;
    int end = to;
    int start = from;
    if (has(from, to, '"') || has(from, to, '\'')) {
      text = new byte[to - from];
      end = unquote(line, from, to);
      start = 0;
    }
    boolean areNumbers = nextBracket(start, end) < end ? brackets(start, end) : row(start, end);
    return areNumbers ? Optional.of(this) : Optional.empty();
  }

  /** How many rows there are. */
  int rows() {
    return rows;
  }

  /** How many numbers a row has. */
  int size(int row) {
    return ends[row] - start(row);
  }

  /** A number. */
  double value(int row, int i) {
    return values[start(row) + i];
  }

  /** Whether a number is written in digits alone. */
  boolean isWhole(int row, int i) {
    return whole[start(row) + i];
  }

  private int start(int row) {
    return row == 0 ? 0 : ends[row - 1];
  }

  private boolean has(int from, int to, char c) {
    int i = from;
    while (i < to && text[i] != c) {
      i++;
    }
    return i < to;
  }

  /** Copies a line without quotation marks that stand in pairs; returns the length of the copy. */
  private int unquote(byte[] line, int from, int to) {
    int length = 0;
    int i = from;
    while (i < to) {
      int close = line[i] == '"' || line[i] == '\'' ? i + 1 : to;
      while (close < to && line[close] != line[i]) {
        close++;
      }
      if (close < to) {
        System.arraycopy(line, i + 1, text, length, close - i - 1);
        length += close - i - 1;
        i = close + 1;
      } else {
        text[length++] = line[i++];
      }
    }
    return length;
  }

  private static boolean isOpening(byte b) {
    return b == '(' || b == '[' || b == '{';
  }

  private static boolean isClosing(byte b) {
    return b == ')' || b == ']' || b == '}';
  }

  private int nextBracket(int from, int to) {
    int i = from;
    while (i < to && !isOpening(text[i]) && !isClosing(text[i])) {
      i++;
    }
    return i;
  }

  /** Reads what stands in innermost brackets; outside there may be brackets and separators. */
  private boolean brackets(int from, int to) {
    int i = from;
    while (i < to) {
      if (isOpening(text[i])) {
        int next = nextBracket(i + 1, to);
        if (next < to && isClosing(text[next])) {
          if (!row(i + 1, next)) {
            return false;
          }
          i = next;
        }
      } else if (!isClosing(text[i]) && !isSeparator(text[i])) {
        return false;
      }
      i++;
    }
    return true;
  }

  private static boolean isSeparator(byte b) {
    return ByteLines.isBlank(b) || b == ',' || b == ';';
  }

  private boolean row(int from, int to) {
    if (hasGluedComma(from, to) && isApart(from, to)) {
      return false; // the commas can be decimal ones, or stand between thousands
    }
    int i = from;
    int end = to;
    while (i < end && isWhite(text[i])) {
      i++;
    }
    while (end > i && isWhite(text[end - 1])) {
      end--;
    }
    if (end > i && (text[end - 1] == ',' || text[end - 1] == ';')) {
      end = blanksBefore(i, end - 1);
    }
    while (true) {
      int wordEnd = i;
      while (wordEnd < end && !isSeparator(text[wordEnd])) {
        wordEnd++;
      }
      if (!number(i, wordEnd)) {
        return false;
      }
      if (wordEnd == end) {
        return endRow();
      }
      i = skipSeparator(wordEnd, end);
    }
  }

  private static boolean isWhite(byte b) {
    return ByteLines.isBlank(b) || b == OUTER_BLANK;
  }

  /** Where the white space before a place starts. */
  private int blanksBefore(int from, int place) {
    int i = place;
    while (i > from && isWhite(text[i - 1])) {
      i--;
    }
    return i;
  }

  private int skipBlanks(int from, int to) {
    int i = from;
    while (i < to && ByteLines.isBlank(text[i])) {
      i++;
    }
    return i;
  }

  private int skipSeparator(int from, int to) {
    int i = skipBlanks(from, to);
    return i < to && (text[i] == ',' || text[i] == ';') ? skipBlanks(i + 1, to) : i;
  }

  /** Whether a comma stands between two digits. */
  private boolean hasGluedComma(int from, int to) {
    for (int i = from + 1; i < to - 1; i++) {
      if (text[i] == ',' && isDigit(text[i - 1]) && isDigit(text[i + 1])) {
        return true;
      }
    }
    return false;
  }

  /** Whether blanks or a semicolon stand between two numbers. */
  private boolean isApart(int from, int to) {
    for (int i = from; i < to; i++) {
      if (isDigit(text[i]) || text[i] == '.') {
        int next = skipBlanks(i + 1, to);
        boolean parted = next > i + 1;
        if (next < to && text[next] == ';') {
          next = skipBlanks(next + 1, to);
          parted = true;
        }
        if (parted && next < to && startsNumber(text[next])) {
          return true;
        }
      }
    }
    return false;
  }

  private static boolean isDigit(byte b) {
    return b >= '0' && b <= '9';
  }

  private static boolean startsNumber(byte b) {
    return isDigit(b) || b == '.' || b == '-' || b == '+';
  }

  private boolean number(int from, int to) {
    double value = Decimals.parse(text, from, to);
    if (!Double.isFinite(value)) {
      value = fortran(from, to);
    }
    if (!Double.isFinite(value)) {
      return false;
    }
    if (count == values.length) {
      values = Arrays.copyOf(values, Math.multiplyExact(2, count));
      whole = Arrays.copyOf(whole, values.length);
    }
    int i = from;
    while (i < to && isDigit(text[i])) {
      i++;
    }
    whole[count] = i == to;
    values[count++] = value;
    return true;
  }

  /** A number whose exponent stands behind D. */
  private double fortran(int from, int to) {
    byte[] word = Arrays.copyOfRange(text, from, to);
    int i = 0;
    while (i < word.length && (word[i] | 0x20) != 'd') {
      i++;
    }
    if (i == word.length) {
      return Double.NaN;
    }
    word[i] = 'e';
    return Decimals.parse(word, 0, word.length);
  }

  private boolean endRow() {
    if (rows == ends.length) {
      ends = Arrays.copyOf(ends, Math.multiplyExact(2, rows));
    }
    ends[rows++] = count;
    return true;
  }
}
