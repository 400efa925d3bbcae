package dct.cli;

import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import picocli.CommandLine;
import picocli.CommandLine.Model.PositionalParamSpec;

/** {@code dct help}: the help of the program or of one verb. */
final class HelpCommand extends Verb {
  private final PositionalParamSpec verb =
      optionalParameter("VERB", NAMES, "The verb to explain; without one, the program.");

  HelpCommand(Console console) {
    super(console, "Explains the program, or one of its verbs.");
    examples("dct help triangulate");
  }

  @Override
  public Integer call() {
    CommandLine program = spec().commandLine().getParent();
    PrintWriter out = new PrintWriter(console().out(), false, StandardCharsets.UTF_8);
    explained(program).usage(out, program.getColorScheme());
    out.flush();
    return CommandLineProgram.DONE;
  }

  private CommandLine explained(CommandLine program) {
    Map<String, CommandLine> verbs = program.getSubcommands();
    String wished = verb.getValue();
    if (wished == null) {
      return program;
    }
    if (!verbs.containsKey(wished)) {
      throw UsageException.unknown("the verb", wished, List.copyOf(verbs.keySet()));
    }
    return verbs.get(wished);
  }
}
