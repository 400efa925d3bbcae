package dct.experiment.study;

import dct.io.AtomicFile;
import dct.io.BadInputException;
import dct.io.CannotWriteException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * A file of comma-separated values that keeps the rows of a study.
 *
 * <p>Rows that are there already are read and stay there. New rows are appended when they are
 * computed, so that a run that is broken off loses nothing; at the end the file is put into the
 * study's order, whole or not at all. Rows of other trials, of another seed for instance, are kept
 * behind it.
 */
public final class StudyFile {
  private final Path file;
  private final StudyCsv csv;
  private final Map<Trial, StudyRow> rows = new LinkedHashMap<>();

  private StudyFile(Path file, StudyCsv csv) {
    this.file = file;
    this.csv = csv;
  }

  /**
   * Opens a file, or begins one; a last line that was broken off is taken away.
   *
   * @throws BadInputException if what is there are no rows of this study; nothing is changed then
   * @throws CannotWriteException if it cannot be written
   */
  public static StudyFile open(Path file, Study study, boolean times) throws IOException {
    StudyFile opened = new StudyFile(file, new StudyCsv(study, times));
    String text = opened.read();
    String whole = text.substring(0, text.lastIndexOf('\n') + 1);
    opened.take(whole);
    if (whole.isEmpty() || !whole.equals(text)) {
      opened.write(whole.isEmpty() ? opened.csv.head() : whole);
    }
    return opened;
  }

  private String read() throws IOException {
    try {
      return Files.readString(file);
    } catch (NoSuchFileException e) {
      return "";
    } catch (IOException e) {
      throw new BadInputException(
          file.toString(), 0, "the file cannot be read as text; name another for the study");
    }
  }

  private void take(String text) {
    List<String> lines = text.lines().toList();
    if (!lines.isEmpty() && !csv.head().equals(lines.get(0) + "\n")) {
      throw new BadInputException(
          file.toString(),
          1,
          "these are not the columns of this study; name another file, or delete this one");
    }
    for (int i = 1; i < lines.size(); i++) {
      StudyRow row = csv.row(file.toString(), i + 1, lines.get(i));
      rows.put(row.trial(), row);
    }
  }

  /** The rows that are there, in the file's order. */
  public List<StudyRow> rows() {
    return List.copyOf(rows.values());
  }

  /**
   * Appends a row.
   *
   * @throws CannotWriteException if that failed
   */
  public void add(StudyRow row) throws CannotWriteException {
    rows.put(row.trial(), row);
    try {
      Files.writeString(file, csv.line(row), StandardOpenOption.APPEND);
    } catch (IOException e) {
      throw new CannotWriteException(file.toString(), e.getMessage(), e);
    }
  }

  /**
   * Puts the rows of these trials in front, in this order.
   *
   * @throws CannotWriteException if that failed; nothing is changed then
   */
  public void sort(List<Trial> trials) throws CannotWriteException {
    List<StudyRow> sorted = new ArrayList<>();
    trials.stream().filter(rows::containsKey).map(rows::get).forEach(sorted::add);
    Set<Trial> mine = new HashSet<>(trials);
    rows.values().stream().filter(row -> !mine.contains(row.trial())).forEach(sorted::add);
    write(csv.text(sorted));
  }

  private void write(String text) throws CannotWriteException {
    AtomicFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
  }
}
