package dct.cli;

import java.util.Locale;

/** The formats of outputs; the ending of a file's name chooses one. */
enum Format {
  TXT,
  JSON,
  PNG,
  SVG;

  /**
   * The format for a file of this name.
   *
   * @throws UsageException if its ending is none of theirs
   */
  static Format of(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    for (Format format : values()) {
      if (lower.endsWith(format.ending())) {
        return format;
      }
    }
    throw new UsageException(
        "the ending of " + name + " is no format, use .txt, .json, .png or .svg");
  }

  private String ending() {
    return "." + name().toLowerCase(Locale.ROOT);
  }
}
