package dct.io.format.drawing;

import dct.io.format.Head;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The name of the outermost element of a file of XML, from which its format is told. */
final class RootName {
  private static final Pattern MARKUP = Pattern.compile("<[?!A-Za-z_]");
  private static final Pattern NAME = Pattern.compile("(?:[A-Za-z_][\\w.-]*:)?([A-Za-z_][\\w.-]*)");

  private final String text;
  private int at;

  private RootName(String text) {
    this.text = text;
  }

  /** Whether a file starts as XML does. */
  static boolean isXml(Head head) {
    return head.startsWith(MARKUP);
  }

  /** The name without its prefix; empty if it is no XML or the element comes too late. */
  static String of(Head head) {
    return isXml(head) ? new RootName(head.text()).name() : "";
  }

  private String name() {
    while (at < text.length()) {
      if (text.startsWith("<?", at)) {
        skipTo("?>");
      } else if (text.startsWith("<!--", at)) {
        skipTo("-->");
      } else if (text.startsWith("<!", at)) {
        skipDeclaration();
      } else if (Character.isWhitespace(text.charAt(at))) {
        at++;
      } else {
        return element();
      }
    }
    return "";
  }

  private String element() {
    Matcher name = NAME.matcher(text).region(Math.min(at + 1, text.length()), text.length());
    return text.charAt(at) == '<' && name.lookingAt() ? name.group(1) : "";
  }

  private void skipTo(String end) {
    int found = text.indexOf(end, at);
    at = found < 0 ? text.length() : found + end.length();
  }

  /** Skips a DOCTYPE with what it declares in brackets. */
  private void skipDeclaration() {
    boolean inBrackets = false;
    char quote = 0;
    for (; at < text.length(); at++) {
      char c = text.charAt(at);
      if (quote != 0) {
        quote = c == quote ? 0 : quote;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '>' && !inBrackets) {
        at++;
        return;
      } else if (c == '[' || c == ']') {
        inBrackets = c == '[';
      }
    }
  }
}
