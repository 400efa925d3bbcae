package dct.cli;

import java.io.IOException;
import java.util.List;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Model.PositionalParamSpec;

/** {@code dct completion}: a script that lets a shell complete verbs, options, words and files. */
final class CompletionCommand extends Verb {
  private final PositionalParamSpec shell = parameter("bash|zsh|fish", "The shell.");

  CompletionCommand(Console console) {
    super(
        console,
        "Prints a script with which a shell completes the program's verbs, options and words.");
    examples(
        "source <(dct completion bash)        # in ~/.bashrc; likewise for zsh in ~/.zshrc",
        "dct completion fish > ~/.config/fish/completions/dct.fish");
  }

  @Override
  public Integer call() throws IOException {
    CommandLine program = spec().commandLine().getParent();
    String word = shell.getValue();
    switch (word) {
      case "bash", "zsh" -> console().print(bash(program));
      case "fish" -> console().print(FishCompletion.of(program));
      default -> throw UsageException.unknown("the shell", word, List.of("bash", "zsh", "fish"));
    }
    return CommandLineProgram.DONE;
  }

  /**
   * What has no words of its own may be a file; picocli would offer files only for its own type.
   */
  private static String bash(CommandLine program) {
    return AutoComplete.bash("dct", program).replaceAll("(?m)^.*compopt \\+o default$", "");
  }
}
