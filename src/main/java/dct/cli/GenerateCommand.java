package dct.cli;

import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.generate.RandomSites;
import dct.io.PointDocument;
import java.io.IOException;
import java.util.List;
import java.util.Objects;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/** {@code dct generate}: seeded random input. */
final class GenerateCommand extends Verb {
  private static final long DEFAULT_SEED = 1;

  private final PositionalParamSpec what = parameter("points", "What to make.");
  private final OptionSpec n = requiredOption("-n", "N", Integer.class, "How many.");
  private final OptionSpec shape =
      option("--shape", "S", String.class, "How they lie: uniform (default and only).");
  private final OptionSpec seed =
      option(
          "--seed", "N", Long.class, "Which of the random sets, any whole number; 1 by default.");
  private final OptionSpec output =
      outputs(
          false,
          "Where to: .txt, .json, .png or .svg; - is text on standard output, which is the default."
              + " May repeat.");

  GenerateCommand(Console console) {
    super(
        console,
        "Makes random points.",
        "They have integer coordinates, are all different, 0 ≤ x < 1000 and 0 ≤ y < 700. From 350001"
            + " points on, both sides are doubled until half of the places stay free. The same"
            + " options give the same points on every machine.");
  }

  @Override
  public Integer call() throws IOException {
    List<String> outputs = outputsOf(output);
    checkShape();
    PointDocument document = PointDocument.of(STANDARD_STREAM, Domain.SITES, points());
    for (String file : outputs.isEmpty() ? List.of(STANDARD_STREAM) : outputs) {
      PointOutput.write(document, file, console());
    }
    return CommandLineProgram.DONE;
  }

  private void checkShape() {
    String word = what.getValue();
    if (!word.equals("points")) {
      throw new UsageException(word + " cannot be made, only points");
    }
    String wished = shape.getValue();
    if (wished != null && !wished.equals("uniform")) {
      throw new UsageException("--shape " + wished + " is unknown, use uniform");
    }
  }

  private Points points() {
    int count = n.getValue();
    if (count < 1 || count > RandomSites.MOST) {
      throw new UsageException("-n " + count + " is not from 1 to " + RandomSites.MOST);
    }
    Long wished = seed.getValue();
    return RandomSites.uniform(count, Objects.requireNonNullElse(wished, DEFAULT_SEED));
  }
}
