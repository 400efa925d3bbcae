package dct.cli;

import java.util.Locale;

/** The formats of outputs; the ending of a file's name chooses one. */
enum Format {
  TXT,
  JSON,
  OFF,
  PNG,
  SVG,
  PDF,
  IPE,
  TEX;

  /** The endings of all, for messages. */
  static final String ENDINGS = ".txt, .json, .off, .png, .svg, .pdf, .ipe or .tex";

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
    throw new UsageException("the ending of " + name + " is no format, use " + ENDINGS);
  }

  private String ending() {
    return "." + name().toLowerCase(Locale.ROOT);
  }
}
