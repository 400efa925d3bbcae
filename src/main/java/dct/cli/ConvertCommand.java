package dct.cli;

import dct.core.Progress;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import dct.io.PointDocument;
import dct.io.format.Shape;
import dct.io.text.Shown;
import dct.problem.Solution;
import dct.render.Figure;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Model.OptionSpec;

/** {@code dct convert}: the same points, or the same result, in another format. */
final class ConvertCommand extends Verb {
  private final InputParameters input = new InputParameters(this);
  private final OptionSpec output =
      outputs(
          false,
          "Where to: "
              + Output.endings()
              + "; - is standard output, text if --to says nothing else. May repeat.");
  private final OptionSpec to =
      option(
          "--to",
          "FORMAT",
          Output.formats(),
          "The format, whatever the ending of OUTPUT: "
              + String.join(", ", Output.formats())
              + ".");
  private final OptionSpec list =
      flag("--list", "List the shapes in the input, as --pick numbers them, instead.");

  private final PictureParameters picture = new PictureParameters(this);

  ConvertCommand(Console console) {
    super(
        console,
        "Writes a file in another format.",
        "The points need not be a polygon. The triangulation of a result is kept where the format"
            + " can hold one.");
    examples(
        "dct convert samples/star_polygonbased.txt -o star.ipe",
        "dct convert samples/star_polygonbased.txt -o - --to wkt",
        "dct convert samples/star_polygonbased.txt --list");
  }

  @Override
  public Integer call() throws IOException {
    List<Output> outputs = outputs();
    if (isSet(list)) {
      list();
      return CommandLineProgram.DONE;
    }
    if (outputs.isEmpty()) {
      throw new UsageException("-o OUTPUT is missing");
    }
    picture.check();
    PointDocument document = input.read(Progress.NONE);
    document.declared().ifPresent(domain -> checkNames(outputs, domain));
    Optional<Solution> solution = document.solution(Progress.NONE);
    try (Interruption interruption = new Interruption()) {
      write(document, solution, outputs, picture.figure(document.yUp()));
      return interruption.status();
    }
  }

  private List<Output> outputs() {
    String format = to.getValue();
    if (format == null) {
      return outputsOf(output);
    }
    if (!Output.formats().contains(format)) {
      throw UsageException.unknown("--to", format, Output.formats());
    }
    Optional<FileEnding> ending = Optional.of(Output.ending("." + format));
    return namesOf(output).stream().map(name -> new Output(name, ending)).toList();
  }

  private void list() throws IOException {
    List<Shape> shapes = input.shapes(Progress.NONE).shapes();
    for (int i = 0; i < shapes.size(); i++) {
      console().print(i + 1 + ": " + Shown.harmless(shapes.get(i).description()));
    }
  }

  private void write(
      PointDocument document, Optional<Solution> solution, List<Output> outputs, Figure figure)
      throws IOException {
    for (Output file : outputs) {
      if (solution.isEmpty() || holdsPointsAlone(file)) {
        PointOutput.write(document, file, figure, console());
      } else {
        SolutionOutput.write(solution.get(), Optional.empty(), file, figure, console());
      }
      if (solution.isPresent() && holdsPointsAlone(file)) {
        console()
            .err()
            .println(
                Shown.harmless(file.name())
                    + ": holds the points alone; the triangulation is left out, use .json");
      }
    }
  }

  private static boolean holdsPointsAlone(Output file) {
    return !file.format().orElse(FileEnding.TXT).holds(Content.TRIANGULATION, Content.PICTURE);
  }
}
