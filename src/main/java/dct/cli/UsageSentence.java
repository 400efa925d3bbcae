package dct.cli;

import java.io.File;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.OverwrittenOptionException;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/** Says in the program's own words what picocli found wrong in a command line. */
final class UsageSentence {
  private UsageSentence() {}

  /** The sentence, without its end: what is wrong, and what would do. */
  static String of(ParameterException e, String... arguments) {
    if (e instanceof UnmatchedArgumentException unmatched) {
      return unmatched(unmatched);
    }
    if (e instanceof MissingParameterException missing) {
      return missing(missing, List.of(arguments));
    }
    if (e instanceof OverwrittenOptionException twice) {
      return name(twice.getOverwritten()) + " is given twice, leave one out";
    }
    return e.getArgSpec() == null
        ? valueOfFlag(e, arguments)
        : wrongValue(e.getArgSpec(), e.getValue());
  }

  private static String unmatched(UnmatchedArgumentException e) {
    String word = e.getUnmatched().get(0);
    String command = e.getCommandLine().getCommandSpec().qualifiedName();
    if (!e.isUnknownOption()) {
      return "\""
          + word
          + "\" is one argument too many, leave it out; a name with blanks needs quotes";
    }
    Collection<String> known = e.getCommandLine().getCommandSpec().optionsMap().keySet();
    String name = nameIn(word);
    Optional<String> file = fileIn(List.of(word));
    if (file.isPresent()) {
      return word + " is no option of " + command + file.get();
    }
    String cure = e.getCommandLine().getParent() == null ? ", a verb comes first" : "";
    return name + " is no option of " + command + Spelling.hint(name, known) + cure;
  }

  /** What to write for a file that looks like an option, if there is one. */
  private static Optional<String> fileIn(List<String> arguments) {
    return arguments.stream()
        .filter(argument -> argument.startsWith("-") && FileArguments.isFile(argument))
        .findFirst()
        .map(file -> "; for the file of this name write ." + File.separator + file);
  }

  private static String nameIn(String argument) {
    return argument.replaceFirst("=.*", "");
  }

  /** picocli does not say which option it was. */
  private static String valueOfFlag(ParameterException e, String... arguments) {
    Map<String, OptionSpec> known = e.getCommandLine().getCommandSpec().optionsMap();
    return Arrays.stream(arguments)
        .filter(argument -> argument.contains("=") && known.containsKey(nameIn(argument)))
        .findFirst()
        .map(argument -> nameIn(argument) + " takes no value, write it without one")
        .orElse(e.getMessage());
  }

  private static String missing(MissingParameterException e, List<String> arguments) {
    ArgSpec missing = e.getMissing().get(0);
    if (!(missing instanceof OptionSpec option)) {
      return missing.paramLabel().replace("|", " or ")
          + " is missing"
          + fileIn(arguments).orElse("");
    }
    return arguments.stream().anyMatch(List.of(option.names())::contains)
        ? name(option) + " needs a value: " + option.paramLabel().replace("|", " or ")
        : name(option) + " " + option.paramLabel() + " is missing";
  }

  private static String wrongValue(ArgSpec of, String value) {
    Class<?> type = of.auxiliaryTypes()[0];
    String wrong = name(of) + " " + value;
    if (type == Double.class) {
      return wrong + " is not a number, use one such as 2.5";
    }
    return value.matches("[+-]?[0-9]+")
        ? wrong + " is too far from 0, use a smaller number"
        : wrong + " is not a whole number, use one such as 100";
  }

  /** The name by which the user knows an option. */
  private static String name(ArgSpec of) {
    return of instanceof OptionSpec option ? option.shortestName() : of.paramLabel();
  }
}
