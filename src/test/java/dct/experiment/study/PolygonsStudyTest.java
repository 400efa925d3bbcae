package dct.experiment.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.experiment.generate.PolygonShape;
import dct.problem.Instance;
import dct.problem.Method;
import dct.render.chart.Chart;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

class PolygonsStudyTest {
  private static final List<String> SHAPES =
      Arrays.stream(PolygonShape.values()).map(PolygonShape::word).toList();
  private static final String PENTAGON = "dented.txt"; // a square with one side pushed in
  private static final Study STUDY =
      new PolygonsStudy(
          new StudyPlan(SHAPES, List.of(10, 100), 4, 1),
          Map.of(
              PENTAGON,
              Instance.of(
                  PENTAGON,
                  SimplePolygon.of(Points.ofPairs(0, 0, 4, 0, 4, 4, 2, 1, 0, 4), Progress.NONE))));

  private static List<StudyRow> rows;

  // Not in an initializer: its threads would wait for the class whose lambda they call.
  @BeforeAll
  static void run() {
    rows = StudyRun.run(STUDY, List.of(), 2, row -> {}, Progress.NONE);
  }

  @Test
  void every_shape_size_and_file_has_its_rows() {
    assertThat(rows).hasSize(1 + SHAPES.size() * 2 * 4);
    assertThat(rows.get(0).trial()).isEqualTo(new Trial(PENTAGON, 5, 1, 0));
    assertThat(rows.stream().map(StudyRow::trial).distinct()).hasSize(rows.size());
  }

  @Test
  void a_dented_square_is_counted() {
    StudyRow row = rows.get(0);
    assertThat(row.count(PolygonsColumns.REFLEX)).isEqualTo(1);
    assertThat(row.count(PolygonsColumns.PIECES)).isEqualTo(3);
    assertThat(row.counts()).containsEntry("even_monotone", 3).containsEntry("even_best", 3);
  }

  @Test
  void the_optimum_is_proven_and_nothing_goes_beyond_it() {
    for (StudyRow row : rows) {
      int best = row.count(StudyRow.BEST);
      assertThat(row.count(StudyRow.LIMIT)).as("%s", row).isEqualTo(best);
      for (Method method : PolygonsColumns.METHODS) {
        assertThat(
                List.of(
                    row.count(PolygonsColumns.before(method)),
                    row.count(PolygonsColumns.after(method)),
                    best))
            .as("%s", row)
            .isSorted();
      }
      assertThat((row.trial().n() - best) % 2).as("%s", row).isZero();
    }
  }

  @Test
  void pieces_are_bounded_by_reflex_vertices() {
    for (StudyRow row : rows) {
      int reflex = row.count(PolygonsColumns.REFLEX);
      assertThat(row.count(PolygonsColumns.PIECES))
          .as("%s", row)
          .isBetween((reflex + 1) / 2 + 1, row.trial().n() - 2);
    }
  }

  @Test
  void convex_polygons_have_two_odd_vertices_by_partitioning_aqt() {
    rows.stream()
        .filter(row -> row.trial().shape().equals(PolygonShape.CONVEX.word()))
        .forEach(
            row -> {
              assertThat(row.count(PolygonsColumns.PIECES)).isOne();
              assertThat(row.count(PolygonsColumns.before(Method.CONVEX_EVEN)))
                  .isEqualTo(row.count(StudyRow.BEST));
            });
  }

  @Test
  void the_tables_hold_every_row() {
    List<Table> tables = STUDY.tables(rows);
    assertThat(tables.get(0).rows()).hasSize(SHAPES.size() * 2);
    for (int t : new int[] {1, 2}) {
      int polygons =
          tables.get(t).rows().stream().mapToInt(row -> Integer.parseInt(row.get(1))).sum();
      assertThat(polygons).isEqualTo(SHAPES.size() * 4);
    }
    assertThat(tables.get(3).rows()).hasSize(1);
    assertThat(tables.get(3).rows().get(0)).startsWith(PENTAGON, "5", "1", "3");
  }

  @Test
  void the_charts_have_their_words_and_means() {
    List<Chart> charts = STUDY.charts(rows);
    assertThat(charts.stream().map(Chart::word)).isEqualTo(STUDY.chartWords());
    Chart shapes = charts.get(0);
    assertThat(shapes.categories()).containsExactlyInAnyOrderElementsOf(SHAPES);
    int convex = shapes.categories().indexOf("convex");
    Chart.Series best = shapes.series().get(6);
    assertThat(best.y().get(convex)).isCloseTo(98, within(1e-9));
  }

  @Test
  void there_are_pictures_of_random_and_given_polygons() {
    for (StudyRow row : List.of(rows.get(0), rows.get(rows.size() - 1))) {
      List<StudyPicture> pictures = STUDY.pictures(row.trial(), Progress.NONE);
      int even = row.count(PolygonsColumns.after(Method.CONVEX_EVEN));
      assertThat(pictures).hasSize(3);
      assertThat(String.join(" ", pictures.get(1).scene().counts()))
          .as("%s", row)
          .contains("After: Even " + even);
    }
  }

  @Test
  void a_study_of_nothing_has_empty_tables_and_charts() {
    assertThat(STUDY.tables(List.of())).allMatch(table -> table.rows().isEmpty());
    assertThat(STUDY.charts(List.of())).hasSize(4);
  }
}
