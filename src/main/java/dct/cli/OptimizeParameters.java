package dct.cli;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.Preference;
import dct.core.degree.SearchLimits;
import dct.io.WishFile;
import dct.io.format.Choice;
import dct.io.text.BadInputException;
import dct.problem.Instance;
import dct.problem.Solution;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import picocli.CommandLine.Model.OptionSpec;

/** What the user wishes of the degrees, what is preferred, and how long to look for it. */
final class OptimizeParameters {
  private static final double LEAST_EFFORT = 0.01;

  private static final String NONE = "none";
  private static final String KEPT = Preference.Kind.KEPT.word() + ":";
  private static final List<String> PREFERENCES =
      List.of(Preference.Kind.ANGLE.word(), Preference.Kind.LENGTH.word(), NONE);

  private final Console console;
  private final OptionSpec goal;
  private final OptionSpec prefer;
  private final OptionSpec timeLimit;
  private final OptionSpec seed;
  private final OptionSpec effort;

  /** Declares them. */
  OptimizeParameters(Verb verb) {
    console = verb.console();
    goal =
        verb.option(
            "--optimize",
            "even|odd|FILE",
            String.class,
            "Find the triangulation with the most even, or odd, vertices; or, with a file that has"
                + " a line \"v even|odd|any\" for each vertex that shall not be even, the one that"
                + " grants the most wishes.");
    prefer =
        verb.option(
            "--prefer",
            String.join("|", PREFERENCES) + "|" + KEPT + "RESULT",
            Stream.concat(PREFERENCES.stream(), Stream.of(KEPT)).toList(),
            "With --optimize: among equally good triangulations the one with the largest smallest"
                + " angle (default), the least total length, or the most edges of a triangulation"
                + " in a file; or none, whichever is found.");
    timeLimit =
        verb.option(
            "--time-limit",
            "S",
            Double.class,
            "With --optimize: return the best found after so many seconds.");
    seed =
        verb.option(
            "--seed",
            "N",
            Long.class,
            "With --optimize: the seed of its random choices, 1 if absent.");
    effort =
        verb.option(
            "--effort",
            "E",
            Double.class,
            "With --optimize: how hard to try, 1 if absent; 2 takes about twice as long.");
  }

  /** Whether the user asked for it. */
  boolean isAsked() {
    return goal.getValue() != null;
  }

  /**
   * Sees that the options go together.
   *
   * @throws UsageException if they do not
   */
  void check(String input, boolean flip) {
    if (isAsked() && flip) {
      throw new UsageException("--flip and --optimize exclude each other, leave one out");
    }
    if (!isAsked() && prefer.getValue() != null) {
      throw new UsageException("--prefer belongs to --optimize, which is missing");
    }
    checkPreference(input);
    if (!isAsked() && Stream.of(timeLimit, seed, effort).anyMatch(o -> o.getValue() != null)) {
      throw new UsageException(
          "--time-limit, --seed and --effort belong to --optimize, which is missing");
    }
    if (input.equals(Verb.STANDARD_STREAM) && input.equals(goal.getValue())) {
      throw new UsageException("INPUT and --optimize both want standard input, name a file");
    }
    Double seconds = timeLimit.getValue();
    if (seconds != null && !(seconds >= 0)) {
      throw new UsageException("--time-limit is a number of seconds, 0 or more");
    }
    Double hard = effort.getValue();
    if (hard != null && !(hard >= LEAST_EFFORT && Double.isFinite(hard))) {
      throw new UsageException("--effort is a number, 0.01 or more; 1 is usual");
    }
  }

  private void checkPreference(String input) {
    String word = prefer.getValue();
    if (word == null || PREFERENCES.contains(word)) {
      return;
    }
    if (!word.startsWith(KEPT)) {
      String meant = Spelling.hint(word, PREFERENCES);
      throw new UsageException(
          "--prefer " + word + " is unknown" + meant + ", use angle, length, none or kept:RESULT");
    }
    if (word.equals(KEPT)) {
      throw new UsageException("--prefer kept: names no file, write --prefer kept:RESULT.json");
    }
    if (word.equals(KEPT + Verb.STANDARD_STREAM)
        && (input.equals(Verb.STANDARD_STREAM) || Verb.STANDARD_STREAM.equals(goal.getValue()))) {
      throw new UsageException("--prefer wants standard input too, name a file");
    }
  }

  /** The best triangulation, and the preferred one of several. */
  Solution optimized(Solution made, Progress progress) throws IOException {
    Optional<Preference> preference = preference(made.instance());
    return preference.isEmpty()
        ? made.optimized(limits(), progress)
        : made.optimized(limits(), preference.get(), progress);
  }

  private Optional<Preference> preference(Instance instance) throws IOException {
    String word = prefer.getValue();
    if (NONE.equals(word)) {
      return Optional.empty();
    }
    if (word == null || word.equals(Preference.Kind.ANGLE.word())) {
      return Optional.of(Preference.ANGLE);
    }
    return Optional.of(
        word.startsWith(KEPT)
            ? keeping(word.substring(KEPT.length()), instance)
            : Preference.LENGTH);
  }

  private Preference keeping(String name, Instance instance) throws IOException {
    Choice choice = Choice.NONE.otherwise(instance.domain());
    Solution given =
        InputParameters.read(name, choice, console, Progress.NONE)
            .solution(Progress.NONE)
            .orElseThrow(
                () ->
                    new BadInputException(
                        name, 0, "there is no triangulation in it; triangulate it first"));
    if (!given.instance().points().equals(instance.points())) {
      throw new BadInputException(
          name, 0, "its points are not those of " + instance.name() + "; name a result of them");
    }
    return Preference.keeping(given.triangulation());
  }

  /** The instance with what the user wishes of its vertices. */
  Instance wishedOf(Instance instance) throws IOException {
    return instance.with(wished(instance.size()));
  }

  private ParityGoal wished(int n) throws IOException {
    String word = goal.getValue();
    return switch (word) {
      case "even" -> ParityGoal.allEven(n);
      case "odd" -> ParityGoal.allOdd(n);
      case Verb.STANDARD_STREAM -> WishFile.read(word, console.in(), n);
      default -> WishFile.read(wishFile(word), n, Progress.NONE);
    };
  }

  private static Path wishFile(String word) {
    Path file = InputParameters.path(word);
    if (Files.notExists(file)) {
      String meant = Spelling.hint(word, List.of("even", "odd"));
      throw new BadInputException(
          word, 0, "there is no such file; --optimize takes even, odd or a file of wishes" + meant);
    }
    return file;
  }

  /** How long to look for it. */
  SearchLimits limits() {
    SearchLimits usual = SearchLimits.DEFAULT;
    Long number = seed.getValue();
    Double seconds = timeLimit.getValue();
    Double hard = effort.getValue();
    return new SearchLimits(
        number == null ? usual.seed() : number,
        hard == null ? usual.effort() : hard,
        seconds == null ? usual.seconds() : seconds);
  }
}
