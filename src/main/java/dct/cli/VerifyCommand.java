package dct.cli;

import dct.io.ResultJson;
import dct.io.StoredResult;
import java.io.IOException;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code dct verify}: whether a result file tells the truth. */
@Command(
    name = "verify",
    description = {
      "Checks a result independently.",
      "Takes a whole result (triangulate -o RESULT.json) and believes nothing in it: planar,"
          + " covers the domain, degrees recounted, flips undone and recounted, Delaunay where"
          + " claimed."
    })
final class VerifyCommand implements Callable<Integer> {
  private final Console console;

  @Parameters(paramLabel = "RESULT.json", description = "The result; - is standard input.")
  private String name;

  @Option(names = "--quiet", description = "Print nothing; the exit status tells.")
  private boolean quiet;

  VerifyCommand(Console console) {
    this.console = console;
  }

  @Override
  public Integer call() throws IOException {
    StoredResult stored =
        name.equals("-")
            ? ResultJson.read(name, console.in())
            : ResultJson.read(InputOptions.path(name));
    ResultVerifier.verify(stored);
    if (!quiet) {
      console.print(
          "%s: true, %s, %d vertices, %d even, %d odd"
              .formatted(
                  name,
                  stored.text("algorithm").orElseThrow(),
                  stored.points().size(),
                  stored.whole("even").orElseThrow(),
                  stored.whole("odd").orElseThrow()));
    }
    return CommandLineProgram.DONE;
  }
}
