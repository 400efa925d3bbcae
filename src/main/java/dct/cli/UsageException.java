package dct.cli;

import java.util.List;
import java.util.Locale;

/** A command line that asks for what there is not; the message says what would do. */
final class UsageException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  UsageException(String message) {
    super(message);
  }

  /** A word that is none of those known there; the one nearest to it is named. */
  static UsageException unknown(String name, String word, List<String> known) {
    String others = String.join(", ", known.subList(0, known.size() - 1));
    return new UsageException(
        String.format(
            Locale.ROOT,
            "%s %s is unknown%s, use %s%s%s",
            name,
            word,
            Spelling.hint(word, known),
            others,
            others.isEmpty() ? "" : " or ",
            known.get(known.size() - 1)));
  }
}
