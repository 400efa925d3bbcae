package dct.cli;

import dct.core.Progress;
import dct.io.AtomicFile;
import dct.io.FileEnding;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Where to write, and in which format.
 *
 * @param name the name of a file, or {@code -} for standard output
 * @param format what its name or an option says; nothing only for standard output
 */
record Output(String name, Optional<FileEnding> format) {
  /** Standard output, in the format that suits what is written. */
  static final Output STANDARD = new Output(Verb.STANDARD_STREAM, Optional.empty());

  /**
   * An output whose format its name tells.
   *
   * @throws UsageException if it tells none
   */
  static Output of(String name) {
    return name.equals(Verb.STANDARD_STREAM)
        ? STANDARD
        : new Output(name, Optional.of(Verb.ending(name)));
  }

  boolean isStandard() {
    return name.equals(Verb.STANDARD_STREAM);
  }

  Path file() {
    return Path.of(name);
  }

  /** Whether it is a file in one of the program's own formats. */
  boolean isOwnFile() {
    return !isStandard()
        && format
            .filter(ending -> ending == FileEnding.TXT || ending == FileEnding.JSON)
            .isPresent();
  }

  /** Writes content to it; to a file whole or not at all. */
  void write(Console console, AtomicFile.Content content) throws IOException {
    if (isStandard()) {
      content.writeTo(console.out());
      console.out().flush();
    } else {
      AtomicFile.write(file(), Progress.NONE, content);
    }
  }
}
