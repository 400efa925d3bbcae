package dct.cli;

import dct.render.Figure;
import dct.render.Figure.Size;
import dct.render.Labels;
import dct.render.Theme;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Model.OptionSpec;

/** How the pictures among the outputs of a verb look. */
final class PictureParameters {
  private static final List<String> LABELS = List.of("numbers", "degrees", "coordinates");
  private static final List<String> THEMES = List.of("light", "dark", "print");

  private final OptionSpec size;
  private final OptionSpec scale;
  private final OptionSpec crop;
  private final OptionSpec noCrop;
  private final OptionSpec labels;
  private final OptionSpec noCounts;
  private final OptionSpec legend;
  private final OptionSpec up;
  private final OptionSpec down;
  private final OptionSpec theme;
  private final OptionSpec standalone;

  /** Declares them. */
  PictureParameters(Verb verb) {
    size =
        verb.option(
            "--size",
            "W",
            String.class,
            "How wide pictures are: 84mm (default, a column; letters of 7 to 9 pt, lines of 0.4"
                + " pt), or 600px (letters and lines as on a screen).");
    scale =
        verb.option(
            "--scale",
            "K",
            Integer.class,
            "How fine a PNG is, 1 (default) to 4: K times 300 dots an inch, or K times as many"
                + " pixels.");
    crop = verb.flag("--crop", "Let pictures end at the drawing, with a margin (default).");
    noCrop = verb.flag("--no-crop", "Give pictures the shape of a canvas, 10 by 7.");
    labels =
        verb.option(
            "--labels",
            "L",
            LABELS,
            "What to write beside the vertices: some of numbers, degrees, coordinates, with commas"
                + " between.");
    noCounts = verb.flag("--no-counts", "Leave the counts out of pictures.");
    legend = verb.flag("--legend", "Say in pictures what the colours and shapes stand for.");
    up = verb.flag("--y-up", "Let y run upwards in pictures: the default for foreign formats.");
    down = verb.flag("--y-down", "Let y run downwards in pictures: the default otherwise.");
    theme =
        verb.option(
            "--theme",
            "light|dark|print",
            THEMES,
            "The colours of pictures: light (default), dark, or print, which survives grey.");
    standalone =
        verb.flag(
            "--standalone", "Make .tex a document of its own, instead of a part for \\input.");
  }

  /**
   * Sees that the options are usable, before anything is read.
   *
   * @throws UsageException if an option is none, or two exclude each other
   */
  void check() {
    figure(false).size();
  }

  /**
   * The figure asked for.
   *
   * @param isUp whether y runs upwards if nothing is said
   * @throws UsageException if an option is none, or two exclude each other
   */
  Figure figure(boolean isUp) {
    exclude(crop, noCrop);
    exclude(up, down);
    boolean yUp = Verb.isSet(up) || (isUp && !Verb.isSet(down));
    return new Figure(
        size(),
        scale(),
        !Verb.isSet(noCrop),
        labels(),
        !Verb.isSet(noCounts),
        Verb.isSet(legend),
        yUp,
        theme(),
        Verb.isSet(standalone));
  }

  private static void exclude(OptionSpec one, OptionSpec other) {
    if (Verb.isSet(one) && Verb.isSet(other)) {
      throw new UsageException(
          one.longestName() + " and " + other.longestName() + " exclude each other, leave one out");
    }
  }

  private Size size() {
    String typed = size.getValue();
    if (typed == null) {
      return Size.COLUMN;
    }
    try {
      return Size.parse(typed);
    } catch (IllegalArgumentException e) {
      throw new UsageException("--size: " + e.getMessage());
    }
  }

  private int scale() {
    Integer typed = scale.getValue();
    if (typed != null && (typed < 1 || typed > Figure.LARGEST_SCALE)) {
      throw new UsageException(
          "--scale: " + typed + " is out of range; take from 1 to " + Figure.LARGEST_SCALE);
    }
    return typed == null ? 1 : typed;
  }

  private Labels labels() {
    String typed = labels.getValue();
    if (typed == null) {
      return Labels.NONE;
    }
    List<String> words = Arrays.asList(typed.split(",", -1));
    for (String word : words) {
      if (!LABELS.contains(word)) {
        throw UsageException.unknown("--labels", word, LABELS);
      }
    }
    return new Labels(
        words.contains("numbers"), words.contains("degrees"), words.contains("coordinates"));
  }

  private Theme theme() {
    String typed = theme.getValue();
    if (typed == null) {
      return Theme.LIGHT;
    }
    if (!THEMES.contains(typed)) {
      throw UsageException.unknown("--theme", typed, THEMES);
    }
    return Theme.valueOf(typed.toUpperCase(Locale.ROOT));
  }
}
