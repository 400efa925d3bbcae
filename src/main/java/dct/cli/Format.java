package dct.cli;

import dct.render.PictureFile;
import java.nio.file.Path;
import java.util.Locale;

/** The kinds of outputs; the ending of a file's name chooses one. */
enum Format {
  TXT,
  JSON,
  OFF,
  /** Any of {@link PictureFile.Format}. */
  PICTURE;

  /** The endings of all, for messages. */
  static final String ENDINGS = ".txt, .json, .off, " + PictureFile.Format.ENDINGS;

  /**
   * The format for a file of this name.
   *
   * @throws UsageException if its ending is none of theirs
   */
  static Format of(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    for (Format format : new Format[] {TXT, JSON, OFF}) {
      if (lower.endsWith("." + format.name().toLowerCase(Locale.ROOT))) {
        return format;
      }
    }
    if (PictureFile.Format.of(Path.of(name)).isPresent()) {
      return PICTURE;
    }
    throw new UsageException("the ending of " + name + " is no format, use " + ENDINGS);
  }
}
