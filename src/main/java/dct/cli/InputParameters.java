package dct.cli;

import dct.core.Progress;
import dct.core.triangulate.Domain;
import dct.io.BadInputException;
import dct.io.PointDocument;
import dct.io.PointFile;
import dct.problem.Instance;
import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/** The input of a verb, and what it is to be read as. */
final class InputParameters {
  private final Console console;
  private final PositionalParamSpec name;
  private final OptionSpec as;

  /** Declares them. */
  InputParameters(Verb verb) {
    console = verb.console();
    name =
        verb.parameter(
            "INPUT",
            "A file with a vertex x y a line, or the program's JSON; - is standard input. The"
                + " extension, also with _polygonbased or _pointbased, may be left out.");
    as =
        verb.option(
            "--as",
            "polygon|points",
            String.class,
            "What the input is. By default its name (_polygonbased, _pointbased) says so, or else"
                + " its contents (\"kind\" in JSON, a comment \"# kind: points\"), or else it has to"
                + " be a polygon.");
  }

  /** The name of the input as the user gave it. */
  String name() {
    return name.getValue();
  }

  /** Reads the input; what it is declared to be is what was asked for, if anything was. */
  PointDocument read(Progress progress) throws IOException {
    Optional<Domain> asked = asked();
    PointDocument document = read(name(), console, progress);
    return asked.isPresent() ? document.declared(asked.get()) : document;
  }

  /** Reads the points of a file, or of standard input. */
  static PointDocument read(String name, Console console, Progress progress) throws IOException {
    return name.equals(Verb.STANDARD_STREAM)
        ? PointFile.read(name, console.in())
        : PointFile.read(path(name), progress);
  }

  /**
   * Reads the input and judges its points; it has the name that the user gave.
   *
   * @throws BadInputException if they are not usable
   */
  Instance instance(Progress progress) throws IOException {
    return read(progress).instance(progress).named(name());
  }

  /**
   * The path of this name.
   *
   * @throws BadInputException if it is empty or no file can have it
   */
  static Path path(String name) {
    if (name.isEmpty()) {
      throw new BadInputException("\"\"", 0, "this is no name of a file; name one");
    }
    try {
      return Path.of(name);
    } catch (InvalidPathException e) {
      throw new BadInputException(
          name, 0, "this can be no file's name here; rename the file or set a UTF-8 locale");
    }
  }

  private Optional<Domain> asked() {
    String word = as.getValue();
    if (word == null) {
      return Optional.empty();
    }
    Optional<Domain> domain = Domain.parse(word);
    if (domain.isEmpty()) {
      throw UsageException.unknown("--as", word, List.of("polygon", "points"));
    }
    return domain;
  }
}
