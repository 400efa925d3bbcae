package dct.cli;

import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.RandomSites;
import dct.io.PointDocument;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code dct generate}: seeded random input. */
@Command(
    name = "generate",
    description = {
      "Makes random points.",
      "They have integer coordinates, all different, 0 ≤ x < 1000, 0 ≤ y < 700. From"
          + " 350001 points on, both sides are doubled until half of the places stay free. The same"
          + " options give the same points on every machine."
    })
final class GenerateCommand implements Callable<Integer> {
  private final Console console;

  @Parameters(paramLabel = "points", description = "What to make.")
  private String what;

  @Option(names = "-n", required = true, paramLabel = "N", description = "How many.")
  private int n;

  @Option(
      names = "--shape",
      paramLabel = "S",
      defaultValue = "uniform",
      description = "How they lie: uniform (default and only).")
  private String shape;

  @Option(
      names = "--seed",
      paramLabel = "N",
      defaultValue = "1",
      description = "Which of the random sets, any whole number; default 1.")
  private long seed;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "OUTPUT",
      defaultValue = "-",
      description =
          "Where to: .txt, .json, .png or .svg; - (default) is text on standard output. May repeat.")
  private List<String> outputs;

  GenerateCommand(Console console) {
    this.console = console;
  }

  @Override
  public Integer call() throws IOException {
    check();
    Points points = RandomSites.uniform(n, seed);
    PointDocument document = PointDocument.of("-", Domain.SITES, points);
    for (String output : outputs) {
      PointOutput.write(document, output, console);
    }
    return CommandLineProgram.DONE;
  }

  private void check() {
    if (!what.equals("points")) {
      throw new UsageException(what + " cannot be made, only points");
    }
    if (!shape.equals("uniform")) {
      throw new UsageException("--shape " + shape + " is unknown, use uniform");
    }
    if (n < 1 || n > RandomSites.MOST) {
      throw new UsageException("-n " + n + " is not from 1 to " + RandomSites.MOST);
    }
    outputs.stream().filter(output -> !output.equals("-")).forEach(Format::of);
  }
}
