package dct.experiment.study;

import dct.io.AtomicFile;
import dct.io.CannotWriteException;
import dct.render.chart.Chart;
import dct.render.chart.ChartFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Writes what came out of a study to files.
 *
 * @param study the study
 * @param rows its rows
 * @param times whether rows are written with their times
 */
public record StudyExport(Study study, List<StudyRow> rows, boolean times) {

  /** The formats, each chosen by the ending of the same name. */
  public enum Format {
    /** The rows. */
    CSV,
    /** The tables in Markdown. */
    MD,
    /** The tables in LaTeX. */
    TEX,
    /** A chart as shapes. */
    SVG,
    /** A chart as pixels. */
    PNG,
    /** A chart as a page. */
    PDF;

    /** The format that a file's ending asks for, or nothing for another ending. */
    public static Optional<Format> of(String name) {
      String lower = name.toLowerCase(Locale.ROOT);
      return Arrays.stream(values())
          .filter(format -> lower.endsWith("." + format.name().toLowerCase(Locale.ROOT)))
          .findFirst();
    }
  }

  /**
   * Writes the file in the format of its ending, whole or not at all.
   *
   * @param chartWord which chart, if it is one
   * @throws IllegalArgumentException if the ending is no format
   * @throws CannotWriteException if writing failed; nothing is changed then
   */
  public void write(Path file, String chartWord) throws CannotWriteException {
    Format format =
        Format.of(file.toString())
            .orElseThrow(() -> new IllegalArgumentException(file + " has no ending of a study"));
    switch (format) {
      case CSV -> text(file, csv());
      case MD -> text(file, MarkdownText.of(study.tables(rows)));
      case TEX -> text(file, LatexText.of(study.tables(rows)));
      case SVG, PNG, PDF -> ChartFile.write(chart(chartWord), file);
    }
  }

  /** The rows as comma-separated values. */
  public String csv() {
    return new StudyCsv(study, times).text(rows);
  }

  /** The chart of this word, one of the study's. */
  public Chart chart(String word) {
    return study.charts(rows).get(study.chartWords().indexOf(word));
  }

  private static void text(Path file, String text) throws CannotWriteException {
    AtomicFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
  }
}
