package dct.io.format.plain;

import dct.core.Decimals;
import dct.io.text.BadInputException;
import dct.io.text.ByteLines;
import dct.io.text.Shown;
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
public final class LineFault {
  private static final String FORM = "write one vertex a line, as two numbers x y";
  private static final Pattern DECIMAL_COMMA =
      Pattern.compile("[+-]?[0-9][0-9.]*,[0-9]+([eE][+-]?[0-9]+)?");
  private static final Pattern HEXADECIMAL = Pattern.compile("[+-]?0[xX].*");
  private static final Pattern INFINITE = Pattern.compile("[+-]?(inf|infinity|∞)");
  private static final Pattern NOT_A_NUMBER = Pattern.compile("[+-]?nan");
  private static final String BINARY =
      "this is a binary file, not text; choose a file with two numbers x y a line";
  private static final byte END_OF_DOS = 0x1A;
  private static final Pattern COMMENT = Pattern.compile("(?:^|(?<=[\\s,;]))#");
  private static final Pattern THOUSANDS =
      Pattern.compile("[+-]?[0-9]{1,3}(,[0-9]{3})+(\\.[0-9]*)?([eE][+-]?[0-9]+)?");
  private static final Pattern MICROSOFT =
      Pattern.compile("[+-]?[0-9]+\\.#(inf|ind|[qs]nan)[0-9]*");
  private static final String MINUS_LIKE = "\u2010\u2011\u2012\u2013\u2014\u2212\uFE63\uFF0D";

