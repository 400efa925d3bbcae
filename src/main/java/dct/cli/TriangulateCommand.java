package dct.cli;

import dct.core.degree.DegreeCount;
import dct.core.degree.FlipResult;
import dct.core.degree.ScanFlip;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.io.DomainWord;
import dct.io.Result;
import dct.io.ResultJson;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code dct triangulate}: an algorithm, perhaps flips, and what came out. */
@Command(
    name = "triangulate",
    description =
        "Triangulates a simple polygon, or point sites, and counts even and odd vertices.")
final class TriangulateCommand implements Callable<Integer> {
  private final Console console;

  @Mixin private InputOptions input;

  @Option(
      names = "--algorithm",
      paramLabel = "A",
      description =
          "For polygons ear-clipping, monotone (default), convex-even, convex-odd; for points delaunay"
              + " (default and only).")
  private String algorithm;

  @Option(names = "--flip", description = "Run Scan-Flip on what the algorithm made.")
  private boolean flip;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "OUTPUT",
      description =
          "Where to write: .json the whole result, .txt the vertices, .png or .svg a picture; - is the"
              + " whole result as JSON on standard output. May repeat.")
  private List<String> outputs = List.of();

  @Option(names = "--json", description = "Print the summary as one JSON object.")
  private boolean json;

  @Option(names = "--quiet", description = "Print no summary for people.")
  private boolean quiet;

  TriangulateCommand(Console console) {
    this.console = console;
  }

  @Override
  public Integer call() throws IOException {
    outputs.stream().filter(output -> !output.equals("-")).forEach(Format::of);
    if (json && outputs.contains("-")) {
      throw new UsageException("--json and -o - both want standard output, leave one out");
    }
    ResultOutput made = make();
    for (String output : outputs) {
      made.write(output, console);
    }
    print(made.result());
    return CommandLineProgram.DONE;
  }

  private void print(Result result) throws IOException {
    if (json) {
      console.print(ResultJson.summary(result));
    } else if (!quiet && !outputs.contains("-")) {
      console.print(Summary.of(result));
    }
  }

  private ResultOutput make() throws IOException {
    Stopwatch watch = new Stopwatch();
    Shape shape = Shape.of(input.read(console));
    double read = watch.lap();
    Algorithm chosen = chosen(shape.domain());
    Triangulation made = chosen.triangulate(shape);
    double triangulate = watch.lap();
    Optional<FlipResult> flipped = flip ? Optional.of(ScanFlip.run(made)) : Optional.empty();
    Result result =
        new Result(
            input.name(),
            chosen.word(),
            flipped.map(FlipResult::after).orElse(made),
            flipped.map(TriangulateCommand::post),
            shape.merged(),
            new Result.Millis(read, triangulate, flip ? watch.lap() : 0));
    return new ResultOutput(result, flipped);
  }

  private static Result.Post post(FlipResult flipped) {
    return new Result.Post("flip", DegreeCount.of(flipped.before()), flipped.flips());
  }

  private Algorithm chosen(Domain domain) {
    if (algorithm == null) {
      return Algorithm.byDefault(domain);
    }
    return Algorithm.of(algorithm, domain)
        .orElseThrow(
            () ->
                new UsageException(
                    "--algorithm %s is none for %s, use %s"
                        .formatted(
                            algorithm,
                            domain == Domain.POLYGON ? "a polygon" : DomainWord.of(domain),
                            Algorithm.words(domain))));
  }
}
