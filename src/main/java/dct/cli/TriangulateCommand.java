package dct.cli;

import dct.core.Progress;
import dct.core.degree.Optimum;
import dct.core.triangulate.Domain;
import dct.io.PointDocument;
import dct.io.ResultJson;
import dct.io.text.BadInputException;
import dct.io.text.Shown;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import dct.render.Figure;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import picocli.CommandLine.Model.OptionSpec;

/** {@code dct triangulate}: an algorithm, perhaps flips, and what came out. */
final class TriangulateCommand extends Verb {
  private static final String AS_READ = "as-read";

  private final InputParameters input = new InputParameters(this);
  private final OptionSpec algorithm =
      option(
          "--algorithm",
          "A",
          Stream.concat(Arrays.stream(Method.values()).map(Method::word), Stream.of(AS_READ))
              .toList(),
          "For polygons and regions ear-clipping, monotone (default), convex-even, convex-odd; for"
              + " points delaunay (default); as-read takes the triangulation that the input holds.");
  private final OptionSpec flip = flag("--flip", "Run Scan-Flip on what the algorithm made.");
  private final OptimizeParameters optimize = new OptimizeParameters(this);
  private final OptionSpec output =
      outputs(
          false,
          "Where to: "
              + Output.endings()
              + "; .json is the whole result, and so is - on standard output. May repeat.");
  private final PictureParameters picture = new PictureParameters(this);
  private final OptionSpec json = flag("--json", "Print the summary as one JSON object.");
  private final OptionSpec quiet = flag("--quiet", "Print no summary for people.");

  TriangulateCommand(Console console) {
    super(
        console,
        "Triangulates a simple polygon, point sites, or a region with holes, and counts even and odd"
            + " vertices.");
    examples(
        "dct triangulate samples/comb_polygonbased.txt --flip",
        "dct triangulate samples/random_50_pointbased.txt --optimize even -o result.json -o"
            + " result.svg",
        "dct triangulate samples/comb_polygonbased.txt --optimize even --prefer length");
  }

  @Override
  public Integer call() throws IOException {
    List<Output> outputs = outputsOf(output);
    picture.check();
    boolean printsResult = outputs.contains(Output.STANDARD);
    if (isSet(json) && printsResult) {
      throw new UsageException("--json and -o - both want standard output, leave one out");
    }
    optimize.check(input.name(), isSet(flip));
    Stopwatch watch = new Stopwatch();
    PointDocument document = input.read(Progress.NONE);
    Optional<Solution> held = held(document);
    Instance instance = document.instance(Progress.NONE).named(input.name());
    checkNames(outputs, instance.domain());
    try (Interruption interruption = new Interruption()) {
      Made made = make(instance, held, watch, progress(interruption, !isSet(quiet)));
      write(made, outputs, picture.figure(document.yUp()));
      if (interruption.isAsked()
          && made.solution.optimum().stream().anyMatch(Optimum::interrupted)) {
        console().err().println("dct triangulate: stopped; the result is the best found so far");
      }
      return interruption.status();
    }
  }

  private void write(Made made, List<Output> outputs, Figure figure) throws IOException {
    for (Output file : outputs) {
      SolutionOutput.write(made.solution, made.millis, file, figure, console());
    }
    if (isSet(json)) {
      console().print(ResultJson.summary(made.solution, made.millis));
    } else if (!isSet(quiet) && !outputs.contains(Output.STANDARD)) {
      console().print(Summary.of(made.solution));
    }
  }

  /** A solution and how long its steps took. */
  private record Made(Solution solution, Optional<ResultJson.Millis> millis) {}

  /** The triangulation that the input holds, if that is asked for. */
  private Optional<Solution> held(PointDocument document) {
    boolean isAsked = AS_READ.equals(algorithm.getValue());
    if (!isAsked && document.isOwn()) {
      return Optional.empty();
    }
    Optional<Solution> held = document.solution(Progress.NONE);
    if (isAsked && held.isEmpty()) {
      throw new BadInputException(
          input.name(),
          0,
          "there is no triangulation in it, as --algorithm as-read takes; leave the option out");
    }
    if (!isAsked && held.isPresent()) {
      console()
          .err()
          .println(
              Shown.harmless(input.name())
                  + ": its triangulation is left out; --algorithm as-read takes it");
    }
    return held.filter(solution -> isAsked);
  }

  private Made make(Instance instance, Optional<Solution> held, Stopwatch watch, Progress progress)
      throws IOException {
    double read = watch.lap();
    Instance asked = optimize.isAsked() ? optimize.wishedOf(instance) : instance;
    Solution made =
        held.isPresent()
            ? Solution.read(asked, held.get().triangulation().plain())
            : Solution.of(asked, chosen(instance.domain()), progress);
    double triangulate = watch.lap();
    Solution solution = post(made, progress);
    double post = isSet(flip) || optimize.isAsked() ? watch.lap() : 0;
    return new Made(solution, Optional.of(new ResultJson.Millis(read, triangulate, post)));
  }

  private Solution post(Solution made, Progress progress) throws IOException {
    if (isSet(flip)) {
      return made.flipped(progress);
    }
    return optimize.isAsked() ? optimize.optimized(made, progress) : made;
  }

  private Method chosen(Domain domain) {
    String word = algorithm.getValue();
    return word == null
        ? Method.byDefault(domain)
        : Method.of(domain, word)
            .orElseThrow(
                () ->
                    new UsageException(
                        "--algorithm "
                            + word
                            + " is none for "
                            + (domain == Domain.SITES ? "points" : "a " + domain.word())
                            + Spelling.hint(word, Method.words(domain))
                            + ", use "
                            + String.join(", ", Method.words(domain))));
  }
}
