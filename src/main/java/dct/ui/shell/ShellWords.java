package dct.ui.shell;

import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Words as a shell takes them: quoted where it would read something else into them. */
public final class ShellWords {
  private static final Pattern PLAIN =
      Pattern.compile("[\\w./:=,+@%^-]+", Pattern.UNICODE_CHARACTER_CLASS);
  private static final Pattern PLAIN_IN_WINDOWS =
      Pattern.compile("[\\w./:=+@\\\\-]+", Pattern.UNICODE_CHARACTER_CLASS);

  private ShellWords() {}

  /** The words in one line for the shell of this machine. */
  public static String join(List<String> words) {
    boolean windows =
        System.getProperty("os.name", "").toLowerCase(Locale.ROOT).startsWith("windows");
    return words.stream()
        .map(word -> windows ? inWindows(word) : inUnix(word))
        .collect(Collectors.joining(" "));
  }

  /** A word for sh, bash, zsh and fish: quotes in it stand outside of the quotes round it. */
  static String inUnix(String word) {
    return PLAIN.matcher(word).matches() ? word : "'" + word.replace("'", "'\\''") + "'";
  }

  /** A word for cmd and PowerShell; no file's name has a double quote there. */
  static String inWindows(String word) {
    return PLAIN_IN_WINDOWS.matcher(word).matches() ? word : "\"" + word + "\"";
  }
}
