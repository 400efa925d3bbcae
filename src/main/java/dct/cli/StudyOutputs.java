package dct.cli;

import dct.experiment.study.LatexText;
import dct.experiment.study.MarkdownText;
import dct.experiment.study.Study;
import dct.experiment.study.StudyCsv;
import dct.experiment.study.StudyFile;
import dct.experiment.study.StudyRow;
import dct.io.AtomicFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import picocli.CommandLine.Model.OptionSpec;

/** Where a study goes. */
final class StudyOutputs {

  /** The formats, chosen by the ending of a file's name. */
  private enum Format {
    CSV,
    MD,
    TEX;

    /** The format for a file of this name; a single hyphen is rows on standard output. */
    static Format of(String name) {
      String lower = name.toLowerCase(Locale.ROOT);
      for (Format format : values()) {
        if (lower.endsWith("." + format.name().toLowerCase(Locale.ROOT))) {
          return format;
        }
      }
      if (name.equals(Verb.STANDARD_STREAM)) {
        return CSV;
      }
      throw new UsageException(
          "the ending of " + name + " is no format of a study, use .csv, .md or .tex");
    }
  }

  private final Verb verb;
  private final OptionSpec output;

  /** Declares them. */
  StudyOutputs(Verb verb) {
    this.verb = verb;
    output =
        verb.outputs(
            false,
            "Where to: .csv the rows, .md or .tex the tables; - is the rows on standard output."
                + " May repeat.");
  }

  private List<String> names() {
    List<String> names = output.getValue();
    return Objects.requireNonNullElse(names, List.of());
  }

  /**
   * Sees that all can be written for this study.
   *
   * @throws UsageException if an ending is no format
   */
  void check(Study study) {
    names().forEach(Format::of);
  }

  /** Whether standard output is taken by the rows. */
  boolean printRows() {
    return names().contains(Verb.STANDARD_STREAM);
  }

  /** Whether there is a file that keeps the rows. */
  boolean hasFile() {
    return fileName().isPresent();
  }

  private Optional<String> fileName() {
    return names().stream()
        .filter(name -> !name.equals(Verb.STANDARD_STREAM) && Format.of(name) == Format.CSV)
        .findFirst();
  }

  /** Opens the file that keeps the rows: the first one of that format. */
  Optional<StudyFile> open(Study study, boolean times) throws IOException {
    Optional<String> name = fileName();
    return name.isPresent()
        ? Optional.of(StudyFile.open(InputParameters.path(name.get()), study, times))
        : Optional.empty();
  }

  /** Writes everything but the file that keeps the rows. */
  void write(Study study, List<StudyRow> rows, boolean times) throws IOException {
    for (String name : names()) {
      if (name.equals(Verb.STANDARD_STREAM)) {
        verb.console().out().write(bytes(new StudyCsv(study, times).text(rows)));
        verb.console().out().flush();
      } else if (!fileName().filter(name::equals).isPresent()) {
        write(study, rows, times, name);
      }
    }
  }

  private void write(Study study, List<StudyRow> rows, boolean times, String name)
      throws IOException {
    Path file = InputParameters.path(name);
    switch (Format.of(name)) {
      case CSV -> text(file, new StudyCsv(study, times).text(rows));
      case MD -> text(file, MarkdownText.of(study.tables(rows)));
      case TEX -> text(file, LatexText.of(study.tables(rows)));
    }
  }

  private void text(Path file, String text) throws IOException {
    AtomicFile.write(file, out -> out.write(bytes(text)));
  }

  /** A text as it is printed and written. */
  byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }
}
