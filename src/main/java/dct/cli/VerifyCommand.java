package dct.cli;

import dct.io.ResultJson;
import dct.io.StoredResult;
import java.io.IOException;
import java.util.Locale;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/** {@code dct verify}: whether a result file tells the truth. */
final class VerifyCommand extends Verb {
  private final PositionalParamSpec result =
      parameter("RESULT.json", "The result; - is standard input.");
  private final OptionSpec quiet = flag("--quiet", "Print nothing; the exit status tells.");

  VerifyCommand(Console console) {
    super(
        console,
        "Checks a result independently.",
        "Takes a whole result (triangulate -o RESULT.json) and believes nothing in it: planar,"
            + " covers the domain, degrees recounted, flips undone and recounted, Delaunay where"
            + " claimed, the lower bound recomputed; or it says that it could not be.");
  }

  @Override
  boolean isSilent() {
    return isSet(quiet);
  }

  @Override
  public Integer call() throws IOException {
    String name = result.getValue();
    StoredResult stored =
        name.equals("-")
            ? ResultJson.read(name, console().in())
            : ResultJson.read(InputParameters.path(name));
    String remark = ResultVerifier.verify(stored);
    if (!isSet(quiet)) {
      console()
          .print(
              String.format(
                  Locale.ROOT,
                  "%s: true, %s, %d vertices, %d even, %d odd%s",
                  name,
                  stored.text("algorithm").orElseThrow(),
                  stored.points().size(),
                  stored.whole("even").orElseThrow(),
                  stored.whole("odd").orElseThrow(),
                  remark));
    }
    return CommandLineProgram.DONE;
  }
}
