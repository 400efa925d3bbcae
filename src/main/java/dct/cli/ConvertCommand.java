package dct.cli;

import dct.io.PointDocument;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code dct convert}: the same points in another format. */
@Command(
    name = "convert",
    description = "Writes the points of a file in another format. They need not be a polygon.")
final class ConvertCommand implements Callable<Integer> {
  private final Console console;

  @Mixin private InputOptions input;

  @Option(
      names = {"-o", "--output"},
      required = true,
      paramLabel = "OUTPUT",
      description =
          "Where to: .txt, .json, .png or .svg; - is text on standard output. May repeat.")
  private List<String> outputs;

  ConvertCommand(Console console) {
    this.console = console;
  }

  @Override
  public Integer call() throws IOException {
    outputs.stream().filter(output -> !output.equals("-")).forEach(Format::of);
    PointDocument document = input.read(console);
    for (String output : outputs) {
      PointOutput.write(document, output, console);
    }
    return CommandLineProgram.DONE;
  }
}
