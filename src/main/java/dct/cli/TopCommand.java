package dct.cli;

import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/** The command above all verbs. */
@Command(
    name = "dct",
    mixinStandardHelpOptions = true,
    versionProvider = TopCommand.Version.class,
    scope = ScopeType.INHERIT,
    sortOptions = false,
    usageHelpWidth = 100,
    description = "Triangulations with as many even-degree vertices as possible.",
    synopsisSubcommandLabel = "VERB",
    footer = {
      "",
      "Without arguments the window opens; dct FILE… opens files in it.",
      "Exit status: 0 done, 2 wrong usage, 3 bad input, 1 anything else."
    })
final class TopCommand implements Runnable {
  @Spec private CommandSpec spec;

  @Override
  public void run() {
    throw new ParameterException(spec.commandLine(), "a verb is missing");
  }

  /** The version that the jar's manifest gives. */
  static final class Version implements IVersionProvider {
    @Override
    public String[] getVersion() {
      String version = TopCommand.class.getPackage().getImplementationVersion();
      return new String[] {"dct " + (version == null ? "(not from a jar)" : version)};
    }
  }
}
