package dct.ui.document;

import dct.io.FileStamp;
import java.nio.file.Path;
import java.util.Optional;

/**
 * The file that a document was opened from or saved to.
 *
 * @param stamp what it held then; nothing if that could not be told
 */
public record Origin(Path file, Optional<FileStamp> stamp) {

  /** What people call the file. */
  public String name() {
    return file.getFileName().toString();
  }
}
