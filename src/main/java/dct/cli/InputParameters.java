package dct.cli;

import dct.core.Progress;
import dct.core.triangulate.Domain;
import dct.io.PointDocument;
import dct.io.PointFile;
import dct.io.format.Choice;
import dct.io.format.Columns;
import dct.io.format.Regions;
import dct.io.format.Shapes;
import dct.io.format.Touch;
import dct.io.text.BadInputException;
import dct.io.text.Shown;
import dct.problem.Instance;
import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/** The input of a verb, and what it is to be read as. */
final class InputParameters {
  private static final Pattern PAIR = Pattern.compile("([1-9][0-9]{0,3}),([1-9][0-9]{0,3})");

  private final Console console;
  private final PositionalParamSpec name;
  private static final List<String> TOUCHES = List.of("split", "hair");

  private final OptionSpec as;
  private final OptionSpec pick;
  private final OptionSpec columns;
  private final OptionSpec skip;
  private final OptionSpec touching;

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
            "polygon|points|region",
            String.class,
            "What the input is. By default its name (_polygonbased, _pointbased) says so, or else"
                + " its contents (\"kind\" in JSON, a comment \"# kind: points\"), or else it has"
                + " to be a polygon. A region is a ring with holes, and in the own text, in JSON"
                + " and .poly with sites and fixed edges inside.");
    pick =
        verb.option(
            "--pick",
            "N",
            Integer.class,
            "Which of several shapes in the input, from 1 on, or of several regions; without it they"
                + " are listed.");
    columns =
        verb.option(
            "--columns",
            "X,Y",
            String.class,
            "Which columns of a text hold x and y, from 1 on, where it does not tell.");
    skip =
        verb.option(
            "--skip", "LINES", Integer.class, "How many lines at the front of a text to skip.");
    touching =
        verb.option(
            "--touching",
            "split|hair",
            TOUCHES,
            "What to make of a ring that meets itself or, in a region, another: split it into rings or"
                + " the region into regions, or move vertices apart by a hair. By default it is read"
                + " as it is.");
  }

  /** The name of the input as the user gave it. */
  String name() {
    return name.getValue();
  }

  /** Reads the input; what it is declared to be is what was asked for, if anything was. */
  PointDocument read(Progress progress) throws IOException {
    return read(name(), choice(), console, progress);
  }

  /** All shapes of the input. */
  Shapes shapes(Progress progress) throws IOException {
    Shapes all =
        name().equals(Verb.STANDARD_STREAM)
            ? PointFile.shapes(name(), console.in(), columns())
            : PointFile.shapes(path(name()), columns(), progress);
    return all.areRegion(asked())
        ? Regions.outlines(all, Regions.all(all, touch(), progress))
        : touch().split(all, progress);
  }

  private Choice choice() {
    Integer number = pick.getValue();
    OptionalInt picked = number == null ? OptionalInt.empty() : OptionalInt.of(number);
    return new Choice(asked(), Domain.POLYGON, picked, columns(), touch());
  }

  private Touch touch() {
    String typed = touching.getValue();
    if (typed == null) {
      return Touch.KEPT;
    }
    if (!TOUCHES.contains(typed)) {
      throw UsageException.unknown("--touching", typed, TOUCHES);
    }
    return typed.equals("hair") ? Touch.PARTED : Touch.SPLIT;
  }

  private Columns columns() {
    return new Columns(pair(), skipped());
  }

  private int skipped() {
    Integer lines = skip.getValue();
    if (lines != null && lines < 0) {
      throw new UsageException("--skip: " + lines + " is negative; give a number of lines");
    }
    return lines == null ? 0 : lines;
  }

  private Optional<Columns.Pair> pair() {
    String typed = columns.getValue();
    if (typed == null) {
      return Optional.empty();
    }
    Matcher pair = PAIR.matcher(typed);
    if (!pair.matches()) {
      throw new UsageException(
          "--columns: " + typed + " is not two numbers of columns; write --columns 1,2");
    }
    int x = Integer.parseInt(pair.group(1));
    return Optional.of(new Columns.Pair(x, Integer.parseInt(pair.group(2))));
  }

  /** Reads the points of a file, or of standard input. */
  static PointDocument read(String name, Choice choice, Console console, Progress progress)
      throws IOException {
    PointDocument document =
        name.equals(Verb.STANDARD_STREAM)
            ? PointFile.read(name, console.in(), choice)
            : PointFile.read(path(name), choice, progress);
    for (String note : document.notes()) {
      console.err().println(Shown.harmless(name) + ": " + note);
    }
    return document;
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
      throw UsageException.unknown("--as", word, List.of("polygon", "points", "region"));
    }
    return domain;
  }
}
