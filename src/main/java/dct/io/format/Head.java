package dct.io.format;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.regex.Pattern;

/**
 * The start of a file, from which its format is told.
 *
 * @param text the first {@value #LENGTH} bytes, read as UTF-8; without white space at its front
 */
public record Head(String text) {
  /** How many bytes are looked at. */
  public static final int LENGTH = 1 << 16;

  /** Looks at the start of a stream, which afterwards stands where it stood before. */
  public static Head of(BufferedInputStream in) throws IOException {
    in.mark(LENGTH);
    byte[] bytes = in.readNBytes(LENGTH);
    in.reset();
    return new Head(new String(bytes, StandardCharsets.UTF_8).stripLeading());
  }

  /** Whether the file may go on behind the text; so says its length. */
  public boolean isCut() {
    return text.length() > LENGTH / 2;
  }

  /** The first character; 0 if there is none. */
  public char first() {
    return text.isEmpty() ? 0 : text.charAt(0);
  }

  /** Whether the text starts with a match of a pattern. */
  public boolean startsWith(Pattern pattern) {
    return pattern.matcher(text).lookingAt();
  }

  /** The same behind the lines at its front that start with {@code #}. */
  public Head withoutComments() {
    int from = 0;
    while (from < text.length() && text.charAt(from) == '#') {
      int end = text.indexOf('\n', from);
      from = end < 0 ? text.length() : end + 1;
      while (from < text.length() && Character.isWhitespace(text.charAt(from))) {
        from++;
      }
    }
    return from == 0 ? this : new Head(text.substring(from));
  }

  /** Whether the text is the start of an object of JSON in which a field of this name occurs. */
  public boolean hasField(String name) {
    return first() == '{' && Pattern.compile("\"" + name + "\"\\s*:").matcher(text).find();
  }
}
