package dct.experiment.study;

import dct.core.Progress;
import dct.io.AtomicFile;
import dct.io.CannotWriteException;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import dct.render.chart.Chart;
import dct.render.chart.ChartFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Writes what came out of a study to files.
 *
 * @param study the study
 * @param rows its rows
 * @param times whether rows are written with their times
 */
public record StudyExport(Study study, List<StudyRow> rows, boolean times) {

  private static final Content[] CONTENTS = {Content.ROWS, Content.TABLES, Content.CHART};

  /** The ending of a file's name, if something of a study can be written to it. */
  public static Optional<FileEnding> ending(String name) {
    return FileEnding.of(name, CONTENTS);
  }

  /** The endings of all files of a study, for messages. */
  public static String endings() {
    return FileEnding.list(CONTENTS);
  }

  /**
   * Writes the file in the format of its ending, whole or not at all.
   *
   * @param chartWord which chart, if it is one
   * @throws IllegalArgumentException if the ending is no format
   * @throws CannotWriteException if writing failed; nothing is changed then
   */
  public void write(Path file, String chartWord) throws CannotWriteException {
    switch (FileEnding.require(file, CONTENTS)) {
      case CSV -> text(file, csv());
      case MD -> text(file, MarkdownText.of(study.tables(rows)));
      case TEX -> text(file, LatexText.of(study.tables(rows)));
      default -> ChartFile.write(chart(chartWord), file);
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
    AtomicFile.write(file, Progress.NONE, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
  }
}
