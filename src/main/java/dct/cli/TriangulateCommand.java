package dct.cli;

import dct.core.Progress;
import dct.core.degree.DegreeCount;
import dct.core.degree.FlipResult;
import dct.core.degree.Optimum;
import dct.core.degree.ScanFlip;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import dct.io.Result;
import dct.io.ResultJson;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Model.OptionSpec;

/** {@code dct triangulate}: an algorithm, perhaps flips, and what came out. */
final class TriangulateCommand extends Verb {
  private final InputParameters input = new InputParameters(this);
  private final OptionSpec algorithm =
      option(
          "--algorithm",
          "A",
          String.class,
          "For polygons ear-clipping, monotone (default), convex-even, convex-odd; for points delaunay"
              + " (default and only).");
  private final OptionSpec flip = flag("--flip", "Run Scan-Flip on what the algorithm made.");
  private final OptimizeParameters optimize = new OptimizeParameters(this);
  private final OptionSpec output =
      outputs(
          false,
          "Where to write: .json the whole result, .txt the vertices, .off the triangles, "
              + FileEnding.list(Content.PICTURE)
              + " a picture; - is the"
              + " whole result as JSON on standard output. May repeat.");
  private final OptionSpec json = flag("--json", "Print the summary as one JSON object.");
  private final OptionSpec quiet = flag("--quiet", "Print no summary for people.");

  TriangulateCommand(Console console) {
    super(
        console,
        "Triangulates a simple polygon, or point sites, and counts even and odd vertices.");
  }

  @Override
  public Integer call() throws IOException {
    List<String> outputs = outputsOf(output);
    boolean printsResult = outputs.contains(STANDARD_STREAM);
    if (isSet(json) && printsResult) {
      throw new UsageException("--json and -o - both want standard output, leave one out");
    }
    optimize.check(isSet(flip));
    ResultOutput made = make();
    for (String file : outputs) {
      made.write(file, console());
    }
    if (isSet(json)) {
      console().print(ResultJson.summary(made.result()));
    } else if (!isSet(quiet) && !printsResult) {
      console().print(Summary.of(made.result()));
    }
    return CommandLineProgram.DONE;
  }

  private ResultOutput make() throws IOException {
    Stopwatch watch = new Stopwatch();
    Shape shape = Shape.of(input.read());
    checkNames(outputsOf(output), shape.domain());
    double read = watch.lap();
    Algorithm chosen = chosen(shape.domain());
    Triangulation made = chosen.triangulate(shape);
    double triangulate = watch.lap();
    Optional<FlipResult> flipped =
        isSet(flip) ? Optional.of(ScanFlip.run(made, Progress.NONE)) : Optional.empty();
    Optional<Optimum> best =
        optimize.isAsked() ? Optional.of(optimize.optimize(shape, made)) : Optional.empty();
    double post = flipped.isPresent() || best.isPresent() ? watch.lap() : 0;
    Result result =
        new Result(
            input.name(),
            chosen.word(),
            best.map(Optimum::triangulation).or(() -> flipped.map(FlipResult::after)).orElse(made),
            flipped.map(TriangulateCommand::post),
            best,
            shape.merged(),
            new Result.Millis(read, triangulate, post));
    return new ResultOutput(result, flipped);
  }

  private static Result.Post post(FlipResult flipped) {
    return new Result.Post("flip", DegreeCount.of(flipped.before()), flipped.flips());
  }

  private Algorithm chosen(Domain domain) {
    String word = algorithm.getValue();
    return word == null ? Algorithm.byDefault(domain) : Algorithm.of(word, domain);
  }
}
