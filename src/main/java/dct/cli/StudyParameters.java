package dct.cli;

import dct.experiment.generate.RandomSites;
import dct.experiment.study.PointsStudy;
import dct.experiment.study.Study;
import dct.experiment.study.StudyPlan;
import dct.experiment.study.ThesisTable;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/** Which study, of what. */
final class StudyParameters {
  static final int MOST_THREADS = 1024;

  private static final long DEFAULT_SEED = 1;
  private static final int FEWEST = 3; // vertices of a triangle

  private final PositionalParamSpec what;
  private final OptionSpec shapes;
  private final OptionSpec sizes;
  private final OptionSpec sets;
  private final OptionSpec seed;

  /** Declares them. */
  StudyParameters(Verb verb) {
    what = verb.parameter("points", "What is studied.");
    shapes = verb.option("--shapes", "S,…", String.class, "How they lie: uniform.");
    sizes =
        verb.option(
            "--sizes",
            "N,…",
            String.class,
            "The numbers of vertices, as 50,100,200 or 50-500:50, which is the default for points.");
    sets =
        verb.option("--sets", "N", Integer.class, "How many of each shape and size; 5 for points.");
    seed =
        verb.option(
            "--seed", "N", Long.class, "From which all others follow, any whole number; 1.");
  }

  /**
   * The study that was asked for.
   *
   * @throws UsageException if there is none such
   */
  Study study() {
    String word = what.getValue();
    if (!word.equals("points")) {
      throw new UsageException("there is no study of " + word + ", use points");
    }
    return new PointsStudy(
        new StudyPlan(
            chosenShapes(List.of(PointsStudy.UNIFORM)),
            chosenSizes(ThesisTable.sizes(), RandomSites.MOST),
            chosenSets(PointsStudy.SETS),
            chosenSeed()));
  }

  private long chosenSeed() {
    Long asked = seed.getValue();
    return Objects.requireNonNullElse(asked, DEFAULT_SEED);
  }

  private int chosenSets(int usual) {
    Integer asked = sets.getValue();
    int number = Objects.requireNonNullElse(asked, usual);
    if (number < 1) {
      throw new UsageException("--sets " + number + " is none, use 1 or more");
    }
    return number;
  }

  private List<String> chosenShapes(List<String> known) {
    String asked = shapes.getValue();
    if (asked == null) {
      return known;
    }
    Set<String> chosen = new LinkedHashSet<>();
    for (String word : asked.split(",", -1)) {
      if (!known.contains(word)) {
        throw new UsageException(
            "--shapes %s is unknown, use some of %s".formatted(word, String.join(",", known)));
      }
      chosen.add(word);
    }
    return List.copyOf(chosen);
  }

  private List<Integer> chosenSizes(List<Integer> usual, int most) {
    String asked = sizes.getValue();
    if (asked == null) {
      return usual;
    }
    Set<Integer> chosen = new LinkedHashSet<>();
    for (String range : asked.split(",", -1)) {
      chosen.addAll(range(range, most));
    }
    return chosen.stream().sorted().toList();
  }

  /** A number, or {@code FROM-TO:STEP}. */
  private static List<Integer> range(String text, int most) {
    String[] parts = text.split("[-:]", -1);
    boolean isRange = text.matches("\\d+-\\d+:\\d+");
    if (!isRange && !text.matches("\\d+")) {
      throw new UsageException("--sizes %s is no number and no FROM-TO:STEP".formatted(text));
    }
    int from = size(parts[0], most);
    int to = isRange ? size(parts[1], most) : from;
    long step = isRange ? Long.parseLong(parts[2]) : 1;
    if (step < 1 || to < from) {
      throw new UsageException("--sizes %s has no numbers in it".formatted(text));
    }
    List<Integer> sizes = new ArrayList<>();
    for (long n = from; n <= to; n += step) {
      sizes.add((int) n);
    }
    return sizes;
  }

  private static int size(String digits, int most) {
    long n = digits.length() > 10 ? Long.MAX_VALUE : Long.parseLong(digits);
    if (n < FEWEST || n > most) {
      throw new UsageException("--sizes %s is not from %d to %d".formatted(digits, FEWEST, most));
    }
    return (int) n;
  }
}
