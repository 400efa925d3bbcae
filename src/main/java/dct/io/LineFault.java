package dct.io;

import dct.core.Decimals;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Finds out what is wrong in a line of text that is not a vertex, and what would mend it. */
final class LineFault {
  private static final String FORM = "write one vertex a line, as two numbers x y";
  private static final Pattern DECIMAL_COMMA =
      Pattern.compile("[+-]?[0-9][0-9.]*,[0-9]+([eE][+-]?[0-9]+)?");
  private static final Pattern HEXADECIMAL = Pattern.compile("[+-]?0[xX].*");
  private static final Pattern INFINITE = Pattern.compile("[+-]?(inf|infinity|∞)");
  private static final Pattern NOT_A_NUMBER = Pattern.compile("[+-]?nan");
  private static final int SHOWN = 40; // characters of a wrong word that a message repeats

  private final String name;
  private final ByteLines lines;
  private final byte[] line;

  LineFault(String name, ByteLines lines) {
    this.name = name;
    this.lines = lines;
    this.line = Arrays.copyOfRange(lines.bytes(), lines.start(), lines.end());
  }

  /** The exception for this line, which is not a vertex. */
  BadInputException exception() {
    throwIfNotText();
    if (lines.isCut()) {
      return fault("the line is longer than " + ByteLines.LONGEST + " bytes; " + FORM);
    }
    String data = data();
    return decimalComma(data)
        .or(() -> words(data).map(this::wrongWord).flatMap(Optional::stream).findFirst())
        .orElseGet(() -> wrongCount(data));
  }

  /** Throws if the line is no text in UTF-8. */
  void throwIfNotText() {
    if (isUtf16()) {
      throw fault("the text is encoded in UTF-16; save it as UTF-8");
    }
    if (isBinary()) {
      throw fault("this is a binary file, not text; choose a file with two numbers x y a line");
    }
    try {
      StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(line));
    } catch (CharacterCodingException e) {
      if (!lines.isCut()) { // a character may be cut in two
        throw fault(
            String.format(
                Locale.ROOT,
                "byte 0x%02X is not UTF-8, the text may be Latin-1; save it as UTF-8",
                firstNonAscii()));
      }
    }
  }

  private boolean isUtf16() {
    return lines.number() == 1
        && line.length >= 2
        && ((line[0] == (byte) 0xFF && line[1] == (byte) 0xFE)
            || (line[0] == (byte) 0xFE && line[1] == (byte) 0xFF));
  }

  /** Control characters here, or in what was read ahead, are found in no text. */
  private boolean isBinary() {
    for (int i = lines.start(); i < lines.ahead(); i++) {
      byte b = lines.bytes()[i];
      if (b >= 0 && b < ' ' && b != '\n' && b != '\r' && !VertexText.isBlank(b)) {
        return true;
      }
    }
    return false;
  }

  private int firstNonAscii() {
    int i = 0;
    while (line[i] >= 0) {
      i++;
    }
    return line[i] & 0xFF;
  }

  private String data() {
    String text = new String(line, StandardCharsets.UTF_8);
    int comment = text.indexOf('#');
    return (comment < 0 ? text : text.substring(0, comment)).strip();
  }

  private Optional<BadInputException> decimalComma(String data) {
    List<String> numbers = List.of(data.split("[\\s;]+"));
    if (numbers.size() != 2 || !numbers.stream().allMatch(LineFault::isNumberOrComma)) {
      return Optional.empty();
    }
    return numbers.stream().filter(number -> number.indexOf(',') >= 0).findFirst().map(this::comma);
  }

  private BadInputException comma(String number) {
    return fault(
        String.format(
            Locale.ROOT,
            "%s is written with a decimal comma; write it with a point, %s",
            shown(number),
            shown(number.replace(".", "").replace(',', '.'))));
  }

  private static boolean isNumberOrComma(String word) {
    return DECIMAL_COMMA.matcher(word).matches() || Double.isFinite(Decimals.parse(word));
  }

  private static Stream<String> words(String data) {
    return Stream.of(data.split("[\\s,;]+")).filter(word -> !word.isEmpty());
  }

  private Optional<BadInputException> wrongWord(String word) {
    double value = Decimals.parse(word);
    if (Double.isFinite(value)) {
      return Optional.empty();
    }
    String lower = word.toLowerCase(Locale.ROOT);
    if (Double.isInfinite(value)) {
      return Optional.of(
          fault(shown(word) + " is too large, a coordinate is at most 1.797e308; scale the data"));
    }
    if (NOT_A_NUMBER.matcher(lower).matches() || INFINITE.matcher(lower).matches()) {
      return Optional.of(
          fault(
              shown(word) + " is not a finite number; remove the line or correct the coordinate"));
    }
    Matcher hexadecimal = HEXADECIMAL.matcher(word);
    return Optional.of(
        fault(
            hexadecimal.matches()
                ? shown(word) + " is hexadecimal; write the number in decimal"
                : "\"" + shown(word) + "\" is not a number; " + FORM));
  }

  private BadInputException wrongCount(String data) {
    long count = words(data).count();
    if (count == 1) {
      return fault("there is only one number; " + FORM);
    }
    return count > 2
        ? fault(String.format(Locale.ROOT, "there are %d numbers; %s", count, FORM))
        : fault("a number is missing beside a comma or semicolon; " + FORM);
  }

  /** A word of the file as a message repeats it. */
  static String shown(String word) {
    return word.length() <= SHOWN ? word : word.substring(0, SHOWN) + "…";
  }

  private BadInputException fault(String fault) {
    return new BadInputException(name, lines.number(), fault);
  }
}
