package dct.io.format.plain;

import java.util.Optional;
import java.util.regex.Pattern;

/** Forms of other programs, told by a line that is not a vertex. */
enum ForeignText {
  PARENTHESES(
      "\\(.*", "the parentheses do not hold one vertex each; write two numbers x y in each pair"),
  BRACES("\\{.*", "the braces do not hold one vertex each; write two numbers x y in each pair"),
  BRACKETS("\\[.*", "the brackets do not hold one vertex each; write two numbers x y in each pair"),
  QUOTED("[\"'][+-]?[0-9.].*", "the quotation marks do not hold one number each; remove the marks"),
  OFF(
      "(ST)?[CN4n]{0,4}OFF\\b.*",
      "this looks like OFF; write one vertex a line, as two numbers x y"),
  PLY("ply", "this looks like PLY; write one vertex a line, as two numbers x y");

  private static final String HEADER = "this looks like a header row below the first; remove it";

  private final Pattern pattern;
  private final String fault;

  ForeignText(String line, String fault) {
    pattern = Pattern.compile(line, Pattern.DOTALL);
    this.fault = fault;
  }

  /** What is wrong and what would mend it, if the line is of one of these forms. */
  static Optional<String> fault(String line) {
    for (ForeignText form : values()) {
      if (form.pattern.matcher(line).matches()) {
        return Optional.of(form.fault);
      }
    }
    boolean isHeader = HeaderRow.isSeparated(line) && HeaderRow.of(line).isPresent();
    return isHeader ? Optional.of(HEADER) : Optional.empty();
  }
}
