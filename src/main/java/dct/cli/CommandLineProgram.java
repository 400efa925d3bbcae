package dct.cli;

import dct.io.CannotWriteException;
import dct.io.format.SeveralShapes;
import dct.io.format.Shape;
import dct.io.text.BadInputException;
import dct.io.text.Shown;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import picocli.CommandLine;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Model.CommandSpec;

/**
 * The program without a screen.
 *
 * <p>Whatever happens, a user sees a sentence and no stack trace, unless the environment variable
 * {@code DCT_DEBUG} is set.
 */
public final class CommandLineProgram {
  /** Everything asked for was done. */
  public static final int DONE = 0;

  /** Something failed that is neither wrong usage nor bad input. */
  public static final int FAILED = 1;

  /** The command line itself is wrong. */
  public static final int WRONG_USAGE = 2;

  /** An input cannot be used. */
  public static final int BAD_INPUT = 3;

  /** A result that was to be verified says something false. */
  public static final int FALSE_RESULT = 4;

  /** A result that was to be verified claims something that cannot be recomputed. */
  public static final int OPEN_RESULT = 5;

  static final int HELP_WIDTH = 100;

  /** The verbs that speak of the others. */
  private static final List<String> ABOUT = List.of("help", "completion");

  private final Console console;

  private CommandLineProgram(Console console) {
    this.console = console;
  }

  /** Does what these arguments ask for; returns the exit status. */
  public static int run(Console console, String... arguments) {
    return new CommandLineProgram(console).run(arguments);
  }

  private int run(String... arguments) {
    if (arguments.length > 0 && !Verb.isVerb(arguments[0]) && !arguments[0].startsWith("-")) {
      return wrongUsage(withoutVerb(List.of(arguments)), "dct");
    }
    try {
      int status = commandLine(arguments).execute(arguments);
      return status == DONE ? flushed() : status;
    } catch (Throwable e) { // picocli passes errors on
      return explain(e);
    }
  }

  /** Says what has ended a thread that was not the main one; returns the exit status. */
  public static int failed(Console console, Throwable cause) {
    return new CommandLineProgram(console).explain(cause);
  }

  /** What is wrong with arguments that begin with no verb. */
  private static String withoutVerb(List<String> arguments) {
    String stray = arguments.stream().filter(a -> !FileArguments.isFile(a)).findFirst().orElse("");
    if (stray.equals(arguments.get(0))) {
      return String.format(
          Locale.ROOT,
          "\"%s\" is neither a verb nor a file%s",
          stray,
          Spelling.hint(stray, Verb.NAMES));
    }
    return Verb.isVerb(stray) || stray.startsWith("-") || stray.isEmpty()
        ? "a verb is missing, it comes before files and options"
        : "\"" + stray + "\" is no file";
  }

  private int flushed() {
    try {
      console.out().flush();
      return DONE;
    } catch (IOException e) {
      return explain(e);
    }
  }

  private CommandLine commandLine(String... arguments) {
    CommandSpec top = top();
    boolean clear =
        arguments.length > 0 && Verb.isVerb(arguments[0]) && !ABOUT.contains(arguments[0]);
    for (String verb : clear ? List.of(arguments[0]) : Verb.NAMES) {
      top.addSubcommand(verb, verb(verb).spec());
    }
    return new CommandLine(top)
        .setColorScheme(CommandLine.Help.defaultColorScheme(Ansi.OFF))
        .setOut(new PrintWriter(console.out(), false, StandardCharsets.UTF_8))
        .setErr(new PrintWriter(console.err(), true, StandardCharsets.UTF_8))
        .setExpandAtFiles(false) // @ may begin a file's name
        .setParameterExceptionHandler(
            (e, args) -> wrongUsage(UsageSentence.of(e, args), e.getCommandLine()))
        .setExecutionExceptionHandler((e, command, result) -> explain(e, command));
  }

  private static CommandSpec top() {
    Runnable noVerb =
        () -> {
          throw new UsageException("a verb is missing");
        };
    CommandSpec top = CommandSpec.wrapWithoutInspection(noVerb).name("dct");
    Verb.addHelp(top);
    top.usageMessage()
        .description("Triangulations with as many even-degree vertices as possible.")
        .synopsisSubcommandLabel("VERB")
        .commandListHeading("Verbs:%n")
        .footer(
            "",
            "Without arguments the window opens; dct FILE… opens files in it.",
            "Exit status: 0 done, 2 wrong usage, 3 bad input, 130 stopped by Ctrl+C, 1 anything"
                + " else.",
            "",
            "Examples:",
            "  dct triangulate samples/random_500_pointbased.txt --flip",
            "  dct help generate");
    return top;
  }

  private Verb verb(String name) {
    return switch (name) {
      case "triangulate" -> new TriangulateCommand(console);
      case "generate" -> new GenerateCommand(console);
      case "experiment" -> new ExperimentCommand(console);
      case "convert" -> new ConvertCommand(console);
      case "check" -> new CheckCommand(console);
      case "verify" -> new VerifyCommand(console);
      case "help" -> new HelpCommand(console);
      default -> new CompletionCommand(console);
    };
  }

  private int wrongUsage(String message, CommandLine command) {
    return wrongUsage(message, command.getCommandSpec().qualifiedName());
  }

  private int wrongUsage(String message, String name) {
    console.err().println(name + ": " + Shown.harmless(message) + "; see " + name + " --help");
    return WRONG_USAGE;
  }

  private int explain(Exception e, CommandLine command) {
    if (e instanceof UsageException) {
      return wrongUsage(e.getMessage(), command);
    }
    if (e instanceof CancellationException) {
      return Interruption.STATUS;
    }
    boolean silent = command.getCommand() instanceof Verb verb && verb.isSilent();
    return silent && e instanceof BadInputException ? BAD_INPUT : explain(e);
  }

  private void list(List<Shape> shapes) {
    for (int i = 0; i < shapes.size(); i++) {
      console.err().println("  " + (i + 1) + ": " + Shown.harmless(shapes.get(i).description()));
    }
  }

  private int explain(Throwable e) {
    if (System.getenv("DCT_DEBUG") != null) {
      e.printStackTrace(console.err());
    }
    if (e instanceof BadInputException) {
      console.err().println(e.getMessage());
      if (e instanceof SeveralShapes several) {
        list(several.shapes().shapes());
      }
      return BAD_INPUT;
    }
    String sentence = sentence(e);
    if (!sentence.isEmpty()) {
      console.err().println(sentence);
    }
    return FAILED;
  }

  private static String sentence(Throwable e) {
    if (e instanceof CannotWriteException) {
      return e.getMessage();
    }
    if (e instanceof IOException) {
      boolean gone = e.getMessage() != null && e.getMessage().contains("Broken pipe");
      return gone
          ? ""
          : "dct: standard input or output failed, " + e.getMessage() + "; try another";
    }
    if (e instanceof InvalidPathException invalid) {
      return String.format(
          Locale.ROOT,
          "dct: %s can be no file's name here; choose another or set a UTF-8 locale",
          Shown.harmless(invalid.getInput()));
    }
    if (e instanceof OutOfMemoryError) {
      return "dct: there is not enough memory; give Java more with -Xmx, for instance -Xmx4g";
    }
    return "dct: the program failed, " + e + "; this is a fault of the program, please report it";
  }
}
