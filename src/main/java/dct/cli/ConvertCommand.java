package dct.cli;

import dct.io.PointDocument;
import java.io.IOException;
import java.util.List;
import picocli.CommandLine.Model.OptionSpec;

/** {@code dct convert}: the same points in another format. */
final class ConvertCommand extends Verb {
  private final InputParameters input = new InputParameters(this);
  private final OptionSpec output =
      outputs(true, "Where to: " + endings() + "; - is text on standard output. May repeat.");

  ConvertCommand(Console console) {
    super(console, "Writes the points of a file in another format. They need not be a polygon.");
  }

  @Override
  public Integer call() throws IOException {
    List<String> outputs = outputsOf(output);
    PointDocument document = input.read();
    document.declared().ifPresent(domain -> checkNames(outputs, domain));
    for (String file : outputs) {
      PointOutput.write(document, file, console());
    }
    return CommandLineProgram.DONE;
  }
}
