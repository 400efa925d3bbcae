package dct.experiment.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dct.core.Progress;
import dct.core.degree.DegreeCount;
import dct.core.degree.FlipResult;
import dct.core.degree.ScanFlip;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.experiment.generate.RandomSites;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

class PointsStudyTest {
  private static final Study STUDY =
      new PointsStudy(
          new StudyPlan(List.of(ThesisTable.SHAPE), ThesisTable.sizes(), ThesisTable.SETS, 1));
  private static List<StudyRow> rows;

  // Not in an initializer: its threads would wait for the class whose lambda they call.
  @BeforeAll
  static void run() {
    rows = StudyRun.run(STUDY, List.of(), 2, row -> {}, Progress.NONE);
  }

  @Test
  void the_means_are_those_of_the_thesis() {
    assertThat(rows).hasSize(50);
    assertThat(mean(row -> row.percent(PointsColumns.BEFORE))).isCloseTo(49, within(2.0));
    assertThat(mean(row -> row.percent(PointsColumns.AFTER))).isCloseTo(78.5, within(1.5));
  }

  @Test
  void the_printed_table_has_the_figures_of_the_thesis() {
    List<ThesisTable.Row> printed = ThesisTable.read().rows();
    assertThat(printed).hasSize(50);
    assertThat(printed.stream().map(ThesisTable.Row::n).distinct()).isEqualTo(ThesisTable.sizes());
    double increase =
        printed.stream().mapToDouble(ThesisTable.Row::increase).average().orElseThrow();
    assertThat(increase).isCloseTo(59.5, within(0.05));
    Table table = STUDY.tables(rows).get(0);
    assertThat(table.rows()).hasSize(50);
    assertThat(String.join(" ", table.rows().get(0))).contains("24 12 26 38 46.15");
  }

  @Test
  void each_row_is_what_its_seed_makes() {
    for (StudyRow row : rows) {
      Trial trial = row.trial();
      Sites sites = Sites.of(RandomSites.uniform(trial.n(), trial.seed()), Progress.NONE);
      FlipResult flips = ScanFlip.run(Delaunay.triangulate(sites, Progress.NONE), Progress.NONE);
      assertThat(row.count(PointsColumns.BEFORE)).isEqualTo(DegreeCount.of(flips.before()).even());
      assertThat(row.count(PointsColumns.AFTER)).isEqualTo(DegreeCount.of(flips.after()).even());
    }
  }

  @Test
  void each_step_is_no_worse_than_the_one_before() {
    for (StudyRow row : rows) {
      assertThat(
              List.of(
                  row.count(PointsColumns.BEFORE),
                  row.count(PointsColumns.AFTER),
                  row.count(PointsColumns.REPEATED),
                  row.count(StudyRow.BEST),
                  row.count(StudyRow.LIMIT),
                  row.trial().n()))
          .as("%s", row)
          .isSorted();
      assertThat(row.count(PointsColumns.AFTER) - row.count(PointsColumns.BEFORE))
          .isBetween(2 * row.count(PointsColumns.FLIPS), 4 * row.count(PointsColumns.FLIPS));
    }
  }

  @Test
  void the_means_for_each_size_are_in_the_second_table() {
    Table means = STUDY.tables(rows).get(1);
    assertThat(means.rows()).hasSize(ThesisTable.sizes().size() + 1);
    assertThat(means.rows().get(0)).contains("55.20 ± 8.16 (6.57)"); // the thesis's five of 50
    assertThat(STUDY.tables(rows).get(2).rows()).as("times").hasSize(10);
    List<StudyRow> timeless = rows.stream().map(StudyRow::withoutTimes).toList();
    assertThat(STUDY.tables(timeless).get(2).rows()).isEmpty();
  }

  private static double mean(ToDoubleFunction<StudyRow> value) {
    return rows.stream().mapToDouble(value).average().orElseThrow();
  }
}
