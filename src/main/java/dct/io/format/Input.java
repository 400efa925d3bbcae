package dct.io.format;

import java.io.InputStream;
import java.nio.file.Path;
import java.util.Optional;

/**
 * What a format reads.
 *
 * @param name what messages call it, "-" for standard input
 * @param in text in UTF-8 without a byte-order mark, whatever the file's encoding
 * @param file where it stands, for formats of several files; nothing for a stream
 * @param columns which columns of a text are meant
 */
public record Input(String name, InputStream in, Optional<Path> file, Columns columns) {

  /** A stream of which nothing more is known. */
  public static Input of(String name, InputStream in) {
    return new Input(name, in, Optional.empty(), Columns.TOLD_BY_CONTENT);
  }
}
