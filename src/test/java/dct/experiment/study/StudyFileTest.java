package dct.experiment.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.io.CannotWriteException;
import dct.io.text.BadInputException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class StudyFileTest {
  private static final Study STUDY =
      new PointsStudy(new StudyPlan(List.of("uniform"), List.of(10, 20), 3, 1));
  private static List<StudyRow> rows;

  @TempDir Path folder;
  private Path file;
  private StudyFile last;

  // Not in an initializer: its threads would wait for the class whose lambda they call.
  @BeforeAll
  static void run() {
    rows = StudyRun.run(STUDY, List.of(), 1, row -> {}, Progress.NONE);
  }

  @BeforeEach
  void name() {
    file = folder.resolve("rows.csv");
  }

  /** Opens the file in a second run: the one before is over. */
  private StudyFile open() throws IOException {
    return open(false);
  }

  private StudyFile open(boolean times) throws IOException {
    close();
    last = StudyFile.open(file, STUDY, times);
    return last;
  }

  @AfterEach
  void close() throws IOException {
    if (last != null) {
      last.close();
    }
  }

  @Test
  void rows_are_on_the_disk_as_soon_as_they_are_added() throws IOException {
    StudyFile opened = open();
    for (int i = 0; i < rows.size(); i++) {
      opened.add(rows.get(i));
      assertThat(Files.readAllLines(file)).hasSize(2 + i);
      assertThat(trials(open().rows())).isEqualTo(trials(rows.subList(0, i + 1)));
    }
  }

  @Test
  void rows_in_any_order_end_in_the_order_of_the_study() throws IOException {
    List<StudyRow> shuffled = new ArrayList<>(rows);
    Collections.rotate(shuffled, 2);
    StudyFile opened = open();
    for (StudyRow row : shuffled) {
      opened.add(row);
    }
    opened.sort(STUDY.trials());
    assertThat(file).hasContent(new StudyCsv(STUDY, false).text(rows));
  }

  @Test
  void a_line_that_was_broken_off_is_taken_away() throws IOException {
    String whole = new StudyCsv(STUDY, false).text(rows);
    for (int cut = 1; cut < whole.length(); cut += 7) {
      Files.writeString(file, whole.substring(0, whole.length() - cut));
      StudyFile opened = open();
      List<StudyRow> left = opened.rows();
      assertThat(trials(left)).as("cut %d", cut).isEqualTo(trials(rows.subList(0, left.size())));
      for (StudyRow row : rows.subList(left.size(), rows.size())) {
        opened.add(row);
      }
      assertThat(Files.readString(file)).as("cut %d", cut).isEqualTo(whole);
    }
  }

  @Test
  void rows_of_other_trials_stay_behind() throws IOException {
    StudyRow other =
        new StudyRow(new Trial("uniform", 10, 1, 99), rows.get(0).counts(), rows.get(0).millis());
    StudyFile opened = open();
    opened.add(other);
    opened.add(rows.get(1));
    opened.sort(STUDY.trials());
    assertThat(trials(open().rows())).containsExactly(rows.get(1).trial(), other.trial());
  }

  @Test
  void times_are_read_back() throws IOException {
    StudyFile opened = open(true);
    opened.add(rows.get(0));
    StudyRow back = open(true).rows().get(0);
    assertThat(back.counts()).isEqualTo(rows.get(0).counts());
    assertThat(back.millis()).containsOnlyKeys("delaunay", "scan_flip", "repeated", "best");
  }

  @Test
  void names_with_commas_and_quotes_are_read_back() throws IOException {
    Trial named = new Trial("a \"b\", c.txt", 10, 1, 0);
    open().add(new StudyRow(named, rows.get(0).counts(), rows.get(0).millis()));
    assertThat(trials(open().rows())).containsExactly(named);
  }

  @Test
  void names_with_line_breaks_are_read_back() throws IOException {
    Trial named = new Trial("a\n\"b\"\r\nc.txt", 10, 1, 0);
    StudyFile opened = open();
    opened.add(new StudyRow(named, rows.get(0).counts(), rows.get(0).millis()));
    opened.add(rows.get(1));
    opened.sort(List.of(rows.get(1).trial(), named));
    assertThat(trials(open().rows())).containsExactly(rows.get(1).trial(), named);
    String text = Files.readString(file);
    Files.writeString(file, text.replace("c.txt\"", "c.txt"));
    assertThatThrownBy(this::open)
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining(":3: ");
  }

  @Test
  void two_runs_cannot_write_at_once() throws IOException {
    StudyFile opened = open();
    opened.add(rows.get(0));
    String text = Files.readString(file);
    assertThatThrownBy(() -> StudyFile.open(file, STUDY, false))
        .isInstanceOf(CannotWriteException.class)
        .hasMessageContaining("another run of the program is writing to it");
    assertThat(file).hasContent(text);
    Path link = Files.createSymbolicLink(folder.resolve("link.csv"), file);
    assertThatThrownBy(() -> StudyFile.open(link, STUDY, false))
        .as("under another name")
        .isInstanceOf(CannotWriteException.class);
    assertThat(open().rows()).as("after the first").hasSize(1);
    close();
    assertThat(folder).isDirectoryNotContaining("glob:**/.*");
  }

  @Test
  void a_run_that_was_killed_does_not_keep_the_next_one_out() throws IOException {
    Files.createFile(folder.resolve(".rows.csv.lock"));
    assertThat(open().rows()).isEmpty();
  }

  @Test
  void what_is_no_study_is_refused_and_left_alone() throws IOException {
    requireRefused("x,y\n1,2\n", 1, "these are not the columns of this study");
    requireRefused("no line end", 1, "these are not the columns of this study");
    String head = new StudyCsv(STUDY, false).head();
    requireRefused(head + "uniform,10,1,5\n", 2, "this is no row of the study");
    requireRefused(
        new StudyCsv(STUDY, false).text(rows).replace(",10,", ",ten,"),
        2,
        "this is no row of the study");
    requireRefused(
        new StudyCsv(STUDY, true).text(rows), 1, "these are not the columns of this study");
  }

  private void requireRefused(String text, int line, String fault) throws IOException {
    Files.writeString(file, text);
    assertThatThrownBy(this::open)
        .isInstanceOf(BadInputException.class)
        .hasMessageStartingWith(file + ":" + line + ": " + fault);
    assertThat(file).hasContent(text);
  }

  @Test
  void a_folder_that_is_not_there_is_named() {
    file = folder.resolve("none").resolve("rows.csv");
    assertThatThrownBy(this::open)
        .isInstanceOf(CannotWriteException.class)
        .hasMessageContaining("its folder does not exist");
  }

  private static List<Trial> trials(List<StudyRow> some) {
    return some.stream().map(StudyRow::trial).toList();
  }
}