  private static final Pattern FIXED = Pattern.compile("^fixed\\b");
  private static final Pattern NEARLY =
      Pattern.compile("(?i)(?:holes?|inner|interior|sites?|steiner points?|fix|fixed)\\b.*");

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
    return ForeignText.fault(data)
        .or(() -> regionWord(data))
        .map(this::fault)
        .or(() -> decimalComma(data))
        .or(() -> words(data).map(this::wrongWord).flatMap(Optional::stream).findFirst())
        .orElseGet(() -> wrongCount(data));
  }

  /** What is wrong with a word of a region, or with one that looks like it was to be one. */
  private static Optional<String> regionWord(String data) {
    if (FIXED.matcher(data).find()) {
      return Optional.of(
          "\"fixed\" stands without the numbers of two vertices behind it; write fixed i j");
    }
    return NEARLY.matcher(data).matches()
        ? Optional.of(
            "\"" + Shown.word(data) + "\" is no word of a region; write hole, sites or fixed i j")
        : Optional.empty();
  }

  /** Throws if the line is no text in UTF-8. */
  void throwIfNotText() {
    if (isPlain()) {
      return;
    }
    wideEncoding()
        .ifPresent(
            encoding -> {
              throw fault("the text is encoded in " + encoding + "; save it as UTF-8");
            });
    if (hasControls(lines.end())) {
      throw controls();
    }
    try {
      StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(line));
    } catch (CharacterCodingException e) {
      if (hasControls(lines.ahead())) {
        throw fault(BINARY);
      }
      if (!lines.isCut()) { // a character may be cut in two
        throw fault(
            String.format(
                Locale.ROOT,
                "byte 0x%02X is not UTF-8, the text may be Latin-1; save it as UTF-8",
                firstNonAscii()));
      }
    }
  }

  /** Whether the line is ASCII without control characters. */
  private boolean isPlain() {
    int i = 0;
    while (i < line.length && (line[i] >= ' ' || ByteLines.isBlank(line[i]))) {
      i++;
    }
    return i == line.length;
  }

  /** UTF-32 or UTF-16, by the mark at the front or by the zeros between the first characters. */
  private Optional<String> wideEncoding() {
    if (lines.number() > 1 || line.length < 2) {
      return Optional.empty();
    }
    int pair = at(0) << 8 | at(1);
    int next = at(2) << 8 | at(3);
    boolean isLittle = pair == 0xFFFE || (at(1) == 0 && at(0) >= ' ');
    boolean isBig = pair == 0xFEFF || (at(0) == 0 && at(1) >= ' ');
    if ((isLittle && next == 0 && line.length > 3)
        || (pair == 0 && (next == 0xFEFF || isText(next)))) {
      return Optional.of("UTF-32");
    }
    return isLittle || isBig ? Optional.of("UTF-16") : Optional.empty();
  }

  private static boolean isText(int c) {
    return c >= ' ' && c < 0x7F;
  }

  private int at(int i) {
    return i < line.length ? line[i] & 0xFF : 0;
  }

  /** Whether there are control characters in the bytes up to this one; no text has them. */
  private boolean hasControls(int to) {
    for (int i = lines.start(); i < to; i++) {
      byte b = lines.bytes()[i];
      if (b >= 0 && b < ' ' && b != '\n' && b != '\r' && !ByteLines.isBlank(b)) {
        return true;
      }
    }
    return false;
  }

  private BadInputException controls() {
    boolean isRemainder = lines.number() > 1;
    if (isRemainder && line.length == 1 && line[0] == END_OF_DOS) {
      return fault("the line holds Ctrl-Z, with which DOS ended files; remove it");
    }
    if (isRemainder && new String(line, StandardCharsets.US_ASCII).matches("\0+")) {
      return fault(
          "here are only zero bytes, the rest of the file may be lost; restore or remove them");
    }
    return fault(BINARY);
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
    Matcher comment = COMMENT.matcher(text);
    return (comment.find() ? text.substring(0, comment.start()) : text).strip();
  }

  private Optional<BadInputException> decimalComma(String data) {
    List<String> numbers = List.of(data.split("[\\s;]+"));
    if (numbers.size() != 2 || !numbers.stream().allMatch(LineFault::isNumberOrComma)) {
      return Optional.empty();
    }
    List<String> commas = numbers.stream().filter(number -> number.indexOf(',') >= 0).toList();
    boolean mayGroup = commas.stream().allMatch(number -> THOUSANDS.matcher(number).matches());
    return commas.stream().findFirst().map(number -> mayGroup ? grouped(number) : comma(number));
  }

  private BadInputException comma(String number) {
    return fault(
        String.format(
            Locale.ROOT,
            "%s is written with a decimal comma; write it with a point, %s",
            Shown.word(number),
            Shown.word(number.replace(".", "").replace(',', '.'))));
  }

  private BadInputException grouped(String number) {
    String whole = number.replace(",", "");
    boolean certain = number.indexOf(',') < number.lastIndexOf(',') || number.indexOf('.') >= 0;
    return fault(
        certain
            ? Shown.word(number) + " has commas between thousands; write it as " + Shown.word(whole)
            : String.format(
                Locale.ROOT,
                "%s can mean %s or %s; write which, without a comma",
                Shown.word(number),
                Shown.word(whole),
                Shown.word(number.replace(',', '.'))));
  }

  private static boolean isNumberOrComma(String word) {
    return DECIMAL_COMMA.matcher(word).matches()
        || THOUSANDS.matcher(word).matches()
        || Double.isFinite(Decimals.parse(word));
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
          fault(
              Shown.word(word)
                  + " is too large, a coordinate is at most 1.797e308; scale the data"));
    }
    if (NOT_A_NUMBER.matcher(lower).matches()
        || INFINITE.matcher(lower).matches()
        || MICROSOFT.matcher(lower).matches()) {
      return Optional.of(
          fault(
              Shown.word(word)
                  + " is not a finite number; remove the line or correct the coordinate"));
    }
    if (HEXADECIMAL.matcher(word).matches()) {
      return Optional.of(fault(Shown.word(word) + " is hexadecimal; write the number in decimal"));
    }
    return Optional.of(
        fault(
            "\""
                + Shown.word(word)
                + "\" is not a number"
                + lookAlike(word)
                    .orElse(
                        (word.indexOf('#') > 0 ? "; leave a blank before #, or " : "; ") + FORM)));
  }

  /** What is to be told of a character that is not what it looks like, or cannot be seen. */
  private static Optional<String> lookAlike(String word) {
    return word.codePoints()
        .filter(c -> c > 0x7F && !Character.isLetter(c))
        .mapToObj(c -> ", it has " + Shown.named(c) + "; " + cure(c))
        .findFirst();
  }

  private static String cure(int c) {
    if (MINUS_LIKE.indexOf(c) >= 0) {
      return "write - instead";
    }
    return switch (Character.getType(c)) {
      case Character.SPACE_SEPARATOR -> "write a plain blank instead, or nothing within a number";
      case Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR, Character.CONTROL ->
          "write a plain line break instead";
      default -> "remove it";
    };
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

  private BadInputException fault(String fault) {
    return new BadInputException(name, lines.number(), fault);
  }
}
