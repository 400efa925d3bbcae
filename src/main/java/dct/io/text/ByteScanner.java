package dct.io.text;

import dct.core.Decimals;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * The bytes of a text one after the other, with the line that they stand on; for formats whose
 * parts may stand on any line. Words and numbers make no object for each byte.
 */
public final class ByteScanner {
  /** What {@link #peek} gives behind the last byte. */
  public static final int END = -1;

  private static final int LONGEST_WORD = 1 << 10;

  private final String name;
  private final InputStream in;
  private final byte[] buffer = new byte[1 << 16];
  private final byte[] word = new byte[LONGEST_WORD];
  private int next;
  private int filled;
  private int line = 1;
  private int wordLength;

  /** The bytes of a text that messages call by this name. */
  public ByteScanner(String name, InputStream in) {
    this.name = name;
    this.in = in;
  }

  /** The line of the byte that comes next, from 1 on. */
  public int line() {
    return line;
  }

  /** The byte that comes next, or {@link #END}. */
  public int peek() throws IOException {
    if (next == filled) {
      filled = Math.max(0, in.read(buffer, 0, buffer.length));
      next = 0;
      if (filled == 0) {
        return END;
      }
    }
    return buffer[next];
  }

  /** Takes the next byte; gives it, or {@link #END}. */
  public int take() throws IOException {
    int b = peek();
    if (b != END) {
      next++;
      line += b == '\n' ? 1 : 0;
    }
    return b;
  }

  /** Skips white space; gives what comes next. */
  public int skipBlanks() throws IOException {
    while (peek() == ' ' || (peek() >= '\t' && peek() <= '\r')) {
      take();
    }
    return peek();
  }

  /** Skips white space and one byte, if it is this one; says whether it was. */
  public boolean skip(char wanted) throws IOException {
    if (skipBlanks() != wanted) {
      return false;
    }
    take();
    return true;
  }

  /** Skips the rest of the line. */
  public void skipLine() throws IOException {
    while (peek() != '\n' && peek() != END) {
      take();
    }
  }

  /** Takes letters, digits and underscores; gives them in capitals, empty if there are none. */
  public String word() throws IOException {
    wordLength = 0;
    skipBlanks();
    while (isWordByte(peek()) && wordLength < LONGEST_WORD) {
      word[wordLength++] = (byte) take();
    }
    return new String(word, 0, wordLength, StandardCharsets.US_ASCII).toUpperCase(Locale.ROOT);
  }

  private static boolean isWordByte(int b) {
    return (b >= 'a' && b <= 'z') || (b >= 'A' && b <= 'Z') || (b >= '0' && b <= '9') || b == '_';
  }

  /** Whether a number may begin here, behind white space. */
  public boolean isNumberNext() throws IOException {
    int b = skipBlanks();
    return (b >= '0' && b <= '9') || b == '-' || b == '+' || b == '.';
  }

  /**
   * Takes a finite number.
   *
   * @param instead what a fault tells to do, as {@code write x y}
   * @throws BadInputException if there is none
   */
  public double number(String instead) throws IOException {
    skipBlanks();
    wordLength = 0;
    while (isNumberByte(peek()) && wordLength < LONGEST_WORD) {
      word[wordLength++] = (byte) take();
    }
    double value = Decimals.parse(word, 0, wordLength);
    if (!Double.isFinite(value)) {
      throw noNumber(value, instead);
    }
    return value;
  }

  private static boolean isNumberByte(int b) {
    return (b >= '0' && b <= '9')
        || b == '.'
        || b == '-'
        || b == '+'
        || (b >= 'a' && b <= 'z')
        || (b >= 'A' && b <= 'Z');
  }

  private BadInputException noNumber(double value, String instead) throws IOException {
    String read = new String(word, 0, wordLength, StandardCharsets.US_ASCII);
    if (Double.isInfinite(value)) {
      return fault(
          Shown.word(read) + " is too large, a coordinate is at most 1.797e308; scale the data");
    }
    return fault(
        (read.isEmpty() ? found() : "\"" + Shown.word(read) + "\"")
            + " is not a number; "
            + instead);
  }

  /** What stands here, for a message: a byte in quotation marks, or the end of the file. */
  public String found() throws IOException {
    int b = peek();
    return b == END
        ? "the end of the file"
        : "\"" + Shown.harmless(String.valueOf((char) (b & 0xFF))) + "\"";
  }

  /** An exception for the present line. */
  public BadInputException fault(String fault) {
    return new BadInputException(name, line, fault);
  }
}
