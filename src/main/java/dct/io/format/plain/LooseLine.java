package dct.io.format.plain;

import dct.io.text.ByteLines;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A line of numbers as people and programs write them: in parentheses, brackets, braces or
 * quotation marks, parted by blanks of any kind, commas or semicolons, with look-alikes of the
 * minus sign, with the D of Fortran's exponents, with a comment of another language behind.
 *
 * <p>The line is scanned byte by byte. One object reads all lines of a text, so that a line of
 * ASCII makes no others.
 */
final class LooseLine {
  private static final Pattern LINE_END = Pattern.compile("[\u0085\u2028\u2029]");
  private static final Pattern MINUS =
      Pattern.compile("[\u2010-\u2013\u2212\uFE63\uFF0D](?=[0-9.])");
  private static final Pattern WIDE_BLANK =
      Pattern.compile("[\u00A0\u2000-\u200A\u202F\u205F\u3000]");
  private static final Pattern GROUPED =
      Pattern.compile("(?<![0-9])[0-9]{1,3}(" + WIDE_BLANK.pattern() + "[0-9]{3})+(?![0-9])");

  private byte[] text = {};
  private int from; // where the line starts, without blanks
  private int to; // where it ends, without blanks and comment
  private final NumberScan numbers = new NumberScan();

  /** Takes the present line of a text, which is UTF-8, without the comment behind it. */
  void take(ByteLines lines) {
    text = lines.bytes();
    from = lines.start();
    to = commentStart(lines.end());
    if (to < lines.end() && !isAscii(to, lines.end())) {
      behindComment(lines.end());
    }
    if (!isAscii(from, to)) {
      text = data().getBytes(StandardCharsets.UTF_8);
      from = 0;
      to = text.length;
    }
    strip();
  }

  /** A comment ends with its line, which a file of UTF-8 can end in other ways, too. */
  private void behindComment(int end) {
    String comment = new String(text, to, end - to, StandardCharsets.UTF_8);
    Matcher lineEnd = LINE_END.matcher(comment);
    if (lineEnd.find()) {
      String before = new String(text, from, to - from, StandardCharsets.UTF_8);
      text = (before + comment.substring(lineEnd.start())).getBytes(StandardCharsets.UTF_8);
      from = 0;
      to = text.length;
    }
  }

  /** Where a comment starts: with a semicolon at the front, or behind a blank with another mark. */
  private int commentStart(int end) {
    int first = from;
    while (first < end && ByteLines.isBlank(text[first])) {
      first++;
    }
    if (first < end && text[first] == ';') {
      return from;
    }
    for (int i = from; i < end; i++) {
      byte b = text[i];
      boolean isMark =
          b == '#' || b == '%' || b == '!' || (b == '/' && i + 1 < end && text[i + 1] == '/');
      if (isMark && (i == from || ByteLines.isBlank(text[i - 1]))) {
        return i;
      }
    }
    return end;
  }

  private void strip() {
    while (from < to && ByteLines.isBlank(text[from])) {
      from++;
    }
    while (from < to && ByteLines.isBlank(text[to - 1])) {
      to--;
    }
  }

  private boolean isAscii(int start, int end) {
    int i = start;
    while (i < end && text[i] >= 0) {
      i++;
    }
    return i == end;
  }

  /** Whether the line holds nothing but a comment. */
  boolean isEmpty() {
    return from == to;
  }

  /** The first byte of a line that is not empty. */
  byte first() {
    return text[from];
  }

  /** What the line holds without its comment. */
  String data() {
    return new String(text, from, to - from, StandardCharsets.UTF_8).strip();
  }

  /**
   * The rows of numbers, until the next line is taken: none if the line holds only brackets,
   * several if each stands in brackets of its own; nothing if it is no line of numbers.
   */
  Optional<NumberScan> rows() {
    if (isAscii(from, to)) {
      return numbers.read(text, from, to);
    }
    String data = data();
    if (GROUPED.matcher(data).find()) {
      return Optional.empty(); // one number or two
    }
    String plain = WIDE_BLANK.matcher(MINUS.matcher(data).replaceAll("-")).replaceAll(" ");
    byte[] ascii = new byte[plain.length()];
    for (int i = 0; i < ascii.length; i++) {
      char c = plain.charAt(i);
      byte other = Character.isWhitespace(c) ? NumberScan.OUTER_BLANK : NumberScan.NO_NUMBER;
      ascii[i] = c < 0x80 ? (byte) c : other;
    }
    return numbers.read(ascii, 0, ascii.length);
  }
}
