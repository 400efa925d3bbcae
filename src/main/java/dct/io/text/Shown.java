package dct.io.text;

import java.util.Locale;

/** Text of a file or a file's name as a message repeats it: short, and harmless on a terminal. */
public final class Shown {
  private static final int LONGEST = 40; // characters

  private Shown() {}

  /** A word of a file: cut if it is long, with every invisible character named. */
  public static String word(String word) {
    boolean isLong = word.length() > LONGEST;
    return harmless(isLong ? word.substring(0, LONGEST) + "…" : word);
  }

  /** The text with its control characters, marks of direction and line ends as U+ and a number. */
  public static String harmless(String text) {
    StringBuilder shown = new StringBuilder(text.length());
    text.codePoints()
        .forEach(
            c -> {
              if (isHarmless(c)) {
                shown.appendCodePoint(c);
              } else {
                shown.append('<').append(number(c)).append('>');
              }
            });
    return shown.toString();
  }

  private static boolean isHarmless(int c) {
    return switch (Character.getType(c)) {
      case Character.CONTROL,
          Character.FORMAT,
          Character.LINE_SEPARATOR,
          Character.PARAGRAPH_SEPARATOR,
          Character.SURROGATE ->
          false;
      default -> true;
    };
  }

  /** A character by its number and name. */
  public static String named(int c) {
    String name = Character.getName(c);
    return name == null ? number(c) : number(c) + " (" + name + ")";
  }

  private static String number(int c) {
    return String.format(Locale.ROOT, "U+%04X", c);
  }
}
