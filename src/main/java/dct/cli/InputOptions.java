package dct.cli;

import dct.core.triangulate.Domain;
import dct.io.BadInputException;
import dct.io.DomainWord;
import dct.io.PointDocument;
import dct.io.PointFile;
import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The input of a command, and what it is to be read as. */
final class InputOptions {

  @Parameters(
      paramLabel = "INPUT",
      description =
          "A file with a vertex x y a line, or the program's JSON; - is standard input. The extension,"
              + " also with _polygonbased or _pointbased, may be left out.")
  private String name;

  @Option(
      names = "--as",
      paramLabel = "polygon|points",
      description =
          "What the input is. By default its name (_polygonbased, _pointbased) says so, or else its"
              + " contents (\"kind\" in JSON, a comment \"# kind: points\"), or else it has to be a"
              + " polygon.")
  private String as;

  String name() {
    return name;
  }

  /** Reads the input; what it is declared to be is what was asked for, if anything was. */
  PointDocument read(Console console) throws IOException {
    Optional<Domain> asked = asked();
    PointDocument document =
        name.equals("-") ? PointFile.read(name, console.in()) : PointFile.read(path(name));
    return asked.map(document::declared).orElse(document);
  }

  /**
   * The path of this name.
   *
   * @throws BadInputException if no file can have it
   */
  static Path path(String name) {
    try {
      return Path.of(name);
    } catch (InvalidPathException e) {
      throw new BadInputException(
          name, 0, "this can be no file's name here; rename the file or set a UTF-8 locale");
    }
  }

  private Optional<Domain> asked() {
    if (as == null) {
      return Optional.empty();
    }
    Optional<Domain> domain = DomainWord.parse(as);
    if (domain.isEmpty()) {
      throw new UsageException("--as " + as + " is unknown, use polygon or points");
    }
    return domain;
  }
}
