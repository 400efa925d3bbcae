package dct.experiment.study;

import dct.core.Progress;
import dct.io.AtomicFile;
import dct.io.CannotWriteException;
import dct.io.FileLease;
import dct.io.text.BadInputException;
import java.io.Closeable;
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
 * computed, so that a run that is broken off loses nothing, and two runs cannot write at once; at
 * the end the file is put into the study's order, whole or not at all. Rows of other trials, of
 * another seed for instance, are kept behind it.
 */
public final class StudyFile implements Closeable {
  private final Path file;
  private final StudyCsv csv;
  private final Map<Trial, StudyRow> rows = new LinkedHashMap<>();

  private final Closeable lease;

  private StudyFile(Path file, StudyCsv csv, Closeable lease) {
    this.file = file;
    this.csv = csv;
    this.lease = lease;
  }

  /**
   * Opens a file, or begins one; a last line that was broken off is taken away. Until it is closed,
   * nobody else can open it.
   *
   * @throws BadInputException if what is there are no rows of this study; nothing is changed then
   * @throws CannotWriteException if it cannot be written, or another run has opened it
   */
  public static StudyFile open(Path file, Study study, boolean times) throws IOException {
    Closeable lease = FileLease.beside(file);
    StudyFile opened = new StudyFile(file, new StudyCsv(study, times), lease);
    boolean begun = false;
    try {
      opened.begin();
      begun = true;
      return opened;
    } finally {
      if (!begun) {
        lease.close();
      }
    }
  }

  private void begin() throws IOException {
    List<String> records = StudyCsv.records(read());
    String rest = records.remove(records.size() - 1);
    take(records, rest);
    if (records.isEmpty()) {
      write(csv.head());
    } else if (!rest.isEmpty()) {
      write(String.join("", records));
    }
  }

  /** Lets others open the file. */
  @Override
  public void close() throws IOException {
    lease.close();
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

  private void take(List<String> records, String rest) {
    boolean isMine =
        records.isEmpty()
            ? csv.head().startsWith(rest)
            : csv.head().equals(records.get(0).stripTrailing() + "\n");
    if (!isMine) {
      throw new BadInputException(
          file.toString(),
          1,
          "these are not the columns of this study; name another file, or delete this one");
    }
    int line = 1;
    for (String record : records) {
      if (line > 1) {
        StudyRow row = csv.row(file.toString(), line, record.replaceFirst("\r?\n$", ""));
        rows.put(row.trial(), row);
      }
      line += (int) record.chars().filter(c -> c == '\n').count();
    }
    if (rest.indexOf('\n') >= 0) { // a quotation mark has no second one, or its row is broken off
      throw StudyCsv.damaged(file.toString(), line);
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
    AtomicFile.write(file, Progress.NONE, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
  }
}
