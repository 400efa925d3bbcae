package dct.cli;

import dct.io.FileNames;
import dct.io.text.BadInputException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Arguments that are the names of files and no command. */
public final class FileArguments {

  private FileArguments() {}

  /**
   * The files that these arguments name, none if there are no arguments; nothing if the first is a
   * verb or one of them names no file.
   */
  public static Optional<List<Path>> of(String... arguments) {
    if (arguments.length > 0 && Verb.isVerb(arguments[0])) {
      return Optional.empty();
    }
    List<Path> files = new ArrayList<>();
    for (String argument : arguments) {
      Optional<Path> file = file(argument);
      if (file.isEmpty()) {
        return Optional.empty();
      }
      files.add(file.get());
    }
    return Optional.of(files);
  }

  /** Whether there is a file of this name, as the window would open it. */
  static boolean isFile(String name) {
    return file(name).isPresent();
  }

  private static Optional<Path> file(String name) {
    try {
      return Optional.of(FileNames.forOpening(Path.of(name))).filter(Files::isRegularFile);
    } catch (InvalidPathException | BadInputException e) {
      return Optional.empty();
    }
  }
}
