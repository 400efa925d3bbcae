package dct.io.format.plain;

import dct.core.Decimals;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A line of numbers as people and programs write them: in parentheses, brackets, braces or
 * quotation marks, parted by blanks of any kind, commas or semicolons, with look-alikes of the
 * minus sign, with the D of Fortran's exponents, with a comment of another language behind.
 */
final class LooseLine {
  private static final Pattern COMMENT = Pattern.compile("^\\s*;.*|(?:^|(?<=\\s))(?://|[#%!]).*");
  private static final Pattern MINUS =
      Pattern.compile("[\u2010-\u2013\u2212\uFE63\uFF0D](?=[0-9.])");
  private static final Pattern WIDE_BLANK =
      Pattern.compile("[\u00A0\u2000-\u200A\u202F\u205F\u3000]");
  private static final Pattern GROUPED =
      Pattern.compile("(?<![0-9])[0-9]{1,3}(" + WIDE_BLANK.pattern() + "[0-9]{3})+(?![0-9])");
  private static final Pattern FORTRAN = Pattern.compile("([-+]?[0-9.]+)[dD]([-+]?[0-9]+)");
  private static final Pattern QUOTED = Pattern.compile("\"([^\"]*)\"|'([^']*)'");
  private static final Pattern INNERMOST = Pattern.compile("[(\\[{]([^()\\[\\]{}]*)[)\\]}]");
  private static final Pattern BRACKET = Pattern.compile("[()\\[\\]{}]");
  private static final Pattern SEPARATORS = Pattern.compile("[\\s,;]*");
  private static final Pattern SEPARATOR = Pattern.compile("\\s*[,;]\\s*|\\s+");
  private static final Pattern GLUED = Pattern.compile("[0-9],[0-9]");
  private static final Pattern APART =
      Pattern.compile("[0-9.]\\s*(?:;|\\s(?=[-+0-9.]))\\s*[-+0-9.]");
  private static final Pattern WHOLE = Pattern.compile("[0-9]+");

  private LooseLine() {}

  /**
   * A number.
   *
   * @param isWhole whether it is written in digits alone
   */
  record Written(double value, boolean isWhole) {}

  /** What a line holds without the comment behind it. */
  static String withoutComment(String line) {
    return COMMENT.matcher(line).replaceFirst("").strip();
  }

  /**
   * The rows of numbers in a line without comment: none if it holds only brackets, several if each
   * stands in brackets of its own; nothing if it is no line of numbers.
   */
  static Optional<List<List<Written>>> rows(String data) {
    String plain = data;
    if (!isAscii(data)) {
      if (GROUPED.matcher(data).find()) {
        return Optional.empty(); // one number or two
      }
      plain = WIDE_BLANK.matcher(MINUS.matcher(data).replaceAll("-")).replaceAll(" ");
    }
    boolean quoted = plain.indexOf('"') >= 0 || plain.indexOf('\'') >= 0;
    String unquoted = quoted ? QUOTED.matcher(plain).replaceAll("$1$2") : plain;
    return BRACKET.matcher(unquoted).find()
        ? inBrackets(unquoted)
        : numbers(unquoted).map(List::of);
  }

  private static boolean isAscii(String text) {
    return text.chars().allMatch(c -> c < 0x80);
  }

  private static Optional<List<List<Written>>> inBrackets(String data) {
    List<List<Written>> rows = new ArrayList<>();
    StringBuilder outside = new StringBuilder();
    Matcher row = INNERMOST.matcher(data);
    while (row.find()) {
      Optional<List<Written>> numbers = numbers(row.group(1));
      if (numbers.isEmpty()) {
        return Optional.empty();
      }
      rows.add(numbers.get());
      row.appendReplacement(outside, " ");
    }
    row.appendTail(outside);
    String rest = BRACKET.matcher(outside).replaceAll("");
    return SEPARATORS.matcher(rest).matches() ? Optional.of(rows) : Optional.empty();
  }

  private static Optional<List<Written>> numbers(String text) {
    if (text.indexOf(',') >= 0 && GLUED.matcher(text).find() && APART.matcher(text).find()) {
      return Optional.empty(); // the commas can be decimal ones, or stand between thousands
    }
    List<Written> numbers = new ArrayList<>();
    for (String word : SEPARATOR.split(withoutLastSeparator(text.strip()), -1)) {
      double value = Decimals.parse(word);
      Matcher fortran = FORTRAN.matcher(word);
      if (fortran.matches()) {
        value = Decimals.parse(fortran.replaceFirst("$1e$2"));
      }
      if (!Double.isFinite(value)) {
        return Optional.empty();
      }
      numbers.add(new Written(value, WHOLE.matcher(word).matches()));
    }
    return Optional.of(numbers);
  }

  private static String withoutLastSeparator(String data) {
    boolean hasOne = data.endsWith(",") || data.endsWith(";");
    return hasOne ? data.substring(0, data.length() - 1).stripTrailing() : data;
  }
}
