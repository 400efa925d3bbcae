package dct.cli;

import dct.experiment.study.Study;
import dct.experiment.study.StudyExport;
import dct.experiment.study.StudyFile;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import picocli.CommandLine.Model.OptionSpec;

/** Where a study goes. */
final class StudyOutputs {
  private final Verb verb;
  private final OptionSpec output;
  private final OptionSpec chart;

  /** Declares them. */
  StudyOutputs(Verb verb) {
    this.verb = verb;
    output =
        verb.outputs(
            false,
            "Where to: "
                + FileEnding.list(Content.ROWS)
                + " the rows; "
                + FileEnding.list(Content.TABLES)
                + " the tables; "
                + FileEnding.list(Content.CHART)
                + " a chart; - is the rows on standard output. May repeat.");
    chart =
        verb.option(
            "--chart",
            "C",
            List.of("sizes", "increase", "shapes", "pieces", "reflex", "holes"),
            "Which chart: for points sizes (default), increase or shapes; for polygons shapes"
                + " (default), sizes, pieces or reflex; for annuli sizes (default) or holes.");
  }

  private List<String> names() {
    List<String> names = output.getValue();
    return Objects.requireNonNullElse(names, List.of());
  }

  /**
   * Sees that all can be written for this study.
   *
   * @throws UsageException if an ending is no format, or there is no such chart
   */
  void check(Study study) {
    for (String name : names()) {
      if (!name.equals(Verb.STANDARD_STREAM) && StudyExport.ending(name).isEmpty()) {
        throw new UsageException(
            String.format(
                Locale.ROOT,
                "the ending of %s is no format of a study, use %s",
                name,
                StudyExport.endings()));
      }
    }
    List<String> words = study.chartWords();
    if (!words.contains(chartWord(study))) {
      throw UsageException.unknown("--chart", chartWord(study), words);
    }
  }

  private String chartWord(Study study) {
    String asked = chart.getValue();
    return asked == null ? study.chartWords().get(0) : asked;
  }

  /** Whether standard output is taken by the rows. */
  boolean printRows() {
    return names().contains(Verb.STANDARD_STREAM);
  }

  /** The file that keeps the rows: the first one of that format. */
  Optional<String> rowFile() {
    return names().stream()
        .filter(name -> FileEnding.of(name, Content.ROWS).isPresent())
        .findFirst();
  }

  /** Opens the file that keeps the rows. */
  Optional<StudyFile> open(Study study, boolean times) throws IOException {
    Optional<String> name = rowFile();
    return name.isPresent()
        ? Optional.of(StudyFile.open(InputParameters.path(name.get()), study, times))
        : Optional.empty();
  }

  /** Writes everything but the file that keeps the rows. */
  void write(StudyExport export) throws IOException {
    Optional<String> kept = rowFile();
    for (String name : names()) {
      if (name.equals(Verb.STANDARD_STREAM)) {
        print(export.csv());
      } else if (kept.filter(name::equals).isEmpty()) {
        export.write(InputParameters.path(name), chartWord(export.study()));
      }
    }
  }

  /** Prints a text on standard output as it is. */
  void print(String text) throws IOException {
    verb.console().out().write(text.getBytes(StandardCharsets.UTF_8));
    verb.console().out().flush();
  }
}
