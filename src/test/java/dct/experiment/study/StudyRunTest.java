package dct.experiment.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

class StudyRunTest {
  private static final Study STUDY =
      new PointsStudy(new StudyPlan(List.of("uniform"), List.of(10, 30, 60, 90), 6, 7));

  /** Cancels once this many rows were reported. */
  private static final class CancelAfter implements Progress {
    private final int rows;
    private final AtomicInteger reported = new AtomicInteger();

    CancelAfter(int rows) {
      this.rows = rows;
    }

    @Override
    public void report(double fraction, String message) {
      reported.incrementAndGet();
    }

    @Override
    public boolean isCancelled() {
      return reported.get() >= rows;
    }
  }

  private static String csv(List<StudyRow> rows) {
    return new StudyCsv(STUDY, false).text(rows);
  }

  private static List<StudyRow> whole(int threads) {
    return StudyRun.run(STUDY, List.of(), threads, row -> {}, Progress.NONE);
  }

  @Test
  void the_rows_are_the_same_on_any_number_of_threads() {
    String one = csv(whole(1));
    assertThat(one.lines()).hasSize(1 + 24);
    assertThat(csv(whole(2))).isEqualTo(one);
    assertThat(csv(whole(7))).isEqualTo(one);
  }

  @Test
  void another_seed_gives_other_rows() {
    Study other = new PointsStudy(new StudyPlan(List.of("uniform"), List.of(60), 6, 8));
    List<StudyRow> rows = StudyRun.run(other, List.of(), 2, row -> {}, Progress.NONE);
    assertThat(rows).hasSize(6).doesNotContainAnyElementsOf(whole(2));
  }

  @Test
  void what_was_done_before_a_cancel_is_kept_and_not_done_again() {
    List<StudyRow> first = Collections.synchronizedList(new ArrayList<>());
    List<StudyRow> partial = StudyRun.run(STUDY, List.of(), 3, first::add, new CancelAfter(5));
    assertThat(partial).hasSizeBetween(5, 7).containsExactlyInAnyOrderElementsOf(first);

    List<StudyRow> second = Collections.synchronizedList(new ArrayList<>());
    List<StudyRow> rows = StudyRun.run(STUDY, partial, 2, second::add, Progress.NONE);
    assertThat(second).hasSize(24 - partial.size());
    assertThat(trials(second)).doesNotContainAnyElementsOf(trials(first));
    assertThat(csv(rows)).isEqualTo(csv(whole(1)));
  }

  @Test
  void a_cancel_before_the_start_gives_nothing() {
    assertThat(StudyRun.run(STUDY, List.of(), 2, row -> {}, new CancelAfter(0))).isEmpty();
  }

  @Test
  void the_progress_rises_to_one() {
    List<Double> fractions = new ArrayList<>();
    Progress progress =
        new Progress() {
          @Override
          public void report(double fraction, String message) {
            fractions.add(fraction);
          }

          @Override
          public boolean isCancelled() {
            return false;
          }
        };
    StudyRun.run(STUDY, List.of(), 2, row -> {}, progress);
    assertThat(fractions).hasSize(24).isSorted().last().isEqualTo(1.0);
  }

  @Test
  void a_failure_ends_the_run() {
    assertThatThrownBy(
            () ->
                StudyRun.run(
                    STUDY,
                    List.of(),
                    2,
                    row -> {
                      throw new IllegalStateException("full");
                    },
                    Progress.NONE))
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("full");
  }

  private static List<Trial> trials(List<StudyRow> rows) {
    return rows.stream().map(StudyRow::trial).toList();
  }
}
