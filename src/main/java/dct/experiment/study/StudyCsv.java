package dct.experiment.study;

import dct.io.text.BadInputException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The rows of a study as comma-separated values: a head of names, then a line for each trial, each
 * ended by a line feed.
 */
public final class StudyCsv {
  private static final List<String> TRIAL = List.of("shape", "n", "set", "seed");

  private final List<String> counts;
  private final List<String> steps;

  /** The form for this study, its times left out or not. */
  public StudyCsv(Study study, boolean times) {
    counts = study.counts();
    steps = times ? study.steps() : List.of();
  }

  /** The whole text of these rows. */
  public String text(List<StudyRow> rows) {
    return head() + rows.stream().map(this::line).collect(Collectors.joining());
  }

  /** The line of names. */
  String head() {
    Stream<String> millis = steps.stream().map(step -> step + "_ms");
    return Stream.of(TRIAL.stream(), counts.stream(), millis)
            .flatMap(names -> names)
            .collect(Collectors.joining(","))
        + "\n";
  }

  /** The line of a row. */
  String line(StudyRow row) {
    Trial trial = row.trial();
    StringBuilder line = new StringBuilder(quoted(trial.shape()));
    line.append(',').append(trial.n()).append(',').append(trial.set());
    line.append(',').append(trial.seed());
    counts.forEach(name -> line.append(',').append(row.count(name)));
    steps.forEach(step -> line.append(String.format(Locale.ROOT, ",%.3f", row.millis().get(step))));
    return line.append('\n').toString();
  }

  private static String quoted(String text) {
    boolean plain = text.chars().noneMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
    return plain ? text : '"' + text.replace("\"", "\"\"") + '"';
  }

  /**
   * Reads a row back.
   *
   * @param file the file's name, for the message
   * @throws BadInputException if the line is none of this study
   */
  StudyRow row(String file, int number, String line) {
    List<String> cells = cells(line);
    if (cells.size() != TRIAL.size() + counts.size() + steps.size()) {
      throw damaged(file, number);
    }
    try {
      return row(cells);
    } catch (NumberFormatException e) {
      throw damaged(file, number);
    }
  }

  private StudyRow row(List<String> cells) {
    Trial trial =
        new Trial(
            cells.get(0),
            Integer.parseInt(cells.get(1)),
            Integer.parseInt(cells.get(2)),
            Long.parseLong(cells.get(3)));
    Map<String, Integer> numbers = new LinkedHashMap<>();
    for (int c = 0; c < counts.size(); c++) {
      numbers.put(counts.get(c), Integer.parseInt(cells.get(TRIAL.size() + c)));
    }
    Map<String, Double> millis = new LinkedHashMap<>();
    for (int s = 0; s < steps.size(); s++) {
      millis.put(steps.get(s), Double.valueOf(cells.get(TRIAL.size() + counts.size() + s)));
    }
    return new StudyRow(trial, numbers, millis);
  }

  static BadInputException damaged(String file, int number) {
    return new BadInputException(
        file, number, "this is no row of the study; delete the line, and it is computed again");
  }

  /** The records of a text, quoted line breaks in them, and last what follows behind them. */
  static List<String> records(String text) {
    List<String> records = new ArrayList<>();
    boolean quoted = false;
    int start = 0;
    for (int i = 0; i < text.length(); i++) {
      quoted ^= text.charAt(i) == '"';
      if (text.charAt(i) == '\n' && !quoted) {
        records.add(text.substring(start, i + 1));
        start = i + 1;
      }
    }
    records.add(text.substring(start));
    return records;
  }

  private static List<String> cells(String line) {
    List<String> cells = new ArrayList<>();
    StringBuilder cell = new StringBuilder();
    boolean quoted = false;
    for (int i = 0; i < line.length(); i++) {
      char c = line.charAt(i);
      if (c == '"' && quoted && i + 1 < line.length() && line.charAt(i + 1) == '"') {
        cell.append(line.charAt(++i));
      } else if (c == '"') {
        quoted = !quoted;
      } else if (c == ',' && !quoted) {
        cells.add(cell.toString());
        cell.setLength(0);
      } else {
        cell.append(c);
      }
    }
    cells.add(cell.toString());
    return cells;
  }
}
