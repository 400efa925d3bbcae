package dct.cli;

import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/** Completion for the shell fish, which picocli does not write: a line for each thing to offer. */
final class FishCompletion {
  private static final String EACH = "complete -c dct";

  private FishCompletion() {}

  /** The script for a program with these verbs. */
  static String of(CommandLine program) {
    return Stream.concat(
            program.getSubcommands().values().stream().map(FishCompletion::verb),
            Stream.concat(Stream.of(program), program.getSubcommands().values().stream())
                .flatMap(FishCompletion::arguments))
        .collect(Collectors.joining("\n"));
  }

  private static String verb(CommandLine verb) {
    CommandSpec spec = verb.getCommandSpec();
    return EACH
        + " -n __fish_use_subcommand -a "
        + spec.name()
        + " -d "
        + quoted(spec.usageMessage().description()[0]);
  }

  private static Stream<String> arguments(CommandLine of) {
    CommandSpec spec = of.getCommandSpec();
    String where =
        of.getParent() == null
            ? " -n __fish_use_subcommand"
            : " -n '__fish_seen_subcommand_from " + spec.name() + "'";
    return Stream.concat(
        spec.options().stream().map(option -> EACH + where + option(option)),
        spec.positionalParameters().stream()
            .filter(parameter -> parameter.completionCandidates() != null)
            .map(parameter -> EACH + where + words(parameter)));
  }

  private static String option(OptionSpec option) {
    StringBuilder text = new StringBuilder();
    for (String name : option.names()) {
      text.append(name.startsWith("--") ? " -l " + name.substring(2) : " -s " + name.substring(1));
    }
    if (option.arity().max() > 0) {
      text.append(" -r").append(option.completionCandidates() == null ? "" : words(option));
    }
    return text.append(" -d ").append(quoted(String.join(" ", option.description()))).toString();
  }

  private static String words(ArgSpec of) {
    return StreamSupport.stream(of.completionCandidates().spliterator(), false)
        .collect(Collectors.joining(" ", " -a '", "'"));
  }

  private static String quoted(String text) {
    String first = text.replaceFirst("[.;:] .*", "."); // what fish shows beside a word is short
    return "'" + first.replace("\\", "\\\\").replace("'", "\\'") + "'";
  }
}
