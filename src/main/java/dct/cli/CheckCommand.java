package dct.cli;

import dct.core.Progress;
import dct.problem.Instance;
import java.io.IOException;
import picocli.CommandLine.Model.OptionSpec;

/** {@code dct check}: whether an input can be triangulated. */
final class CheckCommand extends Verb {
  private final InputParameters input = new InputParameters(this);
  private final OptionSpec quiet = flag("--quiet", "Print nothing; the exit status tells.");

  CheckCommand(Console console) {
    super(console, "Is it a simple polygon, or usable sites? Says what is wrong, and where.");
    examples("dct check samples/comb_polygonbased.txt");
  }

  @Override
  boolean isSilent() {
    return isSet(quiet);
  }

  @Override
  public Integer call() throws IOException {
    Instance instance = input.instance(Progress.NONE);
    if (!isSet(quiet)) {
      console().print(input.name() + ": " + instance.description());
    }
    return CommandLineProgram.DONE;
  }
}
