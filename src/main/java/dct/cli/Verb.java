package dct.cli;

import dct.core.Progress;
import dct.core.triangulate.Domain;
import dct.io.FileNames;
import dct.problem.Solution;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/**
 * One verb of the command line: its parameters, and what it does with them.
 *
 * <p>The parameters are declared by calls and not by annotations, whose reflection would double the
 * time that the program takes to start.
 */
abstract class Verb implements Callable<Integer> {
  private static final int LINE = 72; // letters of a description, beside the names of options

  /** The verbs that there are. */
  static final List<String> NAMES =
      List.of(
          "triangulate",
          "generate",
          "experiment",
          "convert",
          "check",
          "verify",
          "help",
          "completion");

  static final String STANDARD_STREAM = Output.STREAM;

  private final Console console;
  private final CommandSpec spec = CommandSpec.wrapWithoutInspection(this);

  Verb(Console console, String... description) {
    this.console = console;
    addHelp(spec);
    spec.usageMessage().description(description);
  }

  /** Whether this word is one of the program's verbs. */
  static boolean isVerb(String word) {
    return NAMES.contains(word);
  }

  /** Adds what every command understands. */
  static void addHelp(CommandSpec spec) {
    spec.addOption(
        OptionSpec.builder("-h", "--help")
            .usageHelp(true)
            .description("Show this help and exit.")
            .build());
    spec.addOption(
        OptionSpec.builder("-V", "--version")
            .versionHelp(true)
            .description("Show the version and exit.")
            .build());
    spec.version("dct " + Solution.programVersion() + ", Apache License 2.0");
    spec.usageMessage().sortOptions(false).width(CommandLineProgram.HELP_WIDTH);
  }

  final CommandSpec spec() {
    return spec;
  }

  final Console console() {
    return console;
  }

  /** Whether the exit status alone tells what came out, faults of the input included. */
  boolean isSilent() {
    return false;
  }

  /** Where a long work tells how far it is, if a person watches, and hears that it shall stop. */
  final Progress progress(Interruption interruption, boolean isShown) {
    return new TimeLeft(console.err(), isShown && console.isTerminal(), interruption);
  }

  /** Declares a required parameter without a name. */
  final PositionalParamSpec parameter(String label, String description) {
    PositionalParamSpec parameter =
        PositionalParamSpec.builder()
            .paramLabel(label)
            .index("0")
            .required(true)
            .arity("1")
            .type(String.class)
            .completionCandidates(words(label))
            .description(description)
            .build();
    spec.addPositional(parameter);
    return parameter;
  }

  /** Declares a parameter without a name that is one of these words and may be left out. */
  final PositionalParamSpec optionalParameter(
      String label, List<String> words, String description) {
    PositionalParamSpec parameter =
        PositionalParamSpec.builder()
            .paramLabel(label)
            .index("0")
            .arity("0..1")
            .type(String.class)
            .completionCandidates(words)
            .description(description)
            .build();
    spec.addPositional(parameter);
    return parameter;
  }

  /** Declares parameters without a name after the required one; there may be none. */
  final PositionalParamSpec parameters(String label, String description) {
    PositionalParamSpec parameters =
        PositionalParamSpec.builder()
            .paramLabel(label)
            .index("1..*")
            .arity("0..*")
            .type(List.class)
            .auxiliaryTypes(String.class)
            .description(description)
            .build();
    spec.addPositional(parameters);
    return parameters;
  }

  /** Declares an option without a value. */
  final OptionSpec flag(String name, String description) {
    OptionSpec option =
        OptionSpec.builder(name).type(boolean.class).arity("0").description(description).build();
    spec.addOption(option);
    return option;
  }

  /** Declares an option with a value of this type, null where it is not given. */
  final OptionSpec option(String name, String label, Class<?> type, String description) {
    return option(OptionSpec.builder(name).type(type), label, description);
  }

  /** Declares an option that has to be given, with a value of this type. */
  final OptionSpec requiredOption(String name, String label, Class<?> type, String description) {
    return option(OptionSpec.builder(name).type(type).required(true), label, description);
  }

  /** Declares the option {@code -o}, which may repeat. */
  final OptionSpec outputs(boolean required, String description) {
    return option(
        OptionSpec.builder("-o", "--output")
            .type(List.class)
            .auxiliaryTypes(String.class)
            .required(required),
        "OUTPUT",
        description);
  }

  /** Declares an option whose value is one of these words. */
  final OptionSpec option(String name, String label, List<String> words, String description) {
    OptionSpec.Builder option = OptionSpec.builder(name).type(String.class);
    return option(option.completionCandidates(words), label, description);
  }

  private OptionSpec option(OptionSpec.Builder builder, String label, String description) {
    if (label.contains("|") && builder.completionCandidates() == null) {
      builder.completionCandidates(words(label));
    }
    OptionSpec option =
        builder.paramLabel(label).arity("1").description(lines(description)).build();
    spec.addOption(option);
    return option;
  }

  /** The lines of a description, broken between words alone: picocli would break behind a dot. */
  private static String[] lines(String description) {
    StringBuilder text = new StringBuilder();
    int length = 0;
    for (String word : description.split(" ", -1)) {
      boolean fits = length + 1 + word.length() <= LINE;
      text.append(length == 0 ? "" : fits ? " " : "\n").append(word);
      length = length > 0 && fits ? length + 1 + word.length() : word.length();
    }
    return text.toString().lines().toArray(String[]::new);
  }

  /** The words that a label such as {@code even|odd|FILE} names, for completion; none is null. */
  private static List<String> words(String label) {
    return label.contains("|")
        ? Arrays.stream(label.split("\\|"))
            .filter(w -> w.equals(w.toLowerCase(Locale.ROOT)))
            .toList()
        : null;
  }

  /** Adds examples at the end of the help. */
  final void examples(String... lines) {
    String head = lines.length == 1 ? "Example:" : "Examples:";
    spec.usageMessage()
        .footer(
            Stream.concat(Stream.of("", head), Arrays.stream(lines).map(line -> "  " + line))
                .toArray(String[]::new));
  }

  static boolean isSet(OptionSpec flag) {
    return Boolean.TRUE.equals(flag.getValue());
  }

  /**
   * The outputs asked for, none if there is no {@code -o}.
   *
   * @throws UsageException if one of them has an ending that is no format
   */
  static List<Output> outputsOf(OptionSpec option) {
    return namesOf(option).stream().map(Output::of).toList();
  }

  /** The names of the outputs asked for. */
  static List<String> namesOf(OptionSpec option) {
    List<String> names = option.getValue();
    return names == null ? List.of() : names;
  }

  /**
   * Sees that no output says by its name that it holds the other kind of data.
   *
   * @throws UsageException if one does and can be read again
   */
  static void checkNames(List<Output> outputs, Domain domain) {
    for (Output output : outputs) {
      Optional<String> wrong =
          output.isOwnFile() ? FileNames.contradiction(output.file(), domain) : Optional.empty();
      wrong.ifPresent(
          sentence -> {
            throw new UsageException(sentence);
          });
    }
  }
}
