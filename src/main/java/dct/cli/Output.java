package dct.cli;

import dct.core.Progress;
import dct.io.AtomicFile;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Where to write, and in which format.
 *
 * @param name the name of a file, or {@code -} for standard output
 * @param format what its name or an option says; nothing only for standard output
 */
record Output(String name, Optional<FileEnding> format) {
  /** What standard input and output are called. */
  static final String STREAM = "-";

  private static final Content[] CONTENTS = {
    Content.POINTS, Content.TRIANGULATION, Content.PICTURE
  };

  /** Standard output, in the format that suits what is written. */
  static final Output STANDARD = new Output(STREAM, Optional.empty());

  /**
   * An output whose format its name tells.
   *
   * @throws UsageException if it tells none
   */
  static Output of(String name) {
    return name.equals(STREAM) ? STANDARD : new Output(name, Optional.of(ending(name)));
  }

  boolean isStandard() {
    return name.equals(STREAM);
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

  /** The words for the formats of all outputs that are no files of a study. */
  static List<String> formats() {
    return List.of(FileEnding.extensions(CONTENTS));
  }

  /** The endings of all outputs that are no files of a study, for messages. */
  static String endings() {
    return FileEnding.list(CONTENTS);
  }

  /**
   * The ending of an output of this name.
   *
   * @throws UsageException if it is no format
   */
  static FileEnding ending(String name) {
    return FileEnding.of(name, CONTENTS)
        .orElseThrow(
            () -> new UsageException("the ending of " + name + " is no format, use " + endings()));
  }
}
